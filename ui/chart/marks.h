// The marks of data points. Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include "core/chart/diagram.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// The corners of a mark around a place, as large to the eye as a circle `size` wide; empty for a
/// circle, a ring and for none.
std::vector<Place> markCorners(SeriesMark mark, Place at, float size);

/// Draws a filled mark with smooth edges.
void addMark(DrawLayer& layer, SeriesMark mark, Place at, float size, const Rgba& colour);

/// What keeps a mark apart from what is under it; in a layer below the mark's.
void addMarkRim(DrawLayer& layer, SeriesMark mark, Place at, float size, float rim,
                const Rgba& colour);

}  // namespace asperity
