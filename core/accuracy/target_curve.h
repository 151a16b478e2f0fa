// The friction curve of a scene with a target accuracy at the lowest cost: at every velocity of the
// sweep the standard error over random lines and the resolution error of the line together are at
// most `accuracy.target_relative_error` of mu. Resolution and number of lines are chosen for each
// velocity from the first lines, by counted operations and never by a clock: the same scene gives
// the same bytes. A given line is refined until its last differences show that it is resolved.
// Without friction there is no target.
// Threading, failure: as frictionCurve.
#pragma once

#include <cstdint>
#include <vector>

#include "core/accuracy/levels.h"
#include "core/friction/ensemble.h"
#include "core/surface/profile_file.h"

namespace asperity {

/// The accuracy achieved at one velocity.
struct AchievedAccuracy {
  double standardError = 0;       // of mu, absolute
  double resolutionError = 0;     // absolute error of mu, an upper estimate
  double low = 0, high = 0;       // 95 % confidence interval of mu, both errors together
  std::int64_t oversampling = 1;  // of the finest level
  std::int64_t lines = 1;
};

struct TargetCurve {
  /// Its target is not met where more lines or memory than allowed would be needed.
  Curve curve;
  std::vector<AchievedAccuracy> achieved;  // for each point
  double operations = 0;                   // nodes passed over, pilot included
  double plainOperations = 0;  // predicted for plain averaging on the finest level, without pilot
};

/// Computes the curve. scene.accuracy.targetRelativeError > 0; its scheme and oversampling are not
/// used.
TargetCurve targetCurve(const Scene& scene, const CurveOptions& options = {});

/// The whole run of a target curve as predicted from its pilot.
struct TargetPlan {
  double operations = 0;          // nodes passed over after the pilot
  double secondsOfPilot = 0;      // processor time
  double secondsOfSources = 0;    // part of it that is needed once for any number of velocities
  double secondsOfRows = 0;       // to find the error of the mean over all rows of a topography
  double secondsOfOperation = 0;  // measured in the pilot; shown to users only
  double mostLines = 0;           // at the velocity that needs most lines
  double simulations = 0;
  std::int64_t finest = 1;  // points per element of the finest line
  /// Relative errors, root mean square over velocities; not applicable without friction.
  double standardError = kNotApplicable, resolutionError = kNotApplicable;
  double largestResidual = 0;
};

/// Runs the pilot and predicts the run. profile: replaces that in the scene's file.
TargetPlan planTarget(const Scene& scene, const std::stop_token& stop = {},
                      const Profile* profile = nullptr);

/// The maximum number of lines at one velocity and level in a run.
inline constexpr std::int64_t kMaxLines = 1000000;

/// Returns whether the body is elastic and dissipates nothing: its friction is a rounding error,
/// and an error relative to it has no meaning. A curve with a target then has an interval around 0.
bool isFrictionless(const Scene& scene);

}  // namespace asperity
