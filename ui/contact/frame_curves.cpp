#include "ui/contact/frame_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double kFarthest = 1e15;  // points from the origin; positions beyond are inexact

class PeriodicPoints {
 public:
  PeriodicPoints(const Frame& frame, const std::vector<double>& heights,
                 const std::vector<double>& values)
      : frame_(frame),
        heights_(heights),
        values_(values),
        count_(static_cast<std::int64_t>(heights.size())) {}

  CurveVertex at(std::int64_t index) const {
    const std::size_t i = wrapped(index);
    return {static_cast<double>(index) * frame_.spacing, heights_[i],
            values_.empty() ? 0 : values_[i]};
  }
  bool isAbove(std::int64_t index, double least) const { return values_[wrapped(index)] > least; }

 private:
  std::size_t wrapped(std::int64_t index) const {
    const std::int64_t rest = index % count_;
    return static_cast<std::size_t>(rest < 0 ? rest + count_ : rest);
  }

  const Frame& frame_;
  const std::vector<double>& heights_;
  const std::vector<double>& values_;
  std::int64_t count_;
};

double column(const CurveVertex& vertex, const Columns& columns) {
  return std::floor((vertex.x - columns.left) * columns.pixelsPerMetre);
}

/// The lowest and highest point of one column.
class ColumnExtremes {
 public:
  void add(const CurveVertex& vertex) {
    if (empty_) low_ = high_ = vertex;
    if (vertex.height < low_.height) low_ = vertex;
    if (vertex.height > high_.height) high_ = vertex;
    value_ = empty_ ? vertex.value : std::max(value_, vertex.value);
    empty_ = false;
  }
  void flushInto(std::vector<CurveVertex>& curve) {
    if (empty_) return;
    low_.value = high_.value = value_;
    const bool lowFirst = low_.x <= high_.x;
    curve.push_back(lowFirst ? low_ : high_);
    if (low_.x != high_.x) curve.push_back(lowFirst ? high_ : low_);
    empty_ = true;
  }

 private:
  CurveVertex low_, high_;
  double value_ = 0;
  bool empty_ = true;
};

/// Merges intervals closer than a column while it takes their points in order.
class IntervalCollector {
 public:
  IntervalCollector(const Columns& columns, bool everyPoint)
      : columns_(columns), everyPoint_(everyPoint) {}

  void add(std::int64_t index, const CurveVertex& vertex) {
    const bool follows = index == lastIndex_ + 1;
    const double here = column(vertex, columns_);
    const bool sameColumn = !everyPoint_ && here == column_;
    if (intervals_.empty() || !(follows || sameColumn)) {
      flush();
      intervals_.emplace_back();
    } else if (everyPoint_ || !sameColumn) {
      flush();
    }
    extremes_.add(vertex);
    lastIndex_ = index;
    column_ = here;
  }

  std::vector<std::vector<CurveVertex>> take() {
    flush();
    return std::move(intervals_);
  }

 private:
  void flush() {
    if (!intervals_.empty()) extremes_.flushInto(intervals_.back());
  }

  const Columns columns_;
  const bool everyPoint_;
  std::vector<std::vector<CurveVertex>> intervals_;
  ColumnExtremes extremes_;
  std::int64_t lastIndex_ = -2;
  double column_ = 0;
};

bool fitsEveryPoint(const Frame& frame, const Columns& columns) {
  return frame.spacing * columns.pixelsPerMetre >= 0.5;
}

}  // namespace

double frameVelocity(const Frame& frame) {
  if (frame.transient) return frame.velocity;
  return frame.scene ? frame.scene->sliding.velocity : 0;
}

bool hasInterface(const Frame& frame) {
  return frame.scene && hasLocalFriction(*frame.scene);
}

double totalFriction(const ContactState& state) {
  return state.mu + state.muInterface;
}

bool pushesRight(const Frame& frame) {
  const double force =
      frame.transient && !frame.transient->empty() ? frame.transient->back().tangentialForce : 0;
  return (force != 0 ? force : frameVelocity(frame)) < 0;
}

double frictionForce(const ContactState& state) {
  if (!(state.muInterface > 0)) return state.tangentialForce;
  return std::abs(totalFriction(state)) * state.normalForce;
}

