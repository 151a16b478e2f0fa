// How the line moves: velocity and place at any time, exactly, through rest and backwards.
// Plain value; any thread. Time 0 is where the motion begins; after its duration a motion goes on
// as it was last, an oscillation for ever.
#pragma once

#include "core/scene/scene.h"

namespace asperity {

class Motion {
 public:
  explicit Motion(const Sliding& sliding) : sliding_(sliding) {}

  /// m/s, at a time (s); at a jump that after it.
  double velocityAt(double time) const;
  /// m, slid from time 0 on.
  double distanceAt(double time) const;
  /// m/s, largest magnitude from one time to another.
  double fastest(double from, double to) const;

  /// s, where the velocity jumps, or the duration where it does not.
  double jump() const;
  double duration() const { return sliding_.duration; }
  /// Whether the velocity changes all the time.
  bool isSmooth() const { return sliding_.kind == SlidingKind::Oscillation; }

 private:
  bool jumps() const;
  double secondVelocity() const;

  Sliding sliding_;
};

}  // namespace asperity
