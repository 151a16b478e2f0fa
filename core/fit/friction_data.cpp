#include "core/fit/friction_data.h"

namespace asperity {

Scene sceneOf(const MeasuredPoint& point, const Scene& scene) {
  Scene at = scene;
  at.sliding.kind = SlidingKind::Steady;
  at.sliding.velocity = point.velocity;
  if (!std::isnan(point.normalForce)) {
    at.load.kind = LoadKind::Force;
    at.load.normalForce = point.normalForce;
  }
  if (!std::isnan(point.temperature)) at.elastomer.temperature = point.temperature;
  return at;
}

}  // namespace asperity
