#include "ui/chart/chart_geometry.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "ui/draw/shapes.h"

namespace asperity {

namespace {

constexpr double kNarrowest = 0.1, kWidest = 60;  // decades, of a zoomed axis

double fraction(double position, const AxisRange& range) {
  return (position - range.from) / (range.isEmpty() ? 1 : range.size());
}

AxisRange scaled(const AxisRange& range, double about, double factor) {
  const double size = std::clamp(range.size() * factor, kNarrowest, kWidest);
  const double from = about - (about - range.from) * (size / range.size());
  return {from, from + size};
}

AxisRange moved(const AxisRange& range, double by) {
  return {range.from + by, range.to + by};
}

AxisRange clamped(const AxisRange& range, const AxisRange& whole) {
  if (range.isEmpty() || whole.isEmpty()) return range;
  const double least = std::min(0.5 * range.size(), whole.size());
  const double from = std::clamp(range.from, whole.from + least - range.size(), whole.to - least);
  return from == range.from ? range : AxisRange{from, from + range.size()};
}

/// Finds the nearest drawn point of a diagram's curves; the upper one where two coincide.
void findPoint(const ChartGeometry& geometry, const Diagram& diagram, bool isStrip,
               QPointF position, ChartTarget& target) {
  double nearest = kPointReach * geometry.scale;
  for (std::size_t s = 0; s < diagram.series.size(); ++s) {
    const DiagramSeries& series = diagram.series[s];
    if (series.mark == SeriesMark::None || series.id == -1) continue;
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const QPointF at = geometry.at(series.points[i].x, series.points[i].y);
      if (!isFinite(at) || !geometry.area.adjusted(-1, -1, 1, 1).contains(at)) continue;
      const double away = isStrip ? std::abs(at.x() - position.x()) : QLineF(at, position).length();
      if (away > nearest) continue;
      nearest = away;
      target.series = static_cast<int>(s);
      target.point = static_cast<int>(i);
    }
  }
}

void findSpan(const ChartGeometry& geometry, const Diagram& diagram, QPointF position,
              ChartTarget& target) {
  for (std::size_t i = 0; i < diagram.spans.size(); ++i)
    if (position.x() >= geometry.mapX(diagram.spans[i].from) &&
        position.x() < geometry.mapX(diagram.spans[i].to))
      target.span = static_cast<int>(i);
}

}  // namespace

Box toBox(const QRectF& rect) {
  return {static_cast<float>(rect.x()), static_cast<float>(rect.y()),
          static_cast<float>(rect.width()), static_cast<float>(rect.height())};
}

bool isFinite(QPointF position) {
  return std::isfinite(position.x()) && std::isfinite(position.y());
}

QPointF ChartGeometry::at(double xValue, double yValue) const {
  return {mapX(xValue), mapY(yValue)};
}

double ChartGeometry::mapX(double value) const {
  return pixelX(axisPosition(xScale, value));
}

double ChartGeometry::columnAt(double value) const {
  return std::floor(mapX(value)) + 0.5;
}

double ChartGeometry::mapY(double value) const {
  return isBelow(yScale, value) ? area.bottom() + kBelowAxis * scale
                                : pixelY(axisPosition(yScale, value));
}

double ChartGeometry::xAt(double pixel) const {
  return axisValue(xScale, positionX(pixel));
}

double ChartGeometry::yAt(double pixel) const {
  return axisValue(yScale, positionY(pixel));
}

double ChartGeometry::pixelX(double position) const {
  return area.left() + area.width() * fraction(position, x);
}

double ChartGeometry::pixelY(double position) const {
  return area.bottom() - area.height() * fraction(position, y);
}

double ChartGeometry::positionX(double pixel) const {
  const double part = area.width() > 0 ? (pixel - area.left()) / area.width() : 0;
  return x.from + part * x.size();
}

double ChartGeometry::positionY(double pixel) const {
  const double part = area.height() > 0 ? (area.bottom() - pixel) / area.height() : 0;
  return y.from + part * y.size();
}

