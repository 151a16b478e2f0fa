#include "ui/chart/occupancy_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

OccupancyGrid::OccupancyGrid(const Box& area, float cell)
    : area_(area),
      cell_(std::max(cell, 1.0F)),
      columns_(std::max(1, static_cast<int>(std::ceil(area.width / cell_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(area.height / cell_)))),
      weights_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

OccupancyGrid::Cells OccupancyGrid::cellsUnder(const Box& box) const {
  const auto index = [&](float pixels, int most) {
    return static_cast<int>(std::clamp(pixels / cell_, 0.0F, static_cast<float>(most)));
  };
  const auto above = [&](float pixels, int most) {
    return static_cast<int>(std::ceil(std::clamp(pixels / cell_, 0.0F, static_cast<float>(most))));
  };
  return {index(box.x - area_.x, columns_), above(box.right() - area_.x, columns_),
          index(box.y - area_.y, rows_), above(box.bottom() - area_.y, rows_)};
}

void OccupancyGrid::addLine(const std::vector<DrawPoint>& points, float weight) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DrawPoint a = points[i], b = points[std::min(i + 1, points.size() - 1)];
    if (!std::isfinite(a.x + a.y + b.x + b.y)) continue;
    const float longest = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    const int steps = 1 + static_cast<int>(std::min(2 * longest / cell_, 1e4F));
    for (int k = 0; k <= steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps);
      addBox({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.01F, 0.01F}, weight);
    }
  }
}

void OccupancyGrid::addBox(const Box& box, float weight) {
  const Cells c = cellsUnder(box);
  for (int row = c.top; row < c.bottom; ++row)
    for (int column = c.left; column < c.right; ++column) {
      float& there = weights_[static_cast<std::size_t>(row * columns_ + column)];
      there = std::max(there, weight);
    }
}

float OccupancyGrid::under(const Box& box) const {
  const Cells c = cellsUnder(box);
  float sum = 0;
  for (int row = c.top; row < c.bottom; ++row)
    for (int column = c.left; column < c.right; ++column)
      sum += weights_[static_cast<std::size_t>(row * columns_ + column)];
  return sum / std::max(1.0F, box.width * box.height / (cell_ * cell_));
}

float OccupancyGrid::greatestUnder(const Box& box) const {
  const Cells c = cellsUnder(box);
  float greatest = 0;
  for (int row = c.top; row < c.bottom; ++row)
    for (int column = c.left; column < c.right; ++column)
      greatest = std::max(greatest, weights_[static_cast<std::size_t>(row * columns_ + column)]);
  return greatest;
}

Box freestBox(const OccupancyGrid& map, float width, float height, float margin) {
  const Box& area = map.area();
  const float freeWidth = area.width - 2 * margin - width,
              freeHeight = area.height - 2 * margin - height;
  if (freeWidth < 0 || freeHeight < 0) return {};
  constexpr int kSteps = 12;
  Box best;
  float least = std::numeric_limits<float>::max();
  for (int row = 0; row <= kSteps; ++row)
    for (int column = 0; column <= kSteps; ++column) {
      const float x = static_cast<float>(column) / kSteps, y = static_cast<float>(row) / kSteps;
      const Box box{std::round(area.x + margin + x * freeWidth),
                    std::round(area.y + margin + y * freeHeight), width, height};
      const float fromCorner = std::min(x, 1 - x) + std::min(y, 1 - y);
      // A hundredth of the box that is hidden counts more than the distance from a corner to the
      // middle.
      const float cost = map.under(box) + 0.01F * fromCorner;
      if (cost < least) {
        least = cost;
        best = box;
      }
    }
  return best;
}

}  // namespace asperity
