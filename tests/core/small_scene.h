// A scene that is computed in no time: a self-affine line of few elements, few velocities, few
// realizations.
#pragma once

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

}  // namespace asperity
