// Resolutions of one line as levels, and samples on them. The estimate of friction at one velocity
// is a sum over levels, mu = E[mu_s] + sum E[mu_l - mu_(l-1)], with independent lines for each mean
// (multilevel Monte Carlo: Giles, Operations Research 56, 607, 2008). The same realization has the
// same phases at every resolution, so the differences vary little. If s is the finest level, it is
// the plain average.
//
// A sample whose size depends on its own spread has a biased mean: friction is skewed, so samples
// with a low mean also have a low spread and stop early. Lines are therefore drawn in two halves,
// and the spread of each half determines the number of lines of the other half. The mean of the two
// means is then free of that bias to first order, and no line is drawn only for planning. Plain
// values and pure functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/friction/curve_point.h"

namespace asperity {

/// The maximum number of levels: `cubic` with 1, 2, 4, ... points per element.
inline constexpr int kMostLevels = 9;
inline std::int64_t levelOversampling(int level) {
  return std::int64_t{1} << level;
}

/// Samples at one velocity on one level, from the lines of one half.
struct LevelSums {
  RunningMean direct;      // mu of this level, from lines drawn for its mean
  RunningMean correction;  // mu minus that of the level below, same lines
  RunningMean value;       // mu of this level, from any lines: its variance
  RunningMean operations;  // nodes passed over per line on this level
};
using Halves = std::array<std::vector<LevelSums>, 2>;

/// The levels that are used at one velocity, with their numbers of lines.
struct LevelPlan {
  int first = 0, last = 0;                         // s and the finest level
  std::array<std::vector<std::int64_t>, 2> lines;  // of each half on level first, ... last
  double operations = 0;                           // nodes passed over in the whole plan
  double plainOperations = 0;                      // for plain averaging on the finest level
  double resolutionError = 0;                      // absolute error of the finest level
};

/// Minimum number of lines of each half, for the mean of a level and for the difference from the
/// level below.
inline constexpr std::int64_t kFewestDirect = 16, kFewestCorrections = 8;

/// Returns the numbers of lines with sum variance_l / n_l <= allowed and the smallest sum cost_l
/// n_l (Giles 2008, Eq. 3.1); at least fewest_l each.
std::vector<std::int64_t> optimalLines(std::span<const double> variances,
                                       std::span<const double> costs, double allowed,
                                       std::span<const std::int64_t> fewest);

/// Returns an upper estimate of |mu_level - mu_converged| for the mean over lines, level >= 1: a
/// third of its difference from the level below (second order; the cubic line's error falls as 1/16
/// once it is resolved), or a part of the spread of that difference where the mean is smaller.
double estimateResolutionError(const Halves& halves, int level);

/// Returns an upper estimate of |mu_l - mu_converged| for one line, from its friction on levels 0
/// to l >= 2: the last difference, or a quarter of the previous one where that is larger, because
/// two levels of a line may agree by chance. At second order a third of that would suffice, but
/// single lines converge irregularly: on random lines of every H with contacts of 3e-5 to 1 of
/// their length the error exceeds that third in up to 4 % of all cases, but this estimate in less
/// than 1 %.
double lineError(std::span<const double> friction);

/// Returns the plan with the least additional work with which standard error and resolution error
/// together are at most `relative` of mu (root of the sum of squares; at most 0.3 of it from the
/// resolution). Empty: a finer level must be sampled first; levels 0 to known - 1 have been
/// sampled.
std::optional<LevelPlan> planLevels(const Halves& halves, int known, double relative);

/// The mean of a plan, and its standard error.
struct LevelEstimate {
  double mean = 0, standardError = 0;
  double freedom = 0;  // degrees of freedom (Welch and Satterthwaite)
};
LevelEstimate estimateMean(const Halves& halves, const LevelPlan& plan);

/// Returns the variance of the estimate over the variance that is allowed for a total error of
/// `relative` of mu after the resolution's part: above 1 more lines are needed.
double excessVariance(const Halves& halves, const LevelPlan& plan, double relative);

}  // namespace asperity
