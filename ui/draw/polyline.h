// Polylines, cut at the edges of a box or into dashes. Pure; any thread. Pixels.
#pragma once

#include <vector>

#include "ui/draw/shapes.h"

namespace asperity {

using Polyline = std::vector<DrawPoint>;

/// Returns the parts inside the box, in order; a point that is not finite interrupts the line. A
/// polyline of one point is kept if it lies in the box.
std::vector<Polyline> clippedTo(const Box& box, const Polyline& line);

/// Returns pieces of length `on` with gaps of length `off` along the line, beginning with a piece;
/// corners are kept. `on` = 0 gives single points at distances `off`.
std::vector<Polyline> dashed(const Polyline& line, float on, float off);

}  // namespace asperity
