// What of an area is taken, on a coarse grid, and where in it something finds a free place. Private
// to ui/draw. A plain value; any thread. Pixels.
#pragma once

#include <vector>

#include "ui/draw/shapes.h"

namespace asperity {

class OccupancyGrid {
 public:
  OccupancyGrid(const Box& area, float cell);

  /// Takes the cells under a line; what lies outside the area is ignored.
  void addLine(const std::vector<Place>& places, float weight);
  /// Takes the cells that a box touches.
  void addBox(const Box& box, float weight);
  /// The mean weight of the cells that a box touches; outside the area counts as free.
  float under(const Box& box) const;
  float greatestUnder(const Box& box) const;

  const Box& area() const { return area_; }

 private:
  struct Cells {
    int left, right, top, bottom;  // right and bottom are one beyond
  };
  Cells cellsOf(const Box& box) const;

  Box area_;
  float cell_;
  int columns_, rows_;
  std::vector<float> weights_;  // columns_ x rows_
};

/// A box of this size inside the map's area, `margin` from its edges, that covers least; corners
/// are preferred. The box is empty where the area is too small.
Box freestPlace(const OccupancyGrid& map, float width, float height, float margin);

}  // namespace asperity
