// The pilot of a prediction: a few lines and velocities, and for a long line a shorter one with the
// same waves, so that it costs a small part of the run. For a long profile it reads the first rows
// of the file; the error of such a short line is an upper estimate if the long line averages over
// many summits. Everything is decided by counted operations, never by a clock. Pure functions
// except for reading profiles; any thread.
// Failure: InputError (unreadable profile).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One operation prepares one point of a line, about 20 ns. A pilot may take a tenth of the run, at
/// least kShortPilot (half a millisecond) and at most kMaxPilot (0.1 to 0.2 s for long lines). The
/// smallest one (four lines at three velocities) may take kMinPilot (5 ms) before it is tried on a
/// shorter line.
inline constexpr double kShortPilot = 2.5e4, kMinPilot = 2.5e5, kMaxPilot = 2e6;

/// A scene whose line may be shorter than the run's line.
struct PilotScene {
  Scene scene;            // with length and elements, which a scene may leave to a profile's file
  std::int64_t rows = 0;  // rows to read from the beginning of a profile's file; 0: no profile
  std::int64_t rowsOfFile = 0;
  std::int64_t lines = 1;  // number of lines of the scene's means

  /// Makes the run's own line, with the size in `extent`.
  PilotScene(const Scene& runScene, const LineExtent& extent);

  /// Returns the number of elements per period.
  double elements() const { return static_cast<double>(scene.surface.elements); }
  /// Returns the operations to prepare one line and do `perPoint` more at each of its points;
  /// `points`: number of points per element.
  double operations(double perPoint, double points) const;
  /// Returns the part of the profile that is read, minus the straight line through its ends, so
  /// that the period closes. Null: no profile.
  std::unique_ptr<const Profile> profile() const;
};

/// Returns the scene with a line that is `factor` times shorter, or a little longer where the
/// number of elements is not divisible: the same elements and waves under the same load per length.
/// A wedge and a parabola keep their length and get fewer elements.
PilotScene shortened(const PilotScene& whole, std::int64_t factor);

struct PilotPlan {
  PilotScene run;          // the predicted run
  PilotScene sample;       // the scene that is tried
  double shortening = 1;   // elements of the run over those of the pilot
  std::int64_t lines = 1;  // at the scene's own resolution
  // number of these lines that are also made with twice the points
  std::int64_t refinedLines = 1;
  std::vector<double> velocities{};  // m/s
  /// As many velocities as the run's kernel computes side by side, to measure time only; empty
  /// where the pilot cannot afford them.
  std::vector<double> timedVelocities{};
  double operations = 0;     // of the pilot
  double runOperations = 0;  // of the run on one thread
};

/// Plans the pilot of a friction curve on this many threads.
PilotPlan planPilot(const Scene& scene, int threads);

/// Returns the numbers of `count` of a scene's lines: the first ones, or where these are rows of a
/// topography pairs of neighbours that are spread over all of it.
std::vector<std::int64_t> sampledLines(const LineSource& source, std::int64_t count);

/// Returns the variance of the mean over `lines` lines, judged by the values of some of them
/// (sampledLines). The lines of a topography are all its rows in order, and at least four of them
/// are judged by: they are taken for a process whose correlation falls by the same factor r from
/// row to row, and their mean has (1 + r) / (1 - r) times the variance of that of independent rows
/// (Priestley, Spectral Analysis and Time Series, 1981, Section 5.3.2), at most that of one row.
double varianceOfMean(const std::vector<double>& values, const LineSource& source, double lines);

/// Returns the longest sample of the scene for which `perPoint` operations per point, with `points`
/// per element, are at most `allowed`.
PilotScene sampleWithin(const PilotScene& whole, double perPoint, double points, double allowed);

/// Returns the memory in bytes of a friction curve: lines in work on `threads`, their sources, and
/// results. finest: points per element of the finest line.
double curveMemory(const PilotScene& run, int threads, std::int64_t finest);

}  // namespace asperity
