// A quantity over the plane of a diagram: its colours, contour lines with their values, and the
// colour bar. Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include "ui/chart/diagram_axes.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// Returns the axis of the colours with as many ticks as fit a bar of this height.
TickedAxis colourAxis(const DiagramField& field, float height, const DiagramSizes& sizes);

/// Returns the pixels at the right of the frame for the colour bar with its labels and title.
float colourBarWidth(const TickedAxis& colours, const DiagramSizes& sizes);

void addFieldColours(DrawList& list, const DiagramField& field, const DiagramAxes& axes);
/// Adds the contour lines. A line is interrupted for its value, which is written along it, outside
/// these boxes and away from these lines. Where no line of a contour has such a place, its value
/// may lie over them.
void addContours(DrawList& list, const DiagramField& field, const DiagramAxes& axes,
                 const DiagramSizes& sizes, const std::vector<Box>& taken,
                 const std::vector<Polyline>& borders);
/// Adds the bar at the right of the frame.
void addColourBar(DrawList& list, const TickedAxis& colours, const Box& frame,
                  const DiagramSizes& sizes, const Theme& theme);

}  // namespace asperity
