// Named regions and tinted ranges along x, and texts with arrows. Private to ui/chart. Pure; any
// thread.
#pragma once

#include <string>
#include <vector>

#include "ui/chart/diagram_axes.h"
#include "ui/draw/occupancy_grid.h"

namespace asperity {

/// Pixels above the frame for the names of the regions; 0 where none has one.
float aboveFrame(const Diagram& diagram, const DiagramSizes& sizes);

/// Shades every other region, writes their names above the frame, and tints the shades.
void addSpans(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
              const DiagramSizes& sizes, const Theme& theme);

struct PlacedLabel {
  std::vector<std::string> lines;
  Box box;                   // of the text
  std::vector<Place> arrow;  // from the text to its target; empty: none
  bool covers = false;       // whether something lies under the text
};

inline constexpr float kTaken = 100;  // weight of what may not be covered at all

/// Near their places, and names of shades at their feet, moved so that none covers another and
/// little is covered of what the map has; adds them to the map. A label that finds no place is left
/// out.
std::vector<PlacedLabel> placeLabels(const Diagram& diagram, const DiagramAxes& axes,
                                     OccupancyGrid& map, const DiagramSizes& sizes);

void addLabels(DrawList& list, const std::vector<PlacedLabel>& labels, const DiagramSizes& sizes,
               const Theme& theme);

}  // namespace asperity
