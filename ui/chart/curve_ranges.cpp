#include "ui/chart/curve_ranges.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

void addCurve(const NamedCurve& curve, const CurveSet& set, CurveExtents& extents) {
  for (const CurvePoint& point : curve.points) {
    extents.along.add(axisPosition(set.scaleOfX(), abscissa(point, curve.scene, set)));
    if (point.realizations < 1) continue;
    const double value = ordinate(point, set);
    extents.up.add(axisPosition(set.scaleOfY(), value));
    const double error = point.muStandardError * perFriction(set.quantity(), point);
    if (isCoefficient(set.y) && point.mu > 0)
      extents.up.add(axisPosition(set.scaleOfY(), value + error));
  }
}

/// Returns the range that contains both; the other one where one is empty.
AxisRange united(const AxisRange& a, const AxisRange& b) {
  if (a.isEmpty()) return b;
  if (b.isEmpty()) return a;
  return {std::min(a.from, b.from), std::max(a.to, b.to)};
}

}  // namespace

CurveExtents curveExtents(const CurveSet& set) {
  CurveExtents extents;
  addCurve(set.present, set, extents);
  for (const NamedCurve& curve : set.pinned) addCurve(curve, set, extents);
  const auto [velocity, friction] = axesFactors(set.present.points, set.axes);
  for (const CurvePoint& point : set.present.points) {
    if (set.y == CurveQuantity::Mu)
      extents.up.add(axisPosition(set.scaleOfY(), point.muLaw * friction));
    if (showsTotal(set) && point.realizations > 0)
      extents.up.add(
          axisPosition(set.scaleOfY(), totalMu(point) * perFriction(set.quantity(), point)));
  }
  for (const MeasuredCurve& measured : set.measured)
    for (std::size_t i = 0; i < measured.abscissas.size(); ++i) {
      const double factor = measuredFactor(measured, i, set, {velocity, friction});
      extents.along.add(axisPosition(set.scaleOfX(), measured.abscissas[i] * velocity));
      extents.up.add(axisPosition(set.scaleOfY(), measured.data.points[i].mu * factor));
    }
  return extents;
}

AxisRange rangeAround(const Extent& positions, AxisScale scale, double factor) {
  if (positions.isEmpty()) return {};
  if (scale == AxisScale::Linear) {
    constexpr double kRelativeMargin = 0.04;
    const auto [least, most] = positions;
    const double size = positions.size();
    const double around = most != 0 ? std::abs(most) : 1;  // where all positions are the same
    const double margin = size > 0 ? kRelativeMargin * size : around / 2;
    return {least >= 0 && least < size / 2 ? 0 : least - margin, most + margin};
  }
  // The binary value of 1e-5 may lie a little below the decade; this must not add another decade.
  constexpr double kSlack = 1e-9;
  const double margin = std::log10(factor);
  AxisRange range{std::floor(positions.least - margin + kSlack),
                  std::ceil(positions.most + margin - kSlack)};
  if (range.isEmpty()) range.to = range.from + 1;
  return range;
}

AxisRange grownRange(const AxisRange& shown, const AxisRange& needed) {
  constexpr double kSpare = 0.15;  // of the whole range
  AxisRange next = united(shown, needed);
  if (shown.isEmpty()) return next;
  const double spare = kSpare * (next.to - next.from);
  if (next.to > shown.to) next.to += spare;
  if (next.from < shown.from && next.from != 0) next.from -= spare;
  return next;
}

AxisRange steadyRange(const AxisRange& shown, const AxisRange& needed, bool mayShrink) {
  AxisRange next = united(shown, needed);
  if (!mayShrink || needed.isEmpty()) return next;
  if (needed.from - next.from >= 2) next.from = needed.from;
  if (next.to - needed.to >= 2) next.to = needed.to;
  return next;
}

void setRange(DiagramAxis& axis, const AxisRange& range) {
  if (range.isEmpty()) return;
  axis.from = axisValue(axis.scale, range.from);
  axis.to = axisValue(axis.scale, range.to);
}

}  // namespace asperity
