// Checks whether the values of a scene, each allowed by itself, are consistent, and whether they
// suit the requested work. Pure; any thread.
#pragma once

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// Throws InputError with the key that is missing or inconsistent with another one. Reading a scene
/// checks it; code that sets values of its own calls this function afterwards.
void checkScene(const Scene& scene);

/// Throws InputError that names the key where two effects exclude each other or one is impossible.
void checkEffects(const Scene& scene);

/// Throws InputError where the elastomer has no equilibrium. Over a steady period the strain of an
/// arm has the mean 0, because its creep must return, and so has the rate of the depth. The
/// remaining force is F_N = 4G integral of y, which is 0 for G = 0 at any velocity: under a force
/// the line sinks for ever.
void requireEquilibrium(const Scene& scene);

/// Throws InputError (sliding.kind) in one sentence where the motion is not steady or the
/// elastomer would sink for ever; `what` needs steady sliding, e.g. "asperity curve".
void requireSteadySliding(const Scene& scene, const Message& what);

/// Throws InputError (sliding.kind) where sliding is steady; `what` needs a motion in time, e.g.
/// "asperity motion".
void requireMotion(const Scene& scene, const Message& what);

/// Throws InputError (accuracy.target_relative_error) where the scene has a target, with the reason
/// why there can be none and what to give instead.
void requireNoTarget(const Scene& scene, const Message& why);

}  // namespace asperity
