#include "ui/chart/chart_style.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"

namespace asperity {
namespace {

constexpr double kTheory = 2, kCurve = 1.6;  // widths of lines, times the scale

}  // namespace

QColor ChartStyle::shade() const {
  QColor colour = toQColor(theme.highlight);
  colour.setAlphaF(0.1F);
  return colour;
}
QColor ChartStyle::marker() const {
  return toQColor(seriesColour(1, theme));
}
QColor ChartStyle::curve(const DiagramSeries& series) const {
  return series.isTheory ? text() : toQColor(seriesColour(series.colour, theme));
}
double ChartStyle::scale() const {
  return markScale(font);
}
double ChartStyle::line() const {
  return QFontMetricsF(font).height();
}

double markScale(const QFont& font) {
  constexpr double kDefault = 17;  // pixels, height of a usual line of text on a desktop
  return std::max(1.0, QFontMetricsF(font).height() / kDefault);
}

DiagramSizes tickSizes(const ChartStyle& style) {
  DiagramSizes sizes;
  sizes.unit = static_cast<float>(style.scale());
  sizes.tick = sizes.axis = static_cast<float>(QFontInfo(style.font).pixelSize());
  return sizes;
}

void paintMark(QPainter& painter, SeriesMark mark, QPointF centre, double size) {
  const std::vector<DrawPoint> corners =
      markCorners(mark, {static_cast<float>(centre.x()), static_cast<float>(centre.y())},
                  static_cast<float>(size));
  if (corners.empty()) return painter.drawEllipse(centre, size / 2, size / 2);
  QPolygonF polygon;
  for (const DrawPoint& corner : corners) polygon += QPointF(corner.x, corner.y);
  painter.drawPolygon(polygon);
}

void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap) {
  // The line covers whole pixels.
  const auto sharp = [](double pixel) { return std::floor(pixel) + 0.5; };
  const double middle = sharp(x);
  painter.drawLine(QPointF(middle, top), QPointF(middle, bottom));
  for (const double y : {sharp(top), sharp(bottom)})
    painter.drawLine(QPointF(middle - cap, y), QPointF(middle + cap, y));
}

QPen curvePen(const DiagramSeries& series, const ChartStyle& style) {
  QPen pen(style.curve(series), (series.isTheory ? kTheory : kCurve) * style.scale());
  if (series.stroke == SeriesStroke::None) pen.setStyle(Qt::NoPen);
  if (series.stroke == SeriesStroke::Dashed) pen.setStyle(Qt::DashLine);
  if (series.stroke == SeriesStroke::Dotted) pen.setStyle(Qt::DotLine);
  return pen;
}

}  // namespace asperity
