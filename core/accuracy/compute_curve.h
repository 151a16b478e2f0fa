// The friction curve of a scene, computed in one way for every caller: the window's runner, the
// commands curve, render and batch, and curves drawn beside another one. A caller sets the
// number of lines, scheme, target accuracy and velocities in the scene, which is a plain value.
// CurveOptions are for progress and cancelling: `progress` is called with the points so far, and
// `stop` ends the computation within a pass over a line.
//
// The paper's figures read slopes and plateaus with their uncertainties from many loads at once;
// they need the means of groups of lines and therefore use `GroupedMeans`
// (core/friction/jackknife.h).
// Threading, failure: as frictionCurve.
#pragma once

#include <optional>

#include "core/base/message.h"
#include "core/friction/ensemble.h"

namespace asperity {

/// Returns the curve of steady sliding, whatever motion the scene has: mu, its error, contact and
/// indentation at every value of the sweep. With `accuracy.target_relative_error` the resolution
/// and the number of lines are chosen for each point; otherwise the scene's own are used. A
/// cancelled curve is not complete and has the points of the finished part.
///
/// Over another key than velocity, every value is a state of its own that slides at
/// `sliding.velocity` (core/friction/steady_states.h); states that differ only in scaling share
/// their lines. Each point is that of the state's own curve over velocity, to rounding: a
/// resolution that the scene leaves open is chosen for each value, as that curve would, and a
/// target is met at each value. fixResolution (core/scene/scene.h) would hold one resolution
/// along the axis, which a derivative needs; here the choice keeps the error of resolution below
/// half of the standard error at each point, so that a change of it stays below what the error bars
/// show.
Curve computeCurve(const Scene& scene, const CurveOptions& options = {});

/// Returns the curve at this velocity (m/s) alone, which replaces the scene's sweep.
Curve computeCurveAt(Scene scene, double velocity, const CurveOptions& options = {});

/// Returns the sentence that says why a curve misses its target, with the achieved error; nothing
/// where it does not.
std::optional<Message> missedTarget(const Curve& curve);

}  // namespace asperity
