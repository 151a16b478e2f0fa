// How much of a scene a prediction tries out: a few lines and velocities, and of a long line a
// shorter one with the same waves, so that a pilot costs a small part of the run that it speaks of.
// All is decided by counted operations, never by a clock. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// One operation makes one point of a line ready, about 20 ns. A pilot may take a tenth of the run,
/// at least kLeastPilot (some milliseconds) and at most kMostPilot (0.1 to 0.2 s where lines are
/// long).
inline constexpr double kLeastPilot = 4e5, kMostPilot = 2e6;

/// A scene with a line that is `factor` times shorter, or a little more where the elements do not
/// divide: the same elements and waves under the same load on each length. A wedge and a parabola
/// stay as long as they are, with fewer elements. A profile is never shortened.
Scene shortened(const Scene& scene, std::int64_t factor);

/// Elements per period; of a profile whose file says it, as many as a file of its size may have.
double elementsOf(const Scene& scene);

struct PilotPlan {
  Scene scene;                     // that is tried out
  double shortening = 1;           // elements of the run over those of the pilot
  std::int64_t lines = 1;          // at the scene's own resolution
  std::int64_t refinedLines = 1;   // of those, at twice the points as well
  std::vector<double> velocities;  // m/s
  /// As many as the kernel has side by side in the run, for the time alone; empty where the pilot
  /// cannot afford them.
  std::vector<double> timedVelocities;
  double operations = 0;     // of the pilot, counted
  double runOperations = 0;  // of the run on one thread
};

/// Of a friction curve on so many threads.
PilotPlan planPilot(const Scene& scene, int threads);

/// The factor by which a line is shortened so that `operations` a point of it stay within
/// `allowed`.
std::int64_t shorteningFor(const Scene& scene, double operations, double allowed);

/// Bytes that a friction curve takes: lines in work on `threads`, what makes them, and results.
double memoryOfCurve(const Scene& scene, int threads);

}  // namespace asperity
