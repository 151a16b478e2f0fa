#include "core/accuracy/compute_curve.h"

#include <algorithm>
#include <cmath>

#include "core/accuracy/target_curve.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/friction/steady_states.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

void setSwept(std::vector<CurvePoint>& points, const std::vector<double>& values) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i].swept = values[i];
}

Curve computeStates(const std::vector<Scene>& states, const std::vector<double>& values,
                    const CurveOptions& options) {
  StateOptions slide{.threads = options.threads, .stop = options.stop};
  if (options.progress)
    slide.partial = [&](std::int64_t done, std::int64_t total, std::vector<CurvePoint> points) {
      setSwept(points, values);
      options.progress({done, total, points});
    };
  SteadyStates found = slideStates(states, slide);
  setSwept(found.points, values);
  Curve curve;
  curve.points = std::move(found.points);
  curve.isComplete = found.isComplete;
  curve.largestResidual = found.largestResidual;
  curve.marginalFraction = found.marginalFraction;
  return curve;
}

/// Computes each value to its own target, one after the other.
Curve computeStatesToTarget(const std::vector<Scene>& states, const std::vector<double>& values,
                            const CurveOptions& options) {
  Curve curve;
  curve.points.resize(states.size());
  curve.isComplete = true;
  setSwept(curve.points, values);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Curve found = computeCurveAt(states[i], states[i].sliding.velocity,
                                       {.threads = options.threads, .stop = options.stop});
    if (!found.isComplete) {
      curve.isComplete = false;
      return curve;
    }
    curve.points[i] = found.points.front();
    curve.points[i].swept = values[i];
    curve.largestResidual = std::max(curve.largestResidual, found.largestResidual);
    curve.isTargetMet = curve.isTargetMet && found.isTargetMet;
    curve.errorOfRows = std::max(curve.errorOfRows, found.errorOfRows);
    if (!std::isnan(found.achievedError) &&
        (std::isnan(curve.achievedError) || found.achievedError > curve.achievedError))
      curve.achievedError = found.achievedError;
    if (options.progress)
      options.progress({static_cast<std::int64_t>(i + 1), static_cast<std::int64_t>(states.size()),
                        curve.points});
  }
  return curve;
}

/// Computes a curve over another key than velocity.
Curve sweepCurve(const Scene& scene, const CurveOptions& options) {
  const std::vector<double> values = sweepValues(scene);
  std::vector<Scene> states;
  for (const double value : values) states.push_back(sceneAt(scene, value));
  return std::ranges::any_of(states, choosesAccuracy)
             ? computeStatesToTarget(states, values, options)
             : computeStates(states, values, options);
}

}  // namespace

Curve computeCurve(const Scene& scene, const CurveOptions& options) {
  Scene steady = scene;
  steady.sliding.kind = SlidingKind::Steady;
  if (!steady.sweep.isOfVelocity()) return sweepCurve(steady, options);
  return choosesAccuracy(steady) ? targetCurve(steady, options).curve
                                 : frictionCurve(steady, options);
}

Curve computeCurveAt(Scene scene, double velocity, const CurveOptions& options) {
  scene.sweep = {};
  scene.sweep.velocityFrom = scene.sweep.velocityTo = velocity;
  scene.sweep.points = 1;
  return computeCurve(scene, options);
}

std::optional<Message> missedTarget(const Curve& curve) {
  if (curve.isTargetMet) return std::nullopt;
  constexpr double kLargePart = 0.5;
  if (curve.errorOfRows > kLargePart * curve.achievedError)
    return message(
        "accuracy.target_relative_error is not reached: {}; the mean over all rows of the surface "
        "is uncertain by {}, which only a larger piece of the surface lowers",
        printed(curve.achievedError, 2), printed(curve.errorOfRows, 2));
  return message(
      "accuracy.target_relative_error is not reached within the lines and memory allowed: {}",
      printed(curve.achievedError, 2));
}

}  // namespace asperity
