// The marks of data points. Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include "core/chart/diagram.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// Returns the corners of a mark around a point, which appears as large as a circle `size` wide;
/// empty for a circle, a ring and no mark.
std::vector<DrawPoint> markCorners(SeriesMark mark, DrawPoint at, float size);

/// Draws a filled mark with smooth edges.
void addMark(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, const Rgba& colour);

/// Adds a rim that separates a mark from objects under it; its layer is below the mark's.
void addMarkRim(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, float rim,
                const Rgba& colour);

}  // namespace asperity
