// The motion of the line: exact velocity and position at any time, through rest and backwards.
// Plain value; any thread. The motion begins at time 0; after its duration it continues with the
// last velocity, and an oscillation continues forever.
#pragma once

#include <cstdint>

#include "core/scene/scene.h"

namespace asperity {

class Motion {
 public:
  /// The fewest steps in which a motion is marched, and those in a period of an oscillation.
  static constexpr int kMinSteps = 500, kStepsOfPeriod = 64;

  explicit Motion(const Sliding& sliding) : sliding_(sliding) {}

  /// Returns the velocity at a time (s), m/s; at a jump the one after it.
  double velocityAt(double time) const;
  /// Returns the distance slid since time 0, m.
  double distanceAt(double time) const;
  /// Returns the largest magnitude of the velocity between two times, m/s.
  double fastest(double from, double to) const;

  /// Returns the time at which the velocity jumps, s, or the duration if it does not.
  double jump() const;
  double duration() const { return sliding_.duration; }
  /// Returns the longest step of a march that takes at least this many for the duration, s.
  double longestStep(std::int64_t leastSteps = kMinSteps) const;
  /// Returns the step at a time (s) on a line with this distance between nodes (m), s: no longer
  /// than the longest one. At a constant velocity it is a node or an integer fraction of one, so
  /// that elements meet the line's nodes always at the same places: other steps cause beats.
  double stepAt(double time, double spacing, double longest) const;
  /// Returns whether the velocity changes continuously.
  bool isSmooth() const { return sliding_.kind == SlidingKind::Oscillation; }

 private:
  bool jumps() const;
  double secondVelocity() const;

  Sliding sliding_;
};

}  // namespace asperity
