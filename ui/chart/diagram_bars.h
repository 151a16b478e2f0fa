// Horizontal bars with names. Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include "ui/chart/diagram_axes.h"

namespace asperity {

/// Returns the y-axis of a diagram of bars: a tick with its name for each, from the top. Names are
/// shortened to `room` pixels.
TickedAxis barAxis(const Diagram& diagram, float room, const DiagramSizes& sizes);

/// Adds the bars with their errors, and a line at 0.
void addBars(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
             const DiagramSizes& sizes, const Theme& theme);

}  // namespace asperity
