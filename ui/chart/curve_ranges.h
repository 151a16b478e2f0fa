// The ranges of the axes of a friction chart in the window: what its curves need, and how a range
// follows while lines arrive and the scene changes. Pure; any thread.
#pragma once

#include "core/base/intervals.h"
#include "core/chart/curve_set.h"
#include "ui/chart/chart_geometry.h"

namespace asperity {

/// Positions on the axes of a set of curves.
struct CurveExtents {
  Extent along, up;
};

/// Returns what the axes must reach over: the curves with their errors, local friction, Eq. (11)
/// where the points have it, and the measured friction.
CurveExtents curveExtents(const CurveSet& set);

/// Returns whole decades around the positions on a logarithmic axis, of which the nearest lie at
/// this factor or more from the ends; on a linear axis the positions with a margin. Empty without
/// positions.
AxisRange rangeAround(const Extent& positions, AxisScale scale, double factor = 1);

/// Returns the range to show next. It grows at once when the data need it, and shrinks only when
/// `mayShrink` is set and an end lies two decades or more outside the data.
AxisRange steadyRange(const AxisRange& shown, const AxisRange& needed, bool mayShrink);

/// Returns the range of a linear axis that contains both. An end that moves leaves some room, so
/// that a marker which goes on moving does not change the axis with each frame.
AxisRange grownRange(const AxisRange& shown, const AxisRange& needed);

/// Sets the range of an axis; one for which none is known finds its own.
void setRange(DiagramAxis& axis, const AxisRange& range);

}  // namespace asperity