bool isDrawable(const Frame& frame) {
  const std::size_t n = frame.lineHeight.size();
  return n > 0 && frame.surfaceHeight.size() == n && frame.pressure.size() == n &&
         frame.spacing > 0 && std::isfinite(frame.spacing);
}

double periodLength(const Frame& frame) {
  return frame.spacing * static_cast<double>(frame.lineHeight.size());
}

PointRange pointsWithin(const Frame& frame, double left, double width) {
  const double first = std::floor(left / frame.spacing) - 1;
  const double last = std::ceil((left + width) / frame.spacing) + 1;
  if (!(std::abs(first) < kFarthest) || !(std::abs(last) < kFarthest)) return {};
  return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

std::vector<CurveVertex> decimated(const Frame& frame, const std::vector<double>& heights,
                                   PointRange range, const Columns& columns,
                                   const std::vector<double>& values) {
  const PeriodicPoints points(frame, heights, values);
  const bool everyPoint = fitsEveryPoint(frame, columns);
  std::vector<CurveVertex> curve;
  ColumnExtremes extremes;
  double present = 0;
  for (std::int64_t i = range.first; i <= range.last; ++i) {
    const CurveVertex vertex = points.at(i);
    const double here = column(vertex, columns);
    if (everyPoint || here != present) extremes.flushInto(curve);
    present = here;
    extremes.add(vertex);
  }
  extremes.flushInto(curve);
  return curve;
}

std::vector<std::vector<CurveVertex>> intervalsAbove(const Frame& frame, PointRange range,
                                                     const Columns& columns,
                                                     const std::vector<double>& values,
                                                     double least) {
  if (values.size() != frame.surfaceHeight.size()) return {};
  const PeriodicPoints points(frame, frame.surfaceHeight, values);
  IntervalCollector collector(columns, fitsEveryPoint(frame, columns));
  for (std::int64_t i = range.first; i <= range.last; ++i)
    if (points.isAbove(i, least)) collector.add(i, points.at(i));
  return collector.take();
}

// ---- Narrow contacts

namespace {

/// Goes once around the period, and again as far as an interval continues.
bool hasInterval(const Frame& frame, double metres) {
  const std::size_t n = frame.pressure.size();
  const double most = static_cast<double>(2 * n);
  // Returns the width in points: at least two, because one point alone would be an interval.
  const double wide = std::max(1.0, std::min(metres / frame.spacing, most));
  const double apart = std::max(1.0, 0.25 * wide);
  std::size_t first = 0, last = 0;
  bool within = false;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    if (!(frame.pressure[i % n] > 0)) continue;
    if (!within || static_cast<double>(i - last) > apart) first = i;
    within = true;
    last = i;
    if (static_cast<double>(last - first) >= wide) return true;
    if (i >= n && first >= n) break;  // an interval that was counted before
  }
  return false;
}

std::optional<std::size_t> greatestPressurePoint(const Frame& frame) {
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < frame.pressure.size(); ++i)
    if (frame.pressure[i] > (most ? frame.pressure[*most] : 0.0)) most = i;
  return most;
}

std::optional<std::size_t> smallestGap(const Frame& frame) {
  std::optional<std::size_t> closest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame.lineHeight.size(); ++i) {
    const double gap = frame.lineHeight[i] - frame.surfaceHeight[i];
    if (!(gap < least)) continue;
    least = gap;
    closest = i;
  }
  return closest;
}

}  // namespace

std::optional<std::size_t> narrowContact(const Frame& frame, double metres) {
  if (!isDrawable(frame) || hasInterval(frame, metres)) return std::nullopt;
  if (const auto point = greatestPressurePoint(frame)) return point;
  const bool touches = frame.state.normalForce > 0 || frame.state.contactFraction > 0;
  return touches ? smallestGap(frame) : std::nullopt;
}

bool pointsBearLoad(const Frame& frame) {
  return !std::isnan(frame.steadyPressure);
}

double greatestPressure(const Frame& frame) {
  if (!pointsBearLoad(frame)) return 0;
  double greatest = 0;
  for (const double p : frame.pressure)
    if (std::isfinite(p)) greatest = std::max(greatest, p);
  return greatest;
}

}  // namespace asperity
