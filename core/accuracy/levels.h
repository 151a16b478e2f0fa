// Resolutions of one line as levels, and what was sampled on them: the estimate of friction at one
// velocity as a sum over levels, mu = E[mu_s] + sum E[mu_l - mu_(l-1)], each mean from lines of its
// own (multilevel Monte Carlo: Giles, Operations Research 56, 607, 2008). The same realization has
// the same phases at every resolution, so the differences vary little. With s the finest level it
// is the plain average.
//
// A sample that is stopped by its own spread has a biased mean: friction is skewed, so samples with
// a low mean also have a low spread and stop early. Lines are therefore drawn in two halves, and
// the spread of each half decides how many lines the other one gets. The mean of the two means is
// then free of that bias to first order, and no line is drawn for planning alone.
// Plain values and pure functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/friction/curve_point.h"

namespace asperity {

/// `cubic` with 1, 2, 4, ... points per element.
inline constexpr int kMostLevels = 9;
inline std::int64_t oversamplingOf(int level) {
  return std::int64_t{1} << level;
}

/// What is known of one velocity on one level, from the lines of one half.
struct LevelSums {
  RunningMean direct;      // mu of this level, from lines drawn for its mean
  RunningMean correction;  // mu less that of the level below, same lines
  RunningMean value;       // mu of this level, from whatever lines: its variance
  RunningMean operations;  // nodes passed over to solve one line on this level
};
using Halves = std::array<std::vector<LevelSums>, 2>;
inline constexpr std::size_t otherHalf(std::size_t half) {
  return 1 - half;
}

/// How the levels of one velocity are used.
struct LevelPlan {
  int first = 0, last = 0;                         // s and the finest
  std::array<std::vector<std::int64_t>, 2> lines;  // of each half on level first, ... last
  double operations = 0;                           // of the plan, counted
  double plainOperations = 0;                      // of plain averaging on the finest level
  double resolutionError = 0;                      // absolute, of the finest level
};

/// Fewest lines of each half, for the mean of a level and for the difference to the one below.
inline constexpr std::int64_t kFewestDirect = 16, kFewestCorrections = 8;

/// Numbers of lines with sum variance_l / n_l <= allowed at the least sum cost_l n_l (Giles 2008,
/// Eq. 3.1); at least fewest_l each.
std::vector<std::int64_t> optimalLines(std::span<const double> variances,
                                       std::span<const double> costs, double allowed,
                                       std::span<const std::int64_t> fewest);

/// Upper estimate of |mu_level - mu_converged| of the mean over lines, level >= 1: a third of its
/// difference to the level below (second order; the cubic line's falls as 1/16 once it is
/// resolved), or of a part of the spread of that difference where the mean is less.
double resolutionErrorOf(const Halves& halves, int level);

/// Upper estimate of |mu_l - mu_converged| of one line, from its friction on levels 0 to l >= 2:
/// the last difference, or a quarter of the one before where that is more, because two levels of a
/// line may agree by chance. At second order a third of that would do, but single lines converge
/// irregularly: on random lines of every H with contacts of 3e-5 to 1 of their length the error
/// lies above that third in up to 4 % of all cases, above this estimate in less than 1 %.
double lineError(std::span<const double> friction);

/// The plan that needs least work beyond the lines that are there so that standard error and
/// resolution error together are at most `relative` of mu (root of the sum of squares; at most 0.3
/// of it from the resolution). Empty: a finer level has to be sampled first. Levels 0 to known - 1
/// were.
std::optional<LevelPlan> planLevels(const Halves& halves, int known, double relative);

/// The mean over a plan and its standard error.
struct LevelEstimate {
  double mean = 0, standardError = 0;
  double freedom = 0;  // degrees of freedom (Welch and Satterthwaite)
};
LevelEstimate estimateOf(const Halves& halves, const LevelPlan& plan);

/// Variance of the estimate over that which the resolution leaves of an error of `relative` of mu:
/// above 1 more lines are needed.
double excessVariance(const Halves& halves, const LevelPlan& plan, double relative);

/// Quantile 0.975 of Student's distribution (Abramowitz and Stegun, 26.7.5); freedom of 3 or more.
double studentQuantile(double freedom);

}  // namespace asperity
