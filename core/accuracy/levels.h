// Resolutions of one line as levels, and what was sampled on them: the estimate of friction at one
// velocity as a sum over levels, mu = E[mu_s] + sum E[mu_l - mu_(l-1)], each mean from lines of its
// own (multilevel Monte Carlo: Giles, Operations Research 56, 607, 2008). The same realization has
// the same phases at every resolution, so the differences vary little. With s the finest level it
// is the plain average. Plain values and pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/friction/running_mean.h"

namespace asperity {

/// `cubic` with 1, 2, 4, ... points per element.
inline constexpr int kMostLevels = 6;
inline std::int64_t oversamplingOf(int level) {
  return std::int64_t{1} << level;
}

/// What is known of one velocity on one level.
struct LevelSums {
  RunningMean direct;      // mu of this level, from lines drawn for its mean
  RunningMean correction;  // mu less that of the level below, same lines
  RunningMean value;       // mu of this level, from whatever lines: its variance
  RunningMean operations;  // nodes passed over to solve one line on this level
};

/// How the levels of one velocity are used.
struct LevelPlan {
  int first = 0, last = 0;          // s and the finest
  std::vector<std::int64_t> lines;  // of level first, first + 1, ... last
  double operations = 0;            // of the plan, counted
  double plainOperations = 0;       // of plain averaging on the finest level
  double resolutionError = 0;       // absolute, of the finest level
};

/// Numbers of lines with sum variance_l / n_l <= allowed at the least sum cost_l n_l (Giles 2008,
/// Eq. 3.1); at least `fewest` each.
std::vector<std::int64_t> optimalLines(std::span<const double> variances,
                                       std::span<const double> costs, double allowed,
                                       std::int64_t fewest);

/// Upper estimate of |mu_level - mu_converged|, from the correction one level up: differences fall
/// at least as 1/4 (second order; the cubic line's fall as 1/16 once it is resolved). Empty where
/// that level was not sampled.
std::optional<double> resolutionErrorOf(std::span<const LevelSums> levels, int level);

/// The cheapest plan whose standard error and resolution error together meet `error` (absolute,
/// root of the sum of squares; at most half of it from the resolution). Empty: a finer level has to
/// be sampled first. Levels 0 to known - 1 were.
std::optional<LevelPlan> planLevels(std::span<const LevelSums> levels, int known, double error);

/// The mean over a plan and its standard error.
struct LevelEstimate {
  double mean = 0, standardError = 0;
  double freedom = 0;  // degrees of freedom (Welch and Satterthwaite)
};
LevelEstimate estimateOf(std::span<const LevelSums> levels, const LevelPlan& plan);

/// Quantile 0.975 of Student's distribution (Abramowitz and Stegun, 26.7.5); freedom of 3 or more.
double studentQuantile(double freedom);

}  // namespace asperity
