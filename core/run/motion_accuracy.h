// Cost and accuracy of a motion that is not steady, predicted before it is run. Time comes from
// counted steps and the measured time of one step and element. The parts of the error are measured
// as differences of friction between two marches over a short piece of the motion:
//   time step   with its steps and with steps of half the length, on the same elements
//   resolution  with its elements and with twice as many, whose steps are half as long, too
// Each is the root mean square over windows of 16 steps, relative to that of friction itself. A
// march begins in the steady state of the resolved line and not in its own, so there is a third
// part:
//   settling    the relative difference of friction between the beginning and the end of a march at
//               the first velocity, which ends when the elements have forgotten how it began
// A start from rest begins exactly and has no such error.
// Threading: one thread at a time (time is measured). Failure: as Transient; StopRequested.
#pragma once

#include <stop_token>

#include "core/accuracy/explanation.h"
#include "core/accuracy/prediction.h"
#include "core/accuracy/work_precision.h"
#include "core/scene/scene.h"

namespace asperity {

/// Predicts a scene whose sliding is not steady.
Prediction predictMotion(const Scene& scene, const std::stop_token& stop = {});

/// Returns the same differences over the whole motion.
ErrorBudget measureMotionError(const Scene& scene);

/// Adds the two errors that only a march has, in each region of a comparison, at its middle
/// velocity.
void addMarchErrors(WorkPrecision& comparison);

/// Returns predictCurve for steady sliding, predictMotion for other motions.
Prediction predictRun(const Scene& scene, int threads = 0, const std::stop_token& stop = {});

/// Do the same as explain and analyze for any scene. A motion is marched without drawing it, and
/// its time is the processor time of its thread.
Explanation explainRun(const Scene& scene, int threads = 0);
void analyzeRun(Explanation& explanation, int threads = 0);

}  // namespace asperity
