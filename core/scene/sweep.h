// The parameter over which a friction curve goes: which one may be swept in a scene, its values,
// and the state at each of them. Pure; any thread.
#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/scene/range.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns the velocities of a sweep over velocity, m/s.
std::vector<double> sweepVelocities(const Sweep& sweep);

/// Returns the row of the key over which the scene's curve goes. Throws InputError (sweep.key)
/// where there is none.
const Parameter& sweptParameter(const Scene& scene);

/// Returns the range of the scene's sweep, over whichever key.
ParameterRange sweepRange(const Scene& scene);

/// Returns the scene with its curve over this range.
Scene sceneOver(const ParameterRange& range, Scene scene);

/// Returns the values of the scene's sweep in the key's unit, velocities included. Those of a whole
/// number are rounded, and repeats are left out.
std::vector<double> sweepValues(const Scene& scene);

/// Returns the scene with the swept key at a value: a state that slides at `sliding.velocity`, with
/// the plain sweep over velocity. Throws InputError where the key does not allow the value.
Scene sceneAt(const Scene& scene, double value);

/// Returns the number that the swept key has in the scene itself.
double ownSweptValue(const Scene& scene);

/// Returns the scene itself with the swept key at a value, within what the key allows.
Scene withSweptValue(Scene scene, double value);

/// Returns a range for a curve over a parameter around the scene's own value: two decades to each
/// side, or the range of a linear slider; shorter where the ends cannot be.
ParameterRange usualRange(const Parameter& parameter, const Scene& scene);

/// Returns the scene with a curve over velocity where its own axis has no meaning any more.
Scene withMeaningfulAxis(Scene scene);

/// Returns the scene with defaults in place of all on which its friction curve does not depend:
/// texts, the motion (but the velocity at which a curve over another key slides), the scene's own
/// value of the swept key. Scenes that are equal then have the same curve.
Scene canonicalCurveScene(Scene scene);

/// Returns why a friction curve cannot go over this parameter in the scene: no number, a rule of
/// the curve itself, no meaning, or no influence on friction. Empty where it can.
Message whyNotSwept(const Parameter& parameter, const Scene& scene);

/// Returns the same where another parameter varies, too: empty where friction depends on this one
/// at either end of the other's range. WLF's constants matter away from the reference temperature
/// alone. Throws InputError where the other cannot have these values.
Message whyNotBeside(const Parameter& parameter, const Scene& scene, const ParameterRange& other);

/// Throws InputError (sweep.key) where the scene's curve does not go over velocity, which `what`
/// needs.
void requireVelocityAxis(const Scene& scene, const Message& what);

/// Throws InputError that names the key of the sweep where it cannot be: the reason above, ends
/// that the key does not allow, a logarithm of what is not above 0.
void checkSweep(const Scene& scene);

}  // namespace asperity
