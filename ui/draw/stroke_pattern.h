// Polylines cut: at the edges of a box, and into dashes. Pure; any thread. Pixels.
#pragma once

#include <vector>

#include "ui/draw/draw_list.h"
#include "ui/draw/shapes.h"

namespace asperity {

using Polyline = std::vector<Place>;

/// The parts inside the box, in order; a place that is not finite breaks the line. A polyline of
/// one place is kept where the box holds it.
std::vector<Polyline> clippedTo(const Box& box, const Polyline& line);

/// Pieces `on` long with `off` between them along the line, beginning with a piece; corners are
/// kept. `on` = 0 gives single places, `off` apart.
std::vector<Polyline> dashed(const Polyline& line, float on, float off);

/// Of the height, for a contact above a diagram, and above one with a second panel under it.
inline constexpr double kContactPart = 0.54;
inline constexpr double kContactPartOfThree = 0.4;

/// All of `part`, with its background, this far right and down on `list`.
void addPicture(DrawList& list, DrawList part, float right, float down);

/// One above the other; as wide as the wider one.
DrawList stacked(DrawList above, DrawList below);

}  // namespace asperity
