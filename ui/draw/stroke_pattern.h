// Cutting of polylines: at the edges of a box, and into dashes. Pure; any thread. Pixels.
#pragma once

#include <vector>

#include "ui/draw/draw_list.h"
#include "ui/draw/shapes.h"

namespace asperity {

using Polyline = std::vector<DrawPoint>;

/// Returns the parts inside the box, in order; a point that is not finite interrupts the line. A
/// polyline of one point is kept if it lies in the box.
std::vector<Polyline> clippedTo(const Box& box, const Polyline& line);

/// Returns pieces of length `on` with gaps of length `off` along the line, beginning with a piece;
/// corners are kept. `on` = 0 gives single points at distances `off`.
std::vector<Polyline> dashed(const Polyline& line, float on, float off);

/// Part of the height for a contact above one diagram, and above two.
inline constexpr double kContactPart = 0.54;
inline constexpr double kContactPartOfThree = 0.4;

/// Adds all of `part`, with its background, to `list`, shifted right and down.
void addPicture(DrawList& list, DrawList part, float right, float down);

/// Returns one picture above the other; as wide as the wider one.
DrawList stacked(DrawList above, DrawList below);

}  // namespace asperity
