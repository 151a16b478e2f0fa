// The random lines of a scene slid one after another, and the friction curve made of them: every
// velocity of the sweep on every realization of the line, averaged.
//
// Threading: realizations run on all threads; their results are handed over one realization after
// another in their own order, so sums of them have the same bits for any number of threads.
//
// Failure: InputError for a scene that cannot run; std::runtime_error where a force balance is not
// met, which names the velocity and the realization. Cancelling takes effect inside a pass, or
// after the line that is being made.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/friction/curve_point.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"
#include "core/scene/sweep.h"
#include "core/surface/line_source.h"

namespace asperity {

// ---- Every load and velocity on every realization of a scene's line: the work behind friction
// curves and the paper's figures. Each line is made once. The first realization comes alone; the
// balances of all others start from its depths.

/// One load and its sliding velocities.
struct LoadCase {
  Load load;
  std::vector<double> velocities;  // m/s, ascending
};

/// Returns the case of a constant normal force (N).
inline LoadCase atForce(double normalForce, std::vector<double> velocities) {
  return {{LoadKind::Force, normalForce, 0}, std::move(velocities)};
}

/// What slides on each line: the elastomer and the interface of a scene, at some loads and
/// velocities.
struct RealizationPart {
  const Scene& scene;  // its load and its sweep do not count
  std::span<const LoadCase> cases;
  /// Whether depths found at one force are where the search at the next one begins. It changes the
  /// cost and the last digits within the residual; all cases must have the same velocities.
  bool sharesForces = false;
  bool beginsChunk = true;  // false: slid by the same thread as the part before it
};

/// One or more parts of one scheme on the same lines. Each line is made once for as many parts as a
/// thread slides together.
struct RealizationWork {
  const LineSource& source;
  std::span<const RealizationPart> parts;
  std::int64_t first = 0;  // first realization

  Scheme scheme() const { return parts.front().scene.accuracy.scheme; }
};

/// Called with the results of one realization: the velocities of the first case, of the second, ...
/// of the first part, of the second, ...
using TakeRealization = std::function<void(std::span<const SteadyResult> results)>;

/// Called on the calling thread between realizations, when all of `done` have been taken.
using BatchDone = std::function<void(std::int64_t done)>;

/// Slides `count` realizations from the first. threads: 0 means as many as the machine has. Returns
/// false where `stop` was requested; the realizations taken by then are the first ones of all.
bool slideRealizations(const RealizationWork& work, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone = {});

// ---- The friction curve

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
