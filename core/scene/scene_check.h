// Whether the values of a scene, each allowed by itself, go together, and whether they suit the
// work that is asked for. Pure; any thread.
#pragma once

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// Throws InputError with the key that is missing or does not go with another one. Reading a scene
/// checks it; code that sets values of its own calls this afterwards.
void checkScene(const Scene& scene);

/// Throws InputError naming the key where two effects exclude each other or one cannot be.
void checkEffects(const Scene& scene);

/// Whether local friction in contact stands beside that of the deformation.
inline bool hasLocalFriction(const Scene& scene) {
  return scene.interface.frictionCoefficient > 0 || scene.interface.shearStress > 0;
}

/// Throws InputError where the elastomer has no equilibrium. Over a steady period an arm's strain
/// has the mean 0, for what it yields must come back, and so has the rate of the depth: what is
/// left is F_N = 4G integral of y, nothing at G = 0, at any velocity. Under a force it sinks for
/// ever.
void requireEquilibrium(const Scene& scene);

/// Throws InputError (sliding.kind) in one sentence where the motion is not steady or the
/// elastomer would sink for ever; `what` needs steady sliding, e.g. "asperity curve".
void requireSteadySliding(const Scene& scene, const Message& what);

}  // namespace asperity
