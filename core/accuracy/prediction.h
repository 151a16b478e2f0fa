// What a friction curve will cost and how good it will be, said before it is run: a pilot on a few
// lines (core/accuracy/pilot.h) gives time, spread and resolution, and the rest is arithmetic. The
// parts of the error are told apart. Time depends on the machine and is for people; nothing is
// decided by it. Threading: one thread at a time (time is measured). Failure: as frictionCurve;
// StudyStopped.
#pragma once

#include <cstdint>
#include <stop_token>

#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// Relative to mu, root mean square over the velocities of the sweep, or over the time of a motion.
/// NaN: does not apply.
struct ErrorBudget {
  double resolution = kNotApplicable;       // of the line: scheme and oversampling
  double standardError = kNotApplicable;    // realizations
  double forceBalance = kNotApplicable;     // its tolerance
  double timeStep = kNotApplicable;         // of a march: against steps of half the length
  double settling = kNotApplicable;         // of a march: at its beginning, against a longer one
  double modelDifference = kNotApplicable;  // `nodal` against the resolved line: not an error
  /// Root of the sum of squares of those that are errors.
  double total() const;
};

struct Prediction {
  double seconds = 0;  // wall clock, on `threads`
  int threads = 1;
  double memory = 0;  // bytes, of the lines in work and the results
  ErrorBudget error;
  double lines = 0;                // of the run; with a target: at the velocity that needs most
  double simulations = 0;          // a line, a velocity, a balance
  double steps = 0, elements = 0;  // of a motion's march; 0 of a curve
  std::int64_t pilotLines = 0;
  /// Points of lines made ready, or of a motion elements marched by a step: of the pilot, counted,
  /// and of the run on one thread.
  double operations = 0, runOperations = 0;
};

/// For `curve` of this scene. threads: 0 for as many as the machine has.
Prediction predictCurve(const Scene& scene, int threads = 0, const std::stop_token& stop = {});

/// The same numbers of a finished run: its time and memory are the caller's. The standard error is
/// read from the run. The resolution, of curves to a target as well, is measured: the difference to
/// a line of four times the points that the run used, on at most `lines` lines; NaN where so fine a
/// line needs too much memory.
ErrorBudget measureError(const Scene& scene, std::int64_t lines, int threads = 0);

}  // namespace asperity
