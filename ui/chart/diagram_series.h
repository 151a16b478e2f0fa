// The curves, marks, error bars, bands and named horizontal bars of a diagram. Private to ui/chart.
// Pure; any thread.
#pragma once

#include <vector>

#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_style.h"
#include "ui/chart/occupancy_grid.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// Returns the curve of a series inside the frame, in parts without gaps.
std::vector<Polyline> clippedCurve(const DiagramSeries& series, const DiagramAxes& axes);

/// Returns the lowest and the highest point of each pixel column, in their order; both ends are
/// kept. x ascends.
std::vector<DrawPoint> thinned(const std::vector<DrawPoint>& points);

/// Adds bands, then theory, then the data in its order.
void addSeries(DrawList& list, const Diagram& diagram, const std::vector<SeriesStyle>& styles,
               const DiagramAxes& axes, const DiagramSizes& sizes, const Theme& theme);

/// Marks in the map where the series are: weight 1 under curves and marks, less under bars and
/// bands.
void coverSeries(OccupancyGrid& map, const Diagram& diagram, const std::vector<SeriesStyle>& styles,
                 const DiagramAxes& axes);

/// Returns the y-axis of a diagram of horizontal bars: a tick with its name for each, from the top.
/// Names are shortened to `available` pixels.
TickedAxis barAxis(const Diagram& diagram, float available, const DiagramSizes& sizes);

/// Adds the horizontal bars with their errors, and a line at 0.
void addHorizontalBars(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
                       const DiagramSizes& sizes, const Theme& theme);

}  // namespace asperity
