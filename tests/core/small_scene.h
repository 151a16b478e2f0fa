// A scene that is computed in no time: a self-affine line of few elements, few velocities, few
// realizations.
#pragma once

#include "core/friction/ensemble.h"
#include "core/scene/scene.h"

namespace asperity {

inline Scene sceneOfSize(std::int64_t elements, std::int64_t velocities, std::int64_t realizations,
                         double velocity = Sliding().velocity) {
  Scene scene;
  scene.surface.elements = elements;
  scene.sweep.points = velocities;
  scene.ensemble.realizations = realizations;
  scene.sliding.velocity = velocity;
  return scene;
}

/// Returns what `asperity curve` computes for the scene at its velocity.
inline CurvePoint pointOfCurve(Scene scene) {
  scene.sweep.points = 1;
  scene.sweep.velocityFrom = scene.sweep.velocityTo = scene.sliding.velocity;
  return frictionCurve(scene, {}).points.front();
}

}  // namespace asperity
