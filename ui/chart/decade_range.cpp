#include "ui/chart/decade_range.h"

#include <algorithm>
#include <cmath>

#include "ui/draw/ticks.h"

namespace asperity {

namespace {

// 1e-5 written in binary may lie a little below the decade: that is not a reason for one more.
constexpr double kSlack = 1e-9;

}  // namespace

DecadeRange decadesAround(double low, double high) {
  DecadeRange range;
  range.from = std::floor(std::log10(low) + kSlack);
  range.to = std::ceil(std::log10(high) - kSlack);
  if (range.isEmpty()) range.to = range.from + 1;
  return range;
}

DecadeRange steadyRange(const DecadeRange& shown, const DecadeRange& needed, bool mayShrink) {
  if (needed.isEmpty()) return shown;
  if (shown.isEmpty()) return needed;
  DecadeRange next{std::min(shown.from, needed.from), std::max(shown.to, needed.to)};
  if (!mayShrink) return next;
  if (needed.from - next.from >= 2) next.from = needed.from;
  if (next.to - needed.to >= 2) next.to = needed.to;
  return next;
}

QString readingLabel(double value, int digits) {
  return QString::fromStdString(shortNumber(value, digits));
}

}  // namespace asperity
