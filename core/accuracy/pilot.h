// How much of a scene a prediction tries out: a few lines and velocities, and of a long line a
// shorter one with the same waves, so that a pilot costs a small part of the run that it speaks of.
// Of a long profile the pilot reads the first rows of the file; the error of so short a line is an
// upper estimate where the long one averages over many summits. All is decided by counted
// operations, never by a clock. Pure functions but for the files of profiles; any thread.
// Failure: InputError (unreadable profile).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One operation makes one point of a line ready, about 20 ns. A pilot may take a tenth of the run,
/// at least kLeastPilot (half a millisecond) and at most kMostPilot (0.1 to 0.2 s where lines are
/// long).
inline constexpr double kLeastPilot = 2.5e4, kMostPilot = 2e6;

/// A scene whose line may be shorter than that of the run.
struct PilotScene {
  Scene scene;            // with the length and the elements that a profile's file may leave open
  std::int64_t rows = 0;  // that are read from the beginning of a profile's file; 0: no profile
  std::int64_t rowsOfFile = 0;
  std::int64_t lines = 1;  // that the scene's means are over

  /// The run's own line, with what `extent` says of it.
  PilotScene(const Scene& its, const LineExtent& extent);

  /// Elements per period.
  double elements() const { return static_cast<double>(scene.surface.elements); }
  /// Operations to make one line ready and to do `perPoint` more at each of its points, `points` to
  /// an element.
  double operations(double perPoint, double points) const;
  /// What is read of the profile; a part of it less the straight line through its ends, so that the
  /// period closes. Null: no profile.
  std::unique_ptr<const Profile> profile() const;
};

/// The scene with a line that is `factor` times shorter, or a little more where the elements do not
/// divide: the same elements and waves under the same load on each length. A wedge and a parabola
/// stay as long as they are, with fewer elements.
PilotScene shortened(const PilotScene& whole, std::int64_t factor);

struct PilotPlan {
  PilotScene run;                    // that is predicted
  PilotScene sample;                 // that is tried out
  double shortening = 1;             // elements of the run over those of the pilot
  std::int64_t lines = 1;            // at the scene's own resolution
  std::int64_t refinedLines = 1;     // of those, at twice the points as well
  std::vector<double> velocities{};  // m/s
  /// As many as the kernel has side by side in the run, for the time alone; empty where the pilot
  /// cannot afford them.
  std::vector<double> timedVelocities{};
  double operations = 0;     // of the pilot, counted
  double runOperations = 0;  // of the run on one thread
};

/// Of a friction curve on so many threads.
PilotPlan planPilot(const Scene& scene, int threads);

/// The longest sample of the scene for which `perPoint` operations a point, `points` to an element,
/// stay within `allowed`.
PilotScene sampleWithin(const PilotScene& whole, double perPoint, double points, double allowed);

/// Bytes that a friction curve takes: lines in work on `threads`, what makes them, and results.
/// finest: points to an element of the finest line.
double memoryOfCurve(const PilotScene& run, int threads, std::int64_t finest);

}  // namespace asperity
