// Draws lines on levels of resolution and counts what they cost: for the mean of a level, or for
// the difference to the level below. Every level and purpose has lines of its own.
// Ownership: one thread at a time, which shares the work out; scene and options outlive it.
// Failure: as slideRealizations.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/accuracy/levels.h"
#include "core/friction/curve_averages.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One velocity of the sweep: what was sampled, and what is wanted.
struct VelocityState {
  double velocity = 0;
  std::vector<LevelSums> levels = std::vector<LevelSums>(kMostLevels);
  CurveAverages facts;  // beside mu
  LevelPlan plan;
  int known = 0;  // levels sampled
  bool isPlanned = false;
  bool isExhausted = false;  // no finer line, or no more lines, allowed
};
using States = std::vector<VelocityState*>;

struct SamplingCost {
  double operations = 0;  // nodes passed over
  std::int64_t passes = 0, solves = 0;
  double largestResidual = 0;
};

class LevelSampler {
 public:
  LevelSampler(const Scene& scene, const CurveOptions& options);

  /// The lines of a level, 0 to levelsAllowed() - 1; finer ones would have too many nodes.
  const LineSource& source(int level);
  int levelsAllowed() const { return static_cast<int>(sources_.size()); }

  /// results[line][velocity]; false where stopped.
  bool slide(int level, const States& states, std::int64_t first, std::int64_t count,
             std::vector<std::vector<SteadyResult>>& results);

  /// What one result cost, and its mu, to the sums of its level.
  void count(LevelSums& sums, const SteadyResult& result, int level);

  /// Lines for the mean of a level, into the sums of these velocities; false where stopped.
  bool sampleDirect(int level, const States& states, std::int64_t lines);

  /// Lines for the difference to the level below; likewise.
  bool sampleCorrection(int level, const States& states, std::int64_t lines);

  const SamplingCost& cost() const { return cost_; }

 private:
  const Scene& scene_;
  const CurveOptions& options_;
  std::vector<std::unique_ptr<LineSource>> sources_;  // of each level allowed, made when needed
  std::array<std::int64_t, kMostLevels> directDone_{}, correctionDone_{};
  SamplingCost cost_;
};

}  // namespace asperity
