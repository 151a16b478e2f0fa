// Friction curves as a diagram: friction over velocity with Eq. (11), error bars and the regions of
// the present curve, and its parameters in words. Pure; any thread.
#pragma once

#include <span>

#include "core/friction/curve_point.h"
#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/scene/scene.h"

namespace asperity {

/// The curve of one scene.
DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points);

/// Curves that are shown together, and below them, over the same axis, the difference of two
/// settings where there is one.
DiagramSheet curveSheet(const CurveSet& set);

}  // namespace asperity
