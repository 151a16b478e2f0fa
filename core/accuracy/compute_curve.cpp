#include "core/accuracy/compute_curve.h"

#include <fmt/format.h>

#include <stdexcept>

#include "core/accuracy/target_curve.h"
#include "core/base/printed_number.h"

namespace asperity {

Curve computeCurve(const Scene& scene, const CurveOptions& options) {
  Scene steady = scene;
  steady.sliding.kind = SlidingKind::Steady;
  return choosesAccuracy(steady) ? targetCurve(steady, options).curve
                                 : frictionCurve(steady, options);
}

CurvePoint computePoint(Scene scene, double velocity, const CurveOptions& options) {
  scene.sweep.velocityFrom = scene.sweep.velocityTo = velocity;
  scene.sweep.points = 1;
  return computeCurve(scene, options).points.front();
}

void requireTarget(const Curve& curve) {
  if (curve.isTargetMet) return;
  throw std::runtime_error(
      fmt::format("accuracy.target_relative_error is not reached within the lines and memory "
                  "allowed: {}",
                  printedNumber(curve.achievedError, 2)));
}

}  // namespace asperity
