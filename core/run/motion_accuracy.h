// Cost and accuracy of a motion that is not steady, predicted before it is run. Time
// comes from counted steps and the measured time of one step and element. The parts of the error
// are measured differences on a short piece of the motion, with its steps as they are:
//   time step   against steps of half the length, on the same elements
//   resolution  against twice the elements, whose steps are half as long, too
//   settling    friction at the beginning against that after sliding on at the first velocity until
//               what the elements remember is forgotten: the march begins in the steady state of
//               the resolved line, not in its own. Not of a start from rest, which begins exactly
// Each is the root mean square over windows of 16 steps of the difference in friction, relative to
// that of friction itself.
// Threading: one thread at a time (time is measured). Failure: as Transient; StopRequested.
#pragma once

#include <cstdint>
#include <stop_token>

#include "core/accuracy/explanation.h"
#include "core/accuracy/prediction.h"
#include "core/accuracy/work_precision.h"
#include "core/scene/scene.h"

namespace asperity {

/// Predicts a scene whose sliding is not steady.
Prediction predictMotion(const Scene& scene, const std::stop_token& stop = {});

/// Returns the same differences over the whole motion.
ErrorBudget measureMotionError(const Scene& scene, const std::stop_token& stop = {});

/// Adds the two errors that only a march has, in each region of a comparison, at its middle
/// velocity.
void addMarchErrors(WorkPrecision& comparison, const std::stop_token& stop = {});

/// Returns predictCurve for steady sliding, predictMotion for other motions.
Prediction predictRun(const Scene& scene, int threads = 0, const std::stop_token& stop = {});

/// Explain and analyze any scene. A motion is marched without drawing it, and its time is that of
/// its thread's processor.
Explanation explainRun(const Scene& scene, int threads = 0);
void analyzeRun(Explanation& explanation, int threads = 0);

}  // namespace asperity
