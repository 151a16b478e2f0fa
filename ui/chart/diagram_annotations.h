// Named regions and shaded ranges in x, and texts with arrows. Private to ui/chart. Pure; any
// thread.
#pragma once

#include <string>
#include <vector>

#include "ui/chart/diagram_axes.h"
#include "ui/chart/occupancy_grid.h"

namespace asperity {

/// Returns the pixels above the frame for the names of the regions; 0 where none has a name.
float aboveFrame(const Diagram& diagram, const DiagramSizes& sizes);

/// Shades every second region, writes the names above the frame, and tints the shaded ranges.
void addSpans(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
              const DiagramSizes& sizes, const Theme& theme);

struct PlacedLabel {
  std::vector<std::string> lines;
  Box box;                       // of the text
  std::vector<DrawPoint> arrow;  // from the text to its target; empty: none
  bool covers = false;           // whether something lies under the text
  bool isOfMarker = false;       // has the marker's colour
  bool isOfShade = false;        // is faint
};

/// Places labels near their points, and names of shades at their feet. They are moved so that none
/// covers another and little of the map is covered; they are then added to the map. A label that
/// does not fit is left out.
std::vector<PlacedLabel> placeLabels(const Diagram& diagram, const DiagramAxes& axes,
                                     OccupancyGrid& map, const DiagramSizes& sizes);

void addLabels(DrawList& list, const std::vector<PlacedLabel>& labels, const DiagramSizes& sizes,
               const Theme& theme);

}  // namespace asperity
