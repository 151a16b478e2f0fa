#include "ui/chart/marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr float kRing = 1.9F;  // relative to the other marks' size
constexpr int kRingSides = 32;

void addRing(DrawLayer& layer, DrawPoint at, float size, const Rgba& colour) {
  const float width = std::max(1.0F, 0.2F * size), r = (kRing * size - width) / 2;
  std::vector<DrawPoint> circle;
  for (int i = 0; i <= kRingSides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSides;
    circle.push_back({at.x + r * std::cos(angle), at.y + r * std::sin(angle)});
  }
  addLine(layer, circle, width, colour);
}

/// Returns the width of the line around a mark; it gives the triangles a smooth edge.
float edgeWidth(float size) {
  return std::min(1.5F, 0.3F * size);
}

std::vector<DrawPoint> closed(std::vector<DrawPoint> corners) {
  corners.push_back(corners.front());
  return corners;
}

}  // namespace

std::vector<DrawPoint> markCorners(SeriesMark mark, DrawPoint at, float size) {
  const float r = size / 2;
  const auto shifted = [&](std::initializer_list<DrawPoint> offsets) {
    std::vector<DrawPoint> corners;
    for (const DrawPoint& o : offsets) corners.push_back({at.x + r * o.x, at.y + r * o.y});
    return corners;
  };
  switch (mark) {
    case SeriesMark::Square:
      return shifted({{-0.89F, -0.89F}, {0.89F, -0.89F}, {0.89F, 0.89F}, {-0.89F, 0.89F}});
    case SeriesMark::Triangle:
      return shifted({{0, -1.28F}, {1.14F, 0.7F}, {-1.14F, 0.7F}});
    case SeriesMark::Diamond:
      return shifted({{0, -1.3F}, {1.16F, 0}, {0, 1.3F}, {-1.16F, 0}});
    case SeriesMark::None:
    case SeriesMark::Circle:
    case SeriesMark::Ring:
      break;
  }
  return {};
}

void addMark(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, const Rgba& colour) {
  if (mark == SeriesMark::None) return;
  if (mark == SeriesMark::Circle) return addLine(layer, {at}, size, colour);
  if (mark == SeriesMark::Ring) return addRing(layer, at, size, colour);
  const float edge = edgeWidth(size);
  const std::vector<DrawPoint> corners = markCorners(mark, at, size - edge);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    for (const DrawPoint& p : {corners[0], corners[i], corners[i + 1]})
      layer.triangles.push_back({p.x, p.y, colour});
  addLine(layer, closed(corners), edge, colour);
}

void addMarkRim(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, float rim,
                const Rgba& colour) {
  if (mark == SeriesMark::None || mark == SeriesMark::Ring)
    return;  // the enclosed mark stays visible
  if (mark == SeriesMark::Circle) return addLine(layer, {at}, size + 2 * rim, colour);
  addLine(layer, closed(markCorners(mark, at, size)), 2 * rim, colour);
}

}  // namespace asperity
