#include "ui/contact/label_placement.h"

#include <algorithm>
#include <cmath>

#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"

namespace asperity {
namespace {

bool touches(const Frame& frame, const ContactLayout& layout, std::size_t point) {
  return frame.pressure[point] > 0 || layout.marked == point;
}

/// Returns whether the contact at a point, with the brighter half of its glow, stays above the row.
bool isAbove(const Frame& frame, const ContactLayout& layout, std::size_t point, float top) {
  const float y = layout.py(frame.surfaceHeight[point]);
  return y + 0.5F * glowDepth(layout) < top || y > layout.plot.bottom() + 0.5F * glowDepth(layout);
}

/// Counts the points of the range with a property; the range continues periodically, but no point
/// counts twice.
std::int64_t countWithin(const Frame& frame, const PointRange& range, const auto& has) {
  const auto n = static_cast<std::int64_t>(frame.pressure.size());
  std::int64_t count = 0;
  for (std::int64_t i = range.first; i <= range.last && i < range.first + n; ++i)
    count += has(static_cast<std::size_t>((i % n + n) % n)) ? 1 : 0;
  return count;
}

/// Returns whether the other body stays outside of the rows of the box, and the body itself reaches
/// the middle of the box at most of the points; at the others there may be a gap.
bool isOnBody(Body body, const Frame& frame, const ContactLayout& layout, const Box& box,
              const PointRange& range) {
  const float middle = box.y + box.height / 2;
  const bool isRigid = body == Body::Rigid;
  const auto isIntruded = [&](std::size_t point) {
    return isRigid ? layout.py(frame.surfaceHeight[point]) < box.bottom()
                   : layout.py(frame.lineHeight[point]) > box.y;
  };
  const auto isReached = [&](std::size_t point) {
    return isRigid ? layout.py(frame.lineHeight[point]) > middle
                   : layout.py(frame.surfaceHeight[point]) < middle;
  };
  const auto n = static_cast<std::int64_t>(frame.pressure.size());
  return countWithin(frame, range, isIntruded) == 0 &&
         2 * countWithin(frame, range, isReached) >= std::min(range.count(), n);
}

/// Returns the points between two columns of pixels.
PointRange pointsBetween(const Frame& frame, const ContactLayout& layout, float left, float right) {
  const double perMetre = layout.pixelsPerMetreX();
  return pointsWithin(frame, layout.view.left + (left - layout.plot.x) / perMetre,
                      (right - left) / perMetre);
}

}  // namespace

bool isOnBody(Body body, const Frame& frame, const ContactLayout& layout, const Box& box) {
  const auto last = static_cast<std::int64_t>(frame.pressure.size()) - 1;
  return isOnBody(body, frame, layout, box, {0, last}) ||
         isOnBody(body, frame, layout, box, pointsBetween(frame, layout, box.x, box.right()));
}

bool clearAcross(const Frame& frame, const ContactLayout& layout, float top) {
  for (std::size_t i = 0; i < frame.pressure.size(); ++i)
    if (touches(frame, layout, i) && !isAbove(frame, layout, i, top)) return false;
  return true;
}

std::optional<float> labelPlacement(const Frame& frame, const ContactLayout& layout, float top,
                                    float width, float margin, std::optional<float> last) {
  const Box& plot = layout.plot;
  const auto isClear = [&](float x) {
    const float gap = 0.5F * margin;  // less than margin: the axes' ends do not count as neighbours
    return countWithin(frame, pointsBetween(frame, layout, x - gap, x + width + gap),
                       [&](std::size_t point) {
                         return touches(frame, layout, point) &&
                                !isAbove(frame, layout, point, top);
                       }) == 0;
  };
  const float first = plot.x + margin, end = plot.right() - margin - width;
  if (last && *last >= first && *last <= end && isClear(*last)) return last;
  for (const float x : {first, end, std::round(plot.x + (plot.width - width) / 2)})
    if (isClear(x)) return x;
  return std::nullopt;
}

bool lineStaysBelow(const Frame& frame, const ContactLayout& layout, float bottom) {
  return std::ranges::all_of(frame.lineHeight,
                             [&](double height) { return !(layout.py(height) < bottom); });
}

bool lineMisses(const Frame& frame, const ContactLayout& layout, float top, float bottom) {
  return lineStaysBelow(frame, layout, bottom) ||
         std::ranges::all_of(frame.lineHeight,
                             [&](double height) { return layout.py(height) < top; });
}

bool CurveRows::crosses(const Box& box) const {
  for (std::size_t i = 0; i < highest.size(); ++i) {
    const float x = left + static_cast<float>(i);
    if (x + 1 > box.x && x < box.right() && highest[i] < box.bottom() && lowest[i] > box.y)
      return true;
  }
  return false;
}

CurveRows curveRows(const Frame& frame, const std::vector<double>& heights,
                    const ContactLayout& layout) {
  const Box& plot = layout.plot;
  const auto count = static_cast<std::size_t>(std::ceil(plot.width));
  constexpr float kFar = 1e6F;
  CurveRows rows{plot.x, std::vector<float>(count, kFar), std::vector<float>(count, -kFar)};
  const std::vector<CurveVertex> curve =
      decimated(frame, heights, pointsWithin(frame, layout.view.left, layout.view.width),
                {layout.view.left, layout.pixelsPerMetreX()});
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const float xa = layout.px(curve[k].x), xb = layout.px(curve[k + 1].x);
    const float ya = layout.py(curve[k].height), yb = layout.py(curve[k + 1].height);
    const float first = std::clamp(std::floor(xa - plot.x), 0.0F, static_cast<float>(count));
    const float last = std::clamp(std::floor(xb - plot.x) + 1, 0.0F, static_cast<float>(count));
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      const float x = plot.x + static_cast<float>(i);
      for (const float at : {std::max(x, xa), std::min(x + 1, xb)}) {
        const float y =
            xb > xa ? ya + (yb - ya) * std::clamp((at - xa) / (xb - xa), 0.0F, 1.0F) : yb;
        rows.highest[i] = std::min(rows.highest[i], y);
        rows.lowest[i] = std::max(rows.lowest[i], y);
      }
    }
  }
  return rows;
}

std::optional<float> freeSpanAbove(const CurveRows& curve, const Box& preferred, float from,
                                   float to) {
  constexpr float kStep = 4;  // pixels
  const auto isClear = [&](float x) {
    // Everything above counts as covered: a label below the line is on the elastomer or in the gap.
    const Box above{x, preferred.y - 1e6F, preferred.width, 1e6F + preferred.height};
    return x >= from && x + preferred.width <= to && !curve.crosses(above);
  };
  for (float away = 0; away <= to - from; away += kStep)
    for (const float x : {preferred.x - away, preferred.x + away})
      if (isClear(x)) return x;
  return std::nullopt;
}

}  // namespace asperity
