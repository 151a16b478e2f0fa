#include "ui/picture/clear_place.h"

#include <cmath>

#include "ui/picture/contact_glow.h"
#include "ui/picture/decimate.h"

namespace asperity {
namespace {

bool touches(const Frame& frame, const ContactLayout& layout, std::size_t point) {
  return frame.pressure[point] > 0 || layout.marked == point;
}

/// Whether the contact at a point, with the brighter half of its glow, stays above the row.
bool isAbove(const Frame& frame, const ContactLayout& layout, std::size_t point, float top) {
  const float y = layout.py(frame.surfaceHeight[point]);
  return y + 0.5F * glowDepth(layout) < top || y > layout.plot.bottom() + 0.5F * glowDepth(layout);
}

}  // namespace

bool clearAcross(const Frame& frame, const ContactLayout& layout, float top) {
  for (std::size_t i = 0; i < frame.pressure.size(); ++i)
    if (touches(frame, layout, i) && !isAbove(frame, layout, i, top)) return false;
  return true;
}

std::optional<float> clearPlace(const Frame& frame, const ContactLayout& layout, float top,
                                float width, float margin) {
  const Box& plot = layout.plot;
  const auto n = static_cast<std::int64_t>(frame.pressure.size());
  const auto isClear = [&](float x) {
    const float air = 0.5F * margin;  // less than margin: the axes' ends are no neighbours
    const double left = layout.view.left + (x - air - plot.x) / layout.pixelsPerMetreAlong();
    const double across = (width + 2 * air) / layout.pixelsPerMetreAlong();
    const PointRange range = pointsWithin(frame, left, across);
    for (std::int64_t i = range.first; i <= range.last && i < range.first + n; ++i) {
      const auto point = static_cast<std::size_t>((i % n + n) % n);
      if (touches(frame, layout, point) && !isAbove(frame, layout, point, top)) return false;
    }
    return true;
  };
  for (const float x : {plot.x + margin, plot.right() - margin - width,
                        std::round(plot.x + (plot.width - width) / 2)})
    if (isClear(x)) return x;
  return std::nullopt;
}

}  // namespace asperity