ChartTarget targetAt(const std::vector<ChartGeometry>& geometries, const DiagramSheet& sheet,
                     QPointF position) {
  ChartTarget target;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const ChartGeometry& geometry = geometries[i];
    const Diagram& diagram = sheet.diagrams[i];
    const QRectF& area = geometry.area;
    const double reach = i == 0 ? kMarkerReach * geometry.scale : 0;
    if (area.adjusted(-reach, -reach, reach, reach).contains(position)) {
      target.diagram = static_cast<int>(i);
      findPoint(geometry, diagram, i > 0, position, target);
      const auto& marker = diagram.marker;
      target.isMarker =
          marker && !marker->isFixed && std::abs(geometry.mapX(marker->x) - position.x()) <= reach;
      return target;
    }
    if (i == 0 && QRectF(area.left(), area.top() - geometry.names, area.width(), geometry.names)
                      .contains(position)) {
      findSpan(geometry, diagram, position, target);
      return target;
    }
  }
  return target;
}

const DiagramSeries& targetSeries(const DiagramSheet& sheet, const ChartTarget& target) {
  return sheet.diagrams[static_cast<std::size_t>(target.diagram)]
      .series[static_cast<std::size_t>(target.series)];
}

const DiagramPoint& targetPoint(const DiagramSheet& sheet, const ChartTarget& target) {
  return targetSeries(sheet, target).points[static_cast<std::size_t>(target.point)];
}

ZoomAxes axesAt(const ChartGeometry& geometry, QPointF position) {
  const QRectF& area = geometry.area;
  const bool isWithinX = position.x() >= area.left() && position.x() <= area.right();
  const bool isWithinY = position.y() >= area.top() && position.y() <= area.bottom();
  return {isWithinX && position.y() >= area.top(), isWithinY && position.x() <= area.right()};
}

VisibleRange zoomed(const ChartGeometry& geometry, QPointF about, double factor, ZoomAxes axes) {
  VisibleRange range{geometry.x, geometry.y};
  if (axes.x && geometry.area.width() > 0)
    range.x = scaled(geometry.x, geometry.positionX(about.x()), factor);
  if (axes.y && geometry.area.height() > 0)
    range.y = scaled(geometry.y, geometry.positionY(about.y()), factor);
  return range;
}

VisibleRange panned(const ChartGeometry& geometry, QPointF by) {
  const QRectF& area = geometry.area;
  if (!(area.width() > 0) || !(area.height() > 0)) return {geometry.x, geometry.y};
  return {moved(geometry.x, -by.x() / area.width() * geometry.x.size()),
          moved(geometry.y, by.y() / area.height() * geometry.y.size())};
}

VisibleRange clampedTo(const VisibleRange& range, const VisibleRange& whole) {
  return {clamped(range.x, whole.x), clamped(range.y, whole.y)};
}

const DiagramPoint* nextPoint(const Diagram& diagram, int id, double x, bool isForward) {
  const double slack = 1e-9 * std::abs(x);  // a marker at a point may differ by rounding
  const DiagramPoint* best = nullptr;
  for (const DiagramSeries& series : diagram.series) {
    if (series.id != id) continue;
    for (const DiagramPoint& point : series.points) {
      if (!hasPosition(diagram, point)) continue;
      const bool isBeyond = isForward ? point.x > x + slack : point.x < x - slack;
      if (isBeyond && (!best || (point.x < best->x) == isForward)) best = &point;
    }
  }
  return best;
}

bool showsCurves(const VisibleRange& range, const Diagram& diagram) {
  const Box box = toBox({range.x.from, range.y.from, range.x.size(), range.y.size()});
  return std::ranges::any_of(diagram.series, [&](const DiagramSeries& series) {
    Polyline positions;
    for (const DiagramPoint& point : series.points)
      if (hasPosition(diagram, point))
        positions.push_back({static_cast<float>(axisPosition(diagram.x.scale, point.x)),
                             static_cast<float>(axisPosition(diagram.y.scale, point.y))});
    return !clippedTo(box, positions).empty();
  });
}

}  // namespace asperity
