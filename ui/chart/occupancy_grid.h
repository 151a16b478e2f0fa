// The occupied parts of an area on a coarse grid, and the search for a free box in it, for legends
// and labels. A plain value; any thread. Pixels.
#pragma once

#include <functional>
#include <optional>
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

inline constexpr float kTaken = 100;  // weight of parts that must not be covered

/// Finds the best box of this size around a point, inside `area`: one that covers little and is
/// moved little, by at most `rings` times `step`. allowed: returns whether a box may be used.
std::optional<Box> boxNear(
    const DrawPoint& at, float width, float height, const Box& area, const OccupancyGrid& map,
    float step, int rings,
    const std::function<bool(const Box&)>& allowed = [](const Box&) { return true; });

/// Returns a box with this much more on each side.
Box grown(const Box& box, float by);

/// Returns the point where the line from the middle of a box to a point outside leaves the box;
/// none for a point inside.
std::optional<DrawPoint> exitPoint(const Box& box, const DrawPoint& to);

}  // namespace asperity
