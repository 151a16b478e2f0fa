#include "ui/chart/plot_geometry.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kNarrowest = 0.1, kWidest = 60;  // decades

double fraction(double value, const DecadeRange& range) {
  return (std::log10(value) - range.from) / (range.isEmpty() ? 1 : range.size());
}

DecadeRange scaled(const DecadeRange& range, double about, double factor) {
  const double size = std::clamp(range.size() * factor, kNarrowest, kWidest);
  const double from = about - (about - range.from) * (size / range.size());
  return {from, from + size};
}

DecadeRange moved(const DecadeRange& range, double by) {
  return {range.from + by, range.to + by};
}

DecadeRange held(const DecadeRange& range, const DecadeRange& whole) {
  if (range.isEmpty() || whole.isEmpty()) return range;
  const double least = std::min(0.5 * range.size(), whole.size());
  const double from = std::clamp(range.from, whole.from + least - range.size(), whole.to - least);
  return from == range.from ? range : DecadeRange{from, from + range.size()};
}

double distance(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// The nearest drawn point of the curves, the upper one where they lie on each other.
void findPoint(const PlotGeometry& geometry, const Plot& plot, QPointF place, PlotTarget& target) {
  double nearest = kPointReach * geometry.scale;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    if (plot.series[s].style != PlotStyle::Points) continue;
    for (std::size_t i = 0; i < plot.series[s].points.size(); ++i) {
      const PlotPoint& point = plot.series[s].points[i];
      if (!isPlottable(point.x, point.y)) continue;
      const QPointF at(geometry.xOf(point.x), geometry.yOf(point.y));
      if (!geometry.area.adjusted(-1, -1, 1, 1).contains(at) || distance(at, place) > nearest)
        continue;
      nearest = distance(at, place);
      target.series = static_cast<int>(s);
      target.point = static_cast<int>(i);
    }
  }
}

/// In the strip the nearest along x counts: it is too slim to aim in.
void findStripPoint(const PlotGeometry& geometry, const PlotStrip& strip, QPointF place,
                    PlotTarget& target) {
  double nearest = kPointReach * geometry.scale;
  for (std::size_t i = 0; i < strip.points.size(); ++i) {
    if (!isPlottable(strip.points[i].x, 1)) continue;
    const double away = std::abs(geometry.xOf(strip.points[i].x) - place.x());
    if (away > nearest) continue;
    nearest = away;
    target.stripPoint = static_cast<int>(i);
  }
}

void findSpan(const PlotGeometry& geometry, const Plot& plot, QPointF place, PlotTarget& target) {
  for (std::size_t i = 0; i < plot.spans.size(); ++i)
    if (place.x() >= geometry.xOf(plot.spans[i].from) && place.x() < geometry.xOf(plot.spans[i].to))
      target.span = static_cast<int>(i);
}

/// Whether the straight line between two points on logarithmic axes passes through the window.
bool crosses(const PlotWindow& window, const PlotPoint& a, const PlotPoint& b) {
  const double ax = std::log10(a.x), ay = std::log10(a.y);
  const double dx = std::log10(b.x) - ax, dy = std::log10(b.y) - ay;
  double from = 0, to = 1;  // the part of it within the ends of both axes
  const auto cut = [&](double start, double way, const DecadeRange& range) {
    if (way == 0) {
      if (start < range.from || start > range.to) to = -1;
      return;
    }
    const double one = (range.from - start) / way, other = (range.to - start) / way;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  };
  cut(ax, dx, window.x);
  cut(ay, dy, window.y);
  return from <= to;
}

}  // namespace

double PlotGeometry::xOf(double value) const {
  return area.left() + area.width() * fraction(value, x);
}

double PlotGeometry::yOf(double value) const {
  return area.bottom() - area.height() * fraction(value, y);
}

double PlotGeometry::valueAt(double pixel) const {
  const double part = area.width() > 0 ? (pixel - area.left()) / area.width() : 0;
  return std::pow(10, x.from + part * x.size());
}

PlotTarget targetAt(const PlotGeometry& geometry, const Plot& plot, QPointF place) {
  PlotTarget target;
  const QRectF& area = geometry.area;
  const double reach = kMarkerReach * geometry.scale;
  if (area.adjusted(-reach, -reach, reach, reach).contains(place)) {
    findPoint(geometry, plot, place, target);
    target.isMarker = plot.marker && !plot.marker->isFixed && isPlottable(plot.marker->x, 1) &&
                      std::abs(geometry.xOf(plot.marker->x) - place.x()) <= reach;
  } else if (QRectF(area.left(), area.top() - geometry.names, area.width(), geometry.names)
                 .contains(place)) {
    findSpan(geometry, plot, place, target);
  } else if (plot.strip && geometry.strip.contains(place)) {
    findStripPoint(geometry, *plot.strip, place, target);
  }
  return target;
}

ZoomAxes axesAt(const PlotGeometry& geometry, QPointF place) {
  const QRectF& area = geometry.area;
  const bool isAlong = place.x() >= area.left() && place.x() <= area.right();
  const bool isUp = place.y() >= area.top() && place.y() <= area.bottom();
  return {isAlong && place.y() >= area.top(), isUp && place.x() <= area.right()};
}

PlotWindow zoomed(const PlotGeometry& geometry, QPointF about, double factor, ZoomAxes axes) {
  const QRectF& area = geometry.area;
  PlotWindow window{geometry.x, geometry.y};
  if (axes.x && area.width() > 0) {
    const double at =
        geometry.x.from + (about.x() - area.left()) / area.width() * geometry.x.size();
    window.x = scaled(geometry.x, at, factor);
  }
  if (axes.y && area.height() > 0) {
    const double at =
        geometry.y.from + (area.bottom() - about.y()) / area.height() * geometry.y.size();
    window.y = scaled(geometry.y, at, factor);
  }
  return window;
}

PlotWindow panned(const PlotGeometry& geometry, QPointF by) {
  const QRectF& area = geometry.area;
  if (!(area.width() > 0) || !(area.height() > 0)) return {geometry.x, geometry.y};
  return {moved(geometry.x, -by.x() / area.width() * geometry.x.size()),
          moved(geometry.y, by.y() / area.height() * geometry.y.size())};
}

PlotWindow heldWithin(const PlotWindow& window, const PlotWindow& whole) {
  return {held(window.x, whole.x), held(window.y, whole.y)};
}

bool showsCurves(const PlotWindow& window, const Plot& plot) {
  for (const PlotSeries& series : plot.series) {
    const std::vector<PlotPoint> points = plottable(series.points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (crosses(window, points[i], points[std::min(i + 1, points.size() - 1)])) return true;
  }
  return false;
}

}  // namespace asperity
