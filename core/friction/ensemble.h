// The friction curve of a scene: every velocity of the sweep on every realization of the line,
// averaged. Realizations run on all threads; they are summed in their own order, so the result has
// the same bits for any number of threads.
// Failure: InputError for a scene that cannot run; std::runtime_error where a force balance is not
// met. Cancelling takes effect inside a pass, or after the line that is being made.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"
#include "core/scene/sweep.h"

namespace asperity {

struct CurveProgress {
  std::int64_t realizationsDone = 0;
  std::int64_t realizationsTotal = 0;
  const std::vector<CurvePoint>& points;  // averaged over the realizations done
};

struct CurveOptions {
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop{};
  std::function<void(const CurveProgress&)> progress{};  // from one thread at a time; may be empty
  /// Called with the results of each realization at the velocities of the sweep, in their order,
  /// from one thread; may be empty. A curve to a target accuracy, whose lines differ from velocity
  /// to velocity, does not call it.
  std::function<void(std::int64_t realization, std::span<const SteadyResult>)> eachLine{};
  /// Computes a curve over linearly spaced velocities also at those of `logVelocitiesBeside`.
  bool addsLogVelocities = false;
};

struct Curve {
  std::vector<CurvePoint> points;
  bool isComplete = false;      // false: cancelled, and the points are those of the finished part
  double largestResidual = 0;   // of all force balances
  double meanPasses = 0;        // passes over the line per force balance
  double marginalFraction = 0;  // nodal: part of the solutions with a partly loaded element
  /// With a target: the largest relative error of all velocities, and whether it meets the target.
  double achievedError = kNotApplicable;
  bool isTargetMet = true;
  /// The relative error of the mean over all rows of a topography, which more lines do not lower;
  /// the largest of all velocities.
  double errorOfRows = 0;
};

/// Returns as many velocities (m/s) as a sweep over velocity has, evenly spaced in their logarithm,
/// where its own are evenly spaced: below the second of these friction may change over decades
/// without a point. Empty for other sweeps.
std::vector<double> logVelocitiesBeside(const Sweep& sweep);

/// Returns the velocities (m/s) of a curve over velocity, ascending.
std::vector<double> velocitiesOfCurve(const Sweep& sweep, const CurveOptions& options);

/// Computes the curve over velocity with the number of lines that the scene states.
/// core/accuracy/compute_curve.h computes curves with a target accuracy or over another key, too.
Curve frictionCurve(const Scene& scene, const CurveOptions& options = {});

/// Returns the plan of the scene (planStages) with one of its lines made. Only then is it known
/// whether contact is complete and the search for its edges is left out. It costs a line and a few
/// passes. Failure: as SteadySolver and LineSource.
std::vector<PlanStage> planOnLine(const Scene& scene, Purpose purpose);

}  // namespace asperity
