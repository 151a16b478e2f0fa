// The friction curve of a scene to a target accuracy at least cost: at every velocity of the sweep
// the standard error over random lines and the resolution error of the line together are to be at
// most `accuracy.target_relative_error` of mu. Resolution and number of lines are chosen for each
// velocity from the first lines, by counted operations and never by a clock: the same scene gives
// the same bytes. A line that is given is refined until its last differences say that it is
// resolved. Without friction nothing is to be reached.
// Threading, failure: as frictionCurve.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/accuracy/levels.h"
#include "core/friction/ensemble.h"
#include "core/surface/profile_file.h"

namespace asperity {

/// What was achieved at one velocity.
struct AchievedAccuracy {
  double standardError = 0;       // of mu, absolute
  double resolutionError = 0;     // of mu, absolute, an upper estimate
  double low = 0, high = 0;       // 95 % confidence interval of mu, both parts together
  std::int64_t oversampling = 1;  // of the finest level
  std::int64_t coarsest = 1;      // of the coarsest: equal for plain averaging
  std::int64_t lines = 1;
};

struct TargetCurve {
  Curve curve;
  std::vector<AchievedAccuracy> achieved;  // for each point
  bool isReached = false;  // at every velocity; else more lines or memory than allowed were needed
  double worst = 0;        // largest relative error achieved
  double operations = 0;   // nodes passed over, pilot included
  double plainOperations = 0;  // predicted for plain averaging on the finest level, without pilot
};

/// scene.accuracy.targetRelativeError > 0; its scheme and oversampling are not used.
TargetCurve targetCurve(const Scene& scene, const CurveOptions& options = {});

/// What the pilot of a target curve says of the whole run.
struct TargetPlan {
  double operations = 0;          // nodes passed over after the pilot
  double secondsOfPilot = 0;      // processor time
  double secondsOfSources = 0;    // of it, that any number of velocities needs once
  double secondsOfOperation = 0;  // measured in the pilot; for people only
  double mostLines = 0;           // at the velocity that needs most
  double simulations = 0;
  std::int64_t finest = 1;  // points per element of the finest line
  /// Relative, root mean square over velocities; without friction not applicable.
  double standardError = kNotApplicable, resolutionError = kNotApplicable;
  double largestResidual = 0;
};

/// profile: instead of that in the scene's file.
TargetPlan planTarget(const Scene& scene, const std::stop_token& stop = {},
                      const Profile* profile = nullptr);

/// Lines of the pilot, and how many a run may use at one velocity and level.
inline constexpr std::int64_t kPilotLines = 2 * kFewestDirect, kMostLines = 1000000;

/// An elastic body dissipates nothing: its friction is rounding, and an error relative to it has no
/// meaning. A curve to a target then states an interval about 0.
bool isFrictionless(const Scene& scene);

}  // namespace asperity
