#include "core/run/minimum_span.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kFrictionFloor = 10;  // ripples, of which a strip then shows a third at most
constexpr double kMost = 0.5;          // of the value
constexpr double kAir = 0.12;          // of the range, on either side

}  // namespace

MinimumSpan minimumSpan(std::span<const TransientSample> samples, double spacing, double period) {
  double length = 0, fraction = 0, count = 0;
  for (const TransientSample& sample : samples) {
    if (!(sample.contactLength > 0)) continue;
    length += sample.contactLength;
    fraction += sample.contactFraction;
    ++count;
  }
  if (!(count > 0) || !(spacing > 0)) return {};
  length /= count;
  const double contacts = std::max(1.0, fraction / count * period / length);
  const double ripple = spacing / length / std::sqrt(contacts);
  const double floor = std::min(kFrictionFloor * ripple, kMost);
  return {floor, std::min(ripple, kMost), floor};
}

AxisEnds axisEnds(double low, double high, double least) {
  const double middle = 0.5 * (low + high);
  const double size = std::max(high - low, least * std::abs(middle));
  if (!(size > 0)) return {middle - 1, middle + 1};
  const double half = (0.5 + kAir) * size;
  return {middle - half, middle + half};
}

}  // namespace asperity
