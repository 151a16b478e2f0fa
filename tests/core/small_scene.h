// Scenes of tests: those that are computed in no time, because their self-affine line has few
// elements, velocities and realizations, and those that are refused.
#pragma once

#include "core/friction/ensemble.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"
#include "tests/core/error_from.h"

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

/// Returns what is said of a scene file that is refused.
inline std::string errorOfScene(const std::string& json,
                                const std::vector<std::string>& assignments = {}) {
  return errorFrom([&] { readScene(json, "s.json", {}, assignments); });
}

}  // namespace asperity
