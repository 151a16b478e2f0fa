// Resolutions of one line as levels, and samples on them. The estimate of friction at one velocity
// is a sum over levels, mu = E[mu_s] + sum E[mu_l - mu_(l-1)], with independent lines for each mean
// (multilevel Monte Carlo: Giles, Operations Research 56, 607, 2008). The same realization has the
// same phases at every resolution, so the differences vary little. If s is the finest level, it is
// the plain average.
//
// A sample whose size depends on its own spread has a biased mean: friction is skewed, so samples
// with a low mean also have a low spread and stop early. Lines are therefore drawn in two halves,
// and the spread of each half determines the number of lines of the other half. The mean of the two
// means is then free of that bias to first order, and no line is drawn only for planning.
// LevelSampler slides the lines; the others are plain values and pure functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/friction/line_mean.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

/// The maximum number of levels: `cubic` with 1, 2, 4, ... points per element.
inline constexpr int kMaxLevels = 9;
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
  int first = 0, last = 0;                           // s and the finest level
  std::array<std::vector<std::int64_t>, 2> lines{};  // of each half on level first, ... last
  double operations = 0;                             // nodes passed over in the whole plan
  double plainOperations = 0;                        // for plain averaging on the finest level
  double resolutionError = 0;                        // absolute error of the finest level
};

/// Minimum number of lines of each half, for the mean of a level and for the difference from the
/// level below.
inline constexpr std::int64_t kMinDirect = 16, kMinCorrections = 8;

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
  double degreesOfFreedom = 0;  // by Welch and Satterthwaite
};
LevelEstimate estimateMean(const Halves& halves, const LevelPlan& plan);

/// Returns the variance of the estimate over the variance that is allowed for a total error of
/// `relative` of mu after the resolution's part: above 1 more lines are needed.
double excessVariance(const Halves& halves, const LevelPlan& plan, double relative);

/// One velocity of the sweep: its samples and its goal.
struct VelocityState {
  double velocity = 0;
  Halves halves{std::vector<LevelSums>(kMaxLevels), std::vector<LevelSums>(kMaxLevels)};
  std::vector<double> friction;  // of the scene's only line, on levels 0, 1, ...
  CurveAverages facts;           // averages of all columns but mu
  LevelPlan plan;
  /// Minimum numbers of lines in the next plan, because the error of the last one was too large; of
  /// each half, as in the plan.
  std::array<std::vector<std::int64_t>, 2> least;
  /// The error of the mean over all rows of a topography as that of its surface, relative to it: no
  /// number of rows drawn makes it smaller. 0 for random lines.
  MeanError ofRows{0, 1};
  int known = 0;  // number of sampled levels
  bool isPlanned = false;
  bool isExhausted = false;  // no finer line, or no more lines, are allowed

  LevelSums& sums(std::size_t half, int level) {
    return halves[half][static_cast<std::size_t>(level)];
  }
  /// Returns the lines that the plan counts on a level.
  const RunningMean& sampled(std::size_t half, int level) const {
    const LevelSums& sums = halves[half][static_cast<std::size_t>(level)];
    return level == plan.first ? sums.direct : sums.correction;
  }
};
using States = std::vector<VelocityState*>;

/// A group of lines: the half, the level, and whether they are for its mean or for the difference
/// from the level below.
struct Stratum {
  int level = 0;
  bool isDirect = true;
  std::size_t half = 0;
};

struct SamplingCost {
  double operations = 0;  // number of nodes passed over
  std::int64_t passes = 0, solves = 0;
  double largestResidual = 0;
};

class LevelSampler {
 public:
  /// profile: replaces that in the scene's file; it outlives the sampler.
  LevelSampler(const Scene& scene, const CurveOptions& options, const Profile* profile = nullptr);

  /// Returns the lines of a level, 0 to levelsAllowed() - 1; finer ones would have too many nodes.
  const LineSource& source(int level);
  int levelsAllowed() const { return static_cast<int>(sources_.size()); }

  /// Computes results[line][velocity]; returns false where stopped.
  bool slide(int level, const States& states, std::int64_t first, std::int64_t count,
             std::vector<std::vector<SteadyResult>>& results);

  /// Adds the cost of one result to that of the run; returns its operations.
  double count(const SteadyResult& result, int level);

  /// Draws lines and adds them to the sums of these velocities; returns false where stopped.
  bool sample(const Stratum& stratum, const States& states, std::int64_t lines);

  const SamplingCost& cost() const { return cost_; }
  /// Returns the processor time to read, transform and store the sources of the lines.
  double secondsOfSources() const { return secondsOfSources_; }
  std::int64_t lines() const;  // of all strata

 private:
  /// Adds friction and operations on a level to its sums.
  void add(LevelSums& sums, const SteadyResult& result, int level);

  const Scene& scene_;
  const CurveOptions& options_;
  const Profile* profile_;
  // [level], each made when it is needed
  std::vector<std::unique_ptr<LineSource>> sources_;
  std::array<std::int64_t, 4 * kMaxLevels> done_{};  // lines of each stratum
  SamplingCost cost_;
  double secondsOfSources_ = 0;
};

// ---- The error that a mean over the rows of a topography has as the mean of its surface. Rows
// that are drawn with replacement are independent, but the surface has only these rows: no number
// of draws makes this error smaller. The rows are slid as the coarsest lines.
/// Returns the error of all rows at each velocity, relative to their mean; nothing where stopped.
std::vector<MeanError> errorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                    int threads, const std::stop_token& stop);

struct PredictedRowErrors {
  std::vector<double> standardErrors;  // at each velocity, relative to the mean
  double seconds = 0;                  // of the processor, that all rows would take
};

/// Judges the same by some pairs of rows. Throws StopRequested.
PredictedRowErrors predictErrorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                       const std::stop_token& stop);

}  // namespace asperity
