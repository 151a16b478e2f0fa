// Draws lines on levels of resolution and counts what they cost: for the mean of a level, or for
// the difference to the level below. Every level, purpose and half has lines of its own.
// Ownership: one thread at a time, which shares the work out; scene and options outlive it.
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

/// One velocity of the sweep: what was sampled, and what is wanted.
struct VelocityState {
  double velocity = 0;
  Halves halves{std::vector<LevelSums>(kMostLevels), std::vector<LevelSums>(kMostLevels)};
  std::vector<double> friction;  // of a line that is given, on levels 0, 1, ...
  CurveAverages facts;           // beside mu
  LevelPlan plan;
  /// Lines that a plan whose error came out too large needs at least; of each half, as in the plan.
  std::array<std::vector<std::int64_t>, 2> least;
  int known = 0;  // levels sampled
  bool isPlanned = false;
  bool isExhausted = false;  // no finer line, or no more lines, allowed

  LevelSums& sums(std::size_t half, int level) {
    return halves[half][static_cast<std::size_t>(level)];
  }
  /// The lines that the plan counts on a level.
  const RunningMean& sampled(std::size_t half, int level) const {
    const LevelSums& sums = halves[half][static_cast<std::size_t>(level)];
    return level == plan.first ? sums.direct : sums.correction;
  }
};
using States = std::vector<VelocityState*>;

/// Whose lines, on which level, and whether for its mean or for the difference to the one below.
struct Stratum {
  int level = 0;
  bool isDirect = true;
  std::size_t half = 0;
};

struct SamplingCost {
  double operations = 0;  // nodes passed over
  std::int64_t passes = 0, solves = 0;
  double largestResidual = 0;
};

class LevelSampler {
 public:
  /// profile: instead of that in the scene's file; it outlives the sampler.
  LevelSampler(const Scene& scene, const CurveOptions& options, const Profile* profile = nullptr);

  /// The lines of a level, 0 to levelsAllowed() - 1; finer ones would have too many nodes.
  const LineSource& source(int level);
  int levelsAllowed() const { return static_cast<int>(sources_.size()); }

  /// results[line][velocity]; false where stopped.
  bool slide(int level, const States& states, std::int64_t first, std::int64_t count,
             std::vector<std::vector<SteadyResult>>& results);

  /// Adds one result to the cost of the run; returns its operations.
  double count(const SteadyResult& result, int level);

  /// Draws lines into the sums of these velocities; false where stopped.
  bool sample(const Stratum& stratum, const States& states, std::int64_t lines);

  const SamplingCost& cost() const { return cost_; }
  /// Processor time to read, transform and hold what the lines are made of.
  double secondsOfSources() const { return secondsOfSources_; }
  std::int64_t lines() const;  // of all strata

 private:
  /// Friction and operations on a level to what is known of it.
  void add(LevelSums& sums, const SteadyResult& result, int level);

  const Scene& scene_;
  const CurveOptions& options_;
  const Profile* profile_;
  std::vector<std::unique_ptr<LineSource>> sources_;  // of each level allowed, made when needed
  std::array<std::int64_t, 4 * kMostLevels> done_{};  // lines of each stratum
  SamplingCost cost_;
  double secondsOfSources_ = 0;
};

}  // namespace asperity
