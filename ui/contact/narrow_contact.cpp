#include "ui/contact/narrow_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/contact/decimate.h"

namespace asperity {
namespace {

/// Goes once around the period, and again as far as a stretch continues.
bool hasStretch(const Frame& frame, double metres) {
  const std::size_t n = frame.pressure.size();
  const double most = static_cast<double>(2 * n);
  // Returns the width in points: at least two, because one point alone would be a stretch.
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
    if (i >= n && first >= n) break;  // a stretch that was counted before
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
  if (!isDrawable(frame) || hasStretch(frame, metres)) return std::nullopt;
  if (const auto point = greatestPressurePoint(frame)) return point;
  const bool touches = frame.normalForce > 0 || frame.contactFraction > 0;
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
