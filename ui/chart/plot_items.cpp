#include "ui/chart/plot_items.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/chart/plot_marks.h"

namespace asperity {

namespace {

constexpr double kRadius = 4;        // of a point, where there is room
constexpr double kAside = 4;         // pixels between a shade's edges and its name
constexpr double kGridGap = 6;       // pixels between whole decades, at least
constexpr double kFineGridGap = 24;  // pixels a decade needs for a fine grid

/// Of the points of one curve, so that they do not touch.
double radiusOf(const PlotSeries& series, const PlotGeometry& geometry) {
  const double most = kRadius * geometry.scale;
  if (series.points.size() < 2) return most;
  const double apart = (geometry.xOf(series.points.back().x) - geometry.xOf(series.points[0].x)) /
                       static_cast<double>(series.points.size() - 1);
  return std::clamp(0.42 * apart, 1.5, most);
}

/// Of a grid: at whole decades, and at the digits between them.
struct Lines {
  QList<QLineF> whole, fine;
};

/// line: of a value.
template <class Line>
void addLines(Lines& lines, const DecadeRange& range, double size, const Line& line) {
  if (range.isEmpty() || size / range.size() < kGridGap) return;
  const int most = size / range.size() < kFineGridGap ? 1 : 9;
  for (double decade = std::floor(range.from); decade <= range.to; ++decade)
    for (int digit = 1; digit <= most; ++digit) {
      const double place = decade + std::log10(digit);
      if (place < range.from || place > range.to) continue;
      (digit == 1 ? lines.whole : lines.fine) += line(std::pow(10.0, place));
    }
}

Lines linesOf(const PlotGeometry& geometry) {
  const QRectF& area = geometry.area;
  Lines lines;
  addLines(lines, geometry.x, area.width(), [&](double value) {
    const double x = std::floor(geometry.xOf(value)) + 0.5;
    return QLineF(x, area.top(), x, area.bottom());
  });
  addLines(lines, geometry.y, area.height(), [&](double value) {
    const double y = std::floor(geometry.yOf(value)) + 0.5;
    return QLineF(area.left(), y, area.right(), y);
  });
  return lines;
}

}  // namespace

void PlotItem::update(const PlotGeometry& geometry, const Plot& plot, const PlotColours& colours) {
  if (geometry.area != geometry_.area || geometry.strip != geometry_.strip) prepareGeometryChange();
  geometry_ = geometry;
  plot_ = plot;
  colours_ = colours;
  QGraphicsItem::update();
}

QRectF PlotItem::boundingRect() const {
  const double beyond = 8 * geometry_.scale;
  return geometry_.area.adjusted(-beyond, -geometry_.names - 2, beyond, beyond);
}

void SpanItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QRectF& area = geometry_.area;
  const QFontMetricsF metrics(painter->font());
  bool shaded = true;
  for (const PlotSpan& span : plot_.spans) {
    const double left = std::clamp(geometry_.xOf(span.from), area.left(), area.right());
    const double right = std::clamp(geometry_.xOf(span.to), area.left(), area.right());
    const QRectF box(left, area.top() - geometry_.names, right - left,
                     area.height() + geometry_.names);
    painter->setOpacity(span.faded ? kFadedOpacity : 1);
    if (shaded) painter->fillRect(box, colours_.span);
    shaded = !shaded;
    const QString whole = span.name + "  " + span.word;
    const bool fits = metrics.horizontalAdvance(whole) + 8 < box.width();
    const QString& text = fits ? whole : span.name;
    if (metrics.horizontalAdvance(text) + 4 > box.width()) continue;
    painter->setPen(colours_.faintText);
    painter->drawText(QRectF(box.left(), box.top(), box.width(), geometry_.names), Qt::AlignCenter,
                      text);
  }
  for (const PlotSpan& shade : plot_.shades) {
    const double left = std::clamp(geometry_.xOf(shade.from), area.left(), area.right());
    const double right = std::clamp(geometry_.xOf(shade.to), area.left(), area.right());
    painter->setOpacity(shade.faded ? kFadedOpacity : 1);
    painter->fillRect(QRectF(left, area.top(), right - left, area.height()), colours_.shade);
    constexpr int kFoot = Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap;
    const QRectF room(left + kAside, area.top(), right - left - 2 * kAside, area.height() - kAside);
    if (!room.contains(metrics.boundingRect(room, kFoot, shade.name))) continue;
    painter->setPen(colours_.faintText);
    painter->drawText(room, kFoot, shade.name);
  }
  painter->setOpacity(1);
}

/// Lines on whole pixels: smoothed ones between pixels would be dull, and take most of the time
/// that painting a diagram takes.
void GridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const bool wasSmooth = painter->testRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::Antialiasing, false);
  const Lines lines = linesOf(geometry_);
  painter->setPen(QPen(colours_.fineGrid, 1));
  painter->drawLines(lines.fine);
  painter->setPen(QPen(colours_.grid, 1));
  painter->drawLines(lines.whole);
  painter->setRenderHint(QPainter::Antialiasing, wasSmooth);
}

void PointsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  painter->save();
  const double beyond = 6 * geometry_.scale;
  painter->setClipRect(geometry_.area.adjusted(-beyond, -beyond, beyond, 0));
  for (const PlotSeries& series : plot_.series)
    if (series.style == PlotStyle::Points) {
      painter->setOpacity(series.faded ? kFadedOpacity : 1);
      paintErrorBars(*painter, series);
      paintPoints(*painter, series);
    }
  painter->restore();
  if (!plot_.blank.isEmpty()) paintBlank(*painter);
}

void PointsItem::paintBlank(QPainter& painter) const {
  const int flags = Qt::AlignCenter | Qt::TextWordWrap;
  const QRectF room = geometry_.area.adjusted(12, 8, -12, -8);
  const QRectF text = painter.boundingRect(room, flags, plot_.blank);
  painter.fillRect(text.adjusted(-10, -6, 10, 6), colours_.background);
  painter.setPen(colours_.text);
  painter.drawText(room, flags, plot_.blank);
}

void PointsItem::paintErrorBars(QPainter& painter, const PlotSeries& series) const {
  const double scale = geometry_.scale;
  painter.setPen(QPen(colourOf(series, colours_), 1.3 * scale));
  for (const PlotPoint& point : plottable(series.points)) {
    if (!(std::isfinite(point.error) && point.error > 0)) continue;
    const double low = point.y - point.error;  // may have no place: then down to the axis
    paintErrorBar(painter, geometry_.xOf(point.x), geometry_.yOf(point.y + point.error),
                  low > 0 ? geometry_.yOf(low) : geometry_.area.bottom() + kRadius * scale,
                  kErrorCap * scale);
  }
}

/// Marks; those of a pinned curve on a thin line, which keeps them together among others.
void PointsItem::paintPoints(QPainter& painter, const PlotSeries& series) const {
  const QColor colour = colourOf(series, colours_);
  const std::vector<PlotPoint> points = plottable(series.points);
  QPolygonF places;
  for (const PlotPoint& point : points)
    places += QPointF(geometry_.xOf(point.x), geometry_.yOf(point.y));
  if (series.isPinned()) {
    painter.setPen(QPen(colour, 1.2 * geometry_.scale));
    painter.drawPolyline(places);
  }
  painter.setPen(QPen(colours_.background, 1));
  painter.setBrush(colour);
  const double radius = radiusOf(series, geometry_);
  for (const QPointF& place : places) paintMark(painter, series.mark, place, radius);
}

}  // namespace asperity
