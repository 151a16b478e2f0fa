#include "core/accuracy/compute_curve.h"

#include "core/accuracy/target_curve.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"

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
  throw TextError(message(
      "accuracy.target_relative_error is not reached within the lines and memory allowed: {}",
      PrintedNumber{printedNumber(curve.achievedError, 2)}));
}

}  // namespace asperity
