#include "ui/chart/chart_style.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/draw/fonts.h"

namespace asperity {
namespace {

constexpr double kTheory = 2, kCurve = 1.6;  // widths of lines, times the scale

QColor translucent(const Rgba& opaque, float alpha) {
  QColor colour = toQColor(opaque);
  colour.setAlphaF(alpha);
  return colour;
}

}  // namespace

QColor ChartStyle::span() const {
  return translucent(theme.text, isDark(theme) ? 0.06F : 0.04F);
}

QColor ChartStyle::shade() const {
  return translucent(theme.highlight, kShadeOpacity);
}

QColor ChartStyle::marker() const {
  return toQColor(seriesColour(kMarkerColour, theme));
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

void paintText(QPainter& painter, const QRectF& place, int alignment, const QString& text) {
  const TextRuns runs = withLoweredSigns({{text.toStdString()}});
  if (runs.size() < 2) {
    painter.drawText(place, alignment, text);
    return;
  }
  const QFont font = painter.font();
  QFont small = font;
  small.setPixelSize(qRound(0.72 * QFontInfo(font).pixelSize()));
  const QFontMetricsF metrics(font), smallMetrics(small);
  const auto advance = [&](const TextRun& run) {
    return (run.lowered ? smallMetrics : metrics)
        .horizontalAdvance(QString::fromStdString(run.utf8));
  };
  double width = 0;
  for (const TextRun& run : runs) width += advance(run);
  const double free = place.width() - width;
  double x = place.left() + (alignment & Qt::AlignRight     ? free
                             : alignment & Qt::AlignHCenter ? free / 2
                                                            : 0);
  const double baseline = place.center().y() + (metrics.ascent() - metrics.descent()) / 2;
  for (const TextRun& run : runs) {
    painter.setFont(run.lowered ? small : font);
    painter.drawText(QPointF(x, baseline + (run.lowered ? 0.22 * metrics.ascent() : 0)),
                     QString::fromStdString(run.utf8));
    x += advance(run);
  }
  painter.setFont(font);
}

void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap) {
  // The caps cover whole pixels; between two of them they would be pale.
  const auto sharp = [](double pixel) { return std::floor(pixel) + 0.5; };
  painter.drawLine(QPointF(x, top), QPointF(x, bottom));
  for (const double y : {sharp(top), sharp(bottom)})
    painter.drawLine(QPointF(x - cap, y), QPointF(x + cap, y));
}

QPen curvePen(const DiagramSeries& series, const ChartStyle& style) {
  QPen pen(style.curve(series), (series.isTheory ? kTheory : kCurve) * style.scale());
  if (series.stroke == SeriesStroke::None) pen.setStyle(Qt::NoPen);
  if (series.stroke == SeriesStroke::Dashed) pen.setStyle(Qt::DashLine);
  if (series.stroke == SeriesStroke::Dotted) pen.setStyle(Qt::DotLine);
  return pen;
}

}  // namespace asperity
