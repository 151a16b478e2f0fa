#include "ui/chart/chart_look.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_colours.h"
#include "ui/chart/marks.h"
#include "ui/draw/fonts.h"

namespace asperity {
namespace {

constexpr double kTheory = 2, kCurve = 1.6;  // widths of lines, times the scale

}  // namespace

QColor ChartLook::background() const {
  return colourOf(theme.background);
}
QColor ChartLook::text() const {
  return colourOf(theme.text);
}
QColor ChartLook::faintText() const {
  return colourOf(theme.faintText);
}
QColor ChartLook::axis() const {
  return mixed(background(), text(), 0.5);
}
QColor ChartLook::grid() const {
  return mixed(background(), text(), isDark(theme) ? 0.19 : 0.14);
}
QColor ChartLook::fineGrid() const {
  return mixed(background(), grid(), 0.55);
}
QColor ChartLook::span() const {
  return mixed(background(), text(), isDark(theme) ? 0.06 : 0.04);
}
QColor ChartLook::shade() const {
  QColor colour = colourOf(theme.highlight);
  colour.setAlphaF(0.1F);
  return colour;
}
QColor ChartLook::marker() const {
  return colourOf(seriesColour(1, theme));
}
QColor ChartLook::of(const DiagramSeries& series) const {
  return series.isTheory ? text() : colourOf(seriesColour(series.colour, theme));
}
double ChartLook::scale() const {
  return markScale(font);
}
double ChartLook::line() const {
  return QFontMetricsF(font).height();
}

double markScale(const QFont& font) {
  constexpr double kUsual = 17;  // pixels, height of a usual line of text on a desktop
  return std::max(1.0, QFontMetricsF(font).height() / kUsual);
}

void paintMark(QPainter& painter, SeriesMark mark, QPointF centre, double size) {
  const std::vector<Place> corners =
      markCorners(mark, {static_cast<float>(centre.x()), static_cast<float>(centre.y())},
                  static_cast<float>(size));
  if (corners.empty()) return painter.drawEllipse(centre, size / 2, size / 2);
  QPolygonF polygon;
  for (const Place& corner : corners) polygon += QPointF(corner.x, corner.y);
  painter.drawPolygon(polygon);
}

void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap) {
  const auto sharp = [](double pixel) {
    return std::floor(pixel) + 0.5;
  };  // the line covers whole pixels
  const double middle = sharp(x);
  painter.drawLine(QPointF(middle, top), QPointF(middle, bottom));
  for (const double y : {sharp(top), sharp(bottom)})
    painter.drawLine(QPointF(middle - cap, y), QPointF(middle + cap, y));
}

QPen strokeOf(const DiagramSeries& series, const ChartLook& look) {
  QPen pen(look.of(series), (series.isTheory ? kTheory : kCurve) * look.scale());
  if (series.stroke == SeriesStroke::None) pen.setStyle(Qt::NoPen);
  if (series.stroke == SeriesStroke::Dashed) pen.setStyle(Qt::DashLine);
  if (series.stroke == SeriesStroke::Dotted) pen.setStyle(Qt::DotLine);
  return pen;
}

}  // namespace asperity
