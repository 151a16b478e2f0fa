// Draws lines on levels of resolution and counts their cost: for the mean of a level, or for the
// difference from the level below. Every level, purpose and half has its own lines.
// Ownership: one thread at a time, which distributes the work; scene and options outlive it.
// Failure: as slideRealizations.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/accuracy/levels.h"
#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One velocity of the sweep: its samples and its goal.
struct VelocityState {
  double velocity = 0;
  Halves halves{std::vector<LevelSums>(kMostLevels), std::vector<LevelSums>(kMostLevels)};
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
  std::array<std::int64_t, 4 * kMostLevels> done_{};  // lines of each stratum
  SamplingCost cost_;
  double secondsOfSources_ = 0;
};

}  // namespace asperity
