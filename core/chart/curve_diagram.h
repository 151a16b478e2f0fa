// Friction curves as a diagram, in the window and in every file: friction over velocity with
// Eq. (11), error bars and the regions of the present curve, other curves beside it, and below them
// the difference of two settings. Pure; any thread.
#pragma once

#include <span>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// What DiagramSeries::id says of a friction curve. Curves that are pinned have their own numbers,
/// all above 0.
inline constexpr int kPresentCurve = 0, kLawCurve = -2, kDifferenceCurve = -3;

/// The curve of one scene.
DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points);

/// Curves that are shown together, and below them, over the same axis, the difference of two
/// settings where there is one. The rows of the points count CurvePoint and DifferencePoint.
DiagramSheet curveSheet(const CurveSet& set);

}  // namespace asperity
