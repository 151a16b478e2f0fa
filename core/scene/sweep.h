// The parameter over which a friction curve goes: which one may be swept in a scene, its values,
// and the state at each of them. Pure; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/message.h"
#include "core/scene/parameters.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns x_i = from (to / from)^(i / (points - 1)), with the last one exactly `to`.
std::vector<double> logSpaced(double from, double to, std::int64_t points);

/// Returns x_i = from + (to - from) i / (points - 1), with the last one exactly `to`.
std::vector<double> linearSpaced(double from, double to, std::int64_t points);

/// Returns the velocities of a sweep over velocity, m/s.
std::vector<double> sweepVelocities(const Sweep& sweep);

/// Returns the row of the key over which the scene's curve goes. Throws InputError (sweep.key)
/// where there is none.
const Parameter& sweptParameter(const Scene& scene);

/// Returns the values of the scene's sweep in the key's unit, velocities included. Those of a whole
/// number are rounded, and repeats are left out.
std::vector<double> sweepValues(const Scene& scene);

/// Returns the scene with the swept key at a value: a state that slides at `sliding.velocity`, with
/// the plain sweep over velocity. Throws InputError where the key does not allow the value.
Scene sceneAt(const Scene& scene, double value);

/// Returns the number that the swept key has in the scene itself.
double ownSweptValue(const Scene& scene);

/// Returns why a friction curve cannot go over this parameter in the scene: no number, a rule of
/// the curve itself, no meaning, or no influence on friction. Empty where it can.
Message whyNotSwept(const Parameter& parameter, const Scene& scene);

/// Throws InputError that names the key of the sweep where it cannot be: the reason above, ends
/// that the key does not allow, a logarithm of what is not above 0.
void checkSweep(const Scene& scene);

}  // namespace asperity
