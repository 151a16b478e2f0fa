#include "ui/chart/occupancy_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

Box grown(const Box& box, float by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

std::optional<DrawPoint> exitPoint(const Box& box, const DrawPoint& to) {
  const DrawPoint middle{box.x + box.width / 2, box.y + box.height / 2};
  const float dx = to.x - middle.x, dy = to.y - middle.y;
  const float across = std::abs(dx) / (box.width / 2), upwards = std::abs(dy) / (box.height / 2);
  const float reach = std::max(across, upwards);
  if (!(reach > 1)) return std::nullopt;
  return DrawPoint{middle.x + dx / reach, middle.y + dy / reach};
}

namespace {

bool isInside(const Box& area, const Box& box) {
  return box.x >= area.x && box.y >= area.y && box.right() <= area.right() &&
         box.bottom() <= area.bottom();
}

}  // namespace

std::optional<Box> boxNear(const DrawPoint& at, float width, float height, const Box& area,
                           const OccupancyGrid& map, float step, int rings,
                           const std::function<bool(const Box&)>& allowed) {
  constexpr int kAngles = 16;
  std::optional<Box> best;
  float least = 0;
  for (int ring = 0; ring <= rings; ++ring)
    for (int k = 0; k < (ring == 0 ? 1 : kAngles); ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kAngles;
      const float away = static_cast<float>(ring) * step;
      const Box box{at.x + away * std::cos(angle) - width / 2,
                    at.y + away * std::sin(angle) - height / 2, width, height};
      if (!isInside(area, box) || map.greatestUnder(box) >= kTaken || !allowed(box)) continue;
      // Covering something costs more than any distance.
      const float cost = 20 * map.under(box) + 0.05F * static_cast<float>(ring);
      if (!best || cost < least) {
        best = box;
        least = cost;
      }
    }
  return best;
}

}  // namespace asperity
