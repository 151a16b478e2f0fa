#include "ui/charts/plot_overlay.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kCap = 3.5;         // half the width of an error bar's ends, pixels
constexpr double kRadius = 4;        // of a point
constexpr double kFineGridGap = 24;  // pixels a decade needs for a fine grid

double fraction(double value, const DecadeRange& range) {
  return (std::log10(value) - range.from) / std::max(1, range.to - range.from);
}

}  // namespace

double PlotGeometry::xOf(double value) const {
  return area.left() + area.width() * fraction(value, x);
}

double PlotGeometry::yOf(double value) const {
  return area.bottom() - area.height() * fraction(value, y);
}

void PlotItem::update(const PlotGeometry& geometry, const Plot& plot, const PlotColours& colours) {
  if (geometry.area != geometry_.area) prepareGeometryChange();
  geometry_ = geometry;
  plot_ = plot;
  colours_ = colours;
  QGraphicsItem::update();
}

QRectF PlotItem::boundingRect() const {
  return geometry_.area.adjusted(-8, -20, 8, 8);
}

void FineGridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  QColor colour = colours_.grid;
  colour.setAlphaF(static_cast<float>(colour.alphaF() * 0.45));
  painter->setPen(QPen(colour, 1));
  const QRectF& area = geometry_.area;
  const auto each = [](const DecadeRange& range, double size, auto&& draw) {
    if (size / std::max(1, range.to - range.from) < kFineGridGap) return;
    for (int decade = range.from; decade < range.to; ++decade)
      for (int digit = 2; digit <= 9; ++digit) draw(digit * std::pow(10.0, decade));
  };
  each(geometry_.x, area.width(), [&](double value) {
    const double x = geometry_.xOf(value);
    painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  });
  each(geometry_.y, area.height(), [&](double value) {
    const double y = geometry_.yOf(value);
    painter->drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  });
}

void OverlayItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  painter->save();
  painter->setClipRect(geometry_.area.adjusted(-6, -6, 6, 0));
  for (const PlotSeries& series : plot_.series)
    if (series.style == PlotStyle::Points) {
      painter->setOpacity(series.faded ? kFadedOpacity : 1);
      paintErrorBars(*painter, series);
      paintPoints(*painter, series);
    }
  painter->restore();
  if (plot_.marker) paintMarker(*painter, *plot_.marker);
  if (!plot_.blank.isEmpty()) paintBlank(*painter);
}

void OverlayItem::paintBlank(QPainter& painter) const {
  const int flags = Qt::AlignCenter | Qt::TextWordWrap;
  const QRectF room = geometry_.area.adjusted(12, 8, -12, -8);
  const QRectF text = painter.boundingRect(room, flags, plot_.blank);
  painter.fillRect(text.adjusted(-10, -6, 10, 6), colours_.background);
  painter.setPen(colours_.text);
  painter.drawText(room, flags, plot_.blank);
}

void OverlayItem::paintErrorBars(QPainter& painter, const PlotSeries& series) const {
  painter.setPen(QPen(colours_.points, 1.3));
  for (const PlotPoint& point : plottable(series.points)) {
    if (!(std::isfinite(point.error) && point.error > 0)) continue;
    const double x = geometry_.xOf(point.x);
    const double top = geometry_.yOf(point.y + point.error);
    const double low = point.y - point.error;  // may have no place: then down to the axis
    const double bottom = low > 0 ? geometry_.yOf(low) : geometry_.area.bottom() + kCap;
    painter.drawLine(QPointF(x, top), QPointF(x, bottom));
    for (const double y : {top, bottom})
      painter.drawLine(QPointF(x - kCap, y), QPointF(x + kCap, y));
  }
}

void OverlayItem::paintPoints(QPainter& painter, const PlotSeries& series) const {
  painter.setPen(QPen(colours_.background, 1));
  painter.setBrush(colours_.points);
  for (const PlotPoint& point : plottable(series.points))
    painter.drawEllipse(QPointF(geometry_.xOf(point.x), geometry_.yOf(point.y)), kRadius, kRadius);
}

void OverlayItem::paintMarker(QPainter& painter, const PlotMarker& marker) const {
  if (!isPlottable(marker.x, 1)) return;
  const double x = geometry_.xOf(marker.x);
  const QRectF& area = geometry_.area;
  const double sharp = std::floor(x) + 0.5;  // covers whole pixels
  painter.setPen(QPen(colours_.marker, 1.5));
  painter.drawLine(QPointF(sharp, area.top()), QPointF(sharp, area.bottom()));

  const QFontMetricsF metrics(painter.font());
  const double width = metrics.horizontalAdvance(marker.label);
  const bool left = x + 8 + width > area.right();
  const QPointF baseline(left ? x - 8 - width : x + 8, area.bottom() - 8);
  QColor halo = colours_.background;
  halo.setAlphaF(0.85F);
  painter.fillRect(
      QRectF(baseline.x() - 3, baseline.y() - metrics.ascent(), width + 6, metrics.height()), halo);
  painter.drawText(baseline, marker.label);

  if (!isPlottable(marker.x, marker.y)) return;
  painter.setPen(QPen(colours_.background, 2));
  painter.setBrush(colours_.marker);
  const double y = geometry_.yOf(marker.y);
  if (y > area.top() - 1 && y < area.bottom() + 1) painter.drawEllipse(QPointF(x, y), 6, 6);
}

}  // namespace asperity
