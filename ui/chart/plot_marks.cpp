#include "ui/chart/plot_marks.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

QPolygonF cornersOf(PlotMark mark) {
  switch (mark) {
    case PlotMark::Square:
      return QPolygonF({{-0.89, -0.89}, {0.89, -0.89}, {0.89, 0.89}, {-0.89, 0.89}});
    case PlotMark::Triangle:
      return QPolygonF({{0, -1.28}, {1.14, 0.7}, {-1.14, 0.7}});
    case PlotMark::Diamond:
      return QPolygonF({{0, -1.3}, {1.16, 0}, {0, 1.3}, {-1.16, 0}});
    case PlotMark::Circle:
      break;
  }
  return {};
}

}  // namespace

double markScale(const QFont& font) {
  constexpr double kUsual = 17;  // pixels, a line of a desktop's letters
  return std::max(1.0, QFontMetricsF(font).height() / kUsual);
}

QColor colourOf(const PlotSeries& series, const PlotColours& colours) {
  if (series.place >= 0)
    return colours.pinned[static_cast<std::size_t>(series.place) % colours.pinned.size()];
  return series.style == PlotStyle::Line ? colours.line : colours.points;
}

void paintMark(QPainter& painter, PlotMark mark, QPointF centre, double radius) {
  if (mark == PlotMark::Circle) return painter.drawEllipse(centre, radius, radius);
  QPolygonF corners = cornersOf(mark);
  for (QPointF& corner : corners) corner = centre + radius * corner;
  painter.drawPolygon(corners);
}

void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap) {
  const auto sharp = [](double pixel) { return std::floor(pixel) + 0.5; };  // covers whole pixels
  const double middle = sharp(x);
  painter.drawLine(QPointF(middle, top), QPointF(middle, bottom));
  for (const double y : {sharp(top), sharp(bottom)})
    painter.drawLine(QPointF(middle - cap, y), QPointF(middle + cap, y));
}

}  // namespace asperity
