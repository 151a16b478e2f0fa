// Friction curves as a diagram, in the window and in every file: friction over velocity with Eq.
// (11), error bars and the regions of the present curve, further curves, and below them the
// difference of two settings. Pure; any thread.
#pragma once

#include <span>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// Values of DiagramSeries::id for a friction curve. Pinned curves have their own numbers, all
/// above 0.
inline constexpr int kPresentCurve = 0, kLawCurve = -2, kDifferenceCurve = -3, kTotalCurve = -4;
/// The first of the theories and of the measured tables; the others count down from it.
inline constexpr int kTheoryCurves = -100, kMeasuredCurves = -200;

/// Ends of a logarithmic axis of a coefficient of friction on which there is nothing to show.
inline constexpr double kEmptyFrictionFrom = 1e-6, kEmptyFrictionTo = 1e-2;

/// Returns the diagram of one scene's curve.
DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points);

/// Returns the diagram of several curves, and below it, over the same axis, the difference of two
/// settings where there is one. The rows of the points count CurvePoint and DifferencePoint.
DiagramSheet curveSheet(const CurveSet& set);

/// Returns the sheet without the present curve and everything that reveals it, for a student who
/// predicts it, with these ends of the vertical axis. Pinned curves stay.
DiagramSheet withoutCurve(DiagramSheet sheet, double from, double to);

}  // namespace asperity
