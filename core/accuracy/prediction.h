// Cost and accuracy of a friction curve, and the cost of a map of friction, predicted before the
// run. A pilot on a few lines (core/accuracy/pilot.h) gives time, spread and resolution of a curve,
// and the rest is arithmetic; the parts of the error are separate. For a map a few of its lines are
// tried. Time depends on the machine and is shown to users, but never decides what is computed.
// Threading: one thread at a time (time is measured). Failure: as frictionCurve and parameterMap;
// StopRequested.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "core/base/message.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

struct MapAxis;

/// Errors relative to mu, root mean square over the velocities of the sweep, or over the time of a
/// motion. NaN: does not apply.
struct ErrorBudget {
  double resolution = kNotApplicable;     // of the line's scheme and oversampling
  double standardError = kNotApplicable;  // from the number of realizations
  double forceBalance = kNotApplicable;   // from its tolerance
  double timeStep = kNotApplicable;       // of a march: difference from steps of half the length
  // of a march: its beginning, compared with a longer march
  double settling = kNotApplicable;
  double modelDifference = kNotApplicable;  // `nodal` minus the resolved line; not an error
  /// Whether a prediction could not judge the standard error: most lines that it tried are just in
  /// complete contact, where they have the same friction, and others may not be.
  bool isStandardErrorUnknown = false;
  /// Returns the root of the sum of squares of the errors; NaN where one of them is unknown.
  double total() const;
};

struct Prediction {
  double seconds = 0;  // wall clock, on `threads`
  int threads = 1;
  double memory = 0;  // bytes, for the lines in work and the results
  ErrorBudget error;
  // of the run; with a target: at the velocity that needs most lines
  double lines = 0;
  double simulations = 0;          // number of balances: one line at one velocity
  double steps = 0, elements = 0;  // of a motion's march; 0 for a curve
  /// Number of prepared points of lines, or for a motion of elements times steps: counted in the
  /// pilot, and in the run on one thread.
  double operations = 0, runOperations = 0;
};

/// Returns a warning where the target accuracy of the scene needs unusually many lines: with their
/// number and the time, or that they are more than a run computes. And where the standard error is
/// unknown. Else nothing.
std::optional<Message> warningOf(const Scene& scene, const Prediction& prediction);

/// Predicts `curve` for this scene. threads: 0 means as many as the machine has.
Prediction predictCurve(const Scene& scene, int threads = 0, const std::stop_token& stop = {});

/// Returns the errors of a finished run; the caller measures its time and memory. The standard
/// error comes from the run. The resolution, also of curves with a target, is measured: the
/// difference from a line with four times the points that the run used, on at most `lines` lines;
/// NaN where such a fine line needs too much memory.
ErrorBudget measureError(const Scene& scene, std::int64_t lines, int threads = 0);

struct MapCost {
  std::size_t columns = 0, rows = 0;  // cells along x and y
  /// The number of cells that have to be computed; the others equal one of them. 0: not known,
  /// because the trial used only some cells.
  std::size_t different = 0;
  double lines = 1;    // number of lines of the mean in each cell
  double seconds = 0;  // wall clock, on `threads`
  int threads = 1;
};

/// Predicts `parameterMap` for these axes from a trial: of all cells on one line or, where that
/// takes long, of some of them. Where the trial is short, all cells are also computed on a few
/// lines, which shows the part of the time that does not grow with the lines. threads: 0 means as
/// many as the machine has.
MapCost predictMap(const Scene& scene, const MapAxis& x, const MapAxis& y, int threads = 0);

}  // namespace asperity
