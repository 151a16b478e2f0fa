// The occupied parts of an area on a coarse grid, and the search for a free box in it. Private to
// ui/chart. A plain value; any thread. Pixels.
#pragma once

#include <vector>

#include "ui/draw/shapes.h"

namespace asperity {

class OccupancyGrid {
 public:
  OccupancyGrid(const Box& area, float cell);

  /// Marks the cells under a line as occupied; parts outside the area are ignored.
  void addLine(const std::vector<DrawPoint>& points, float weight);
  /// Marks the cells that a box touches as occupied.
  void addBox(const Box& box, float weight);
  /// Returns the mean weight of the cells that a box touches; outside the area counts as free.
  float under(const Box& box) const;
  float greatestUnder(const Box& box) const;

  const Box& area() const { return area_; }

 private:
  struct Cells {
    int left, right, top, bottom;  // right and bottom are one past the last cell
  };
  Cells cellsUnder(const Box& box) const;

  Box area_;
  float cell_;
  int columns_, rows_;
  std::vector<float> weights_;  // columns_ x rows_
};

/// Returns the box of this size inside the map's area, `margin` from its edges, that covers least;
/// corners are preferred. The box is empty where the area is too small.
Box freestBox(const OccupancyGrid& map, float width, float height, float margin);

}  // namespace asperity
