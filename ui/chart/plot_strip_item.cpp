// The slim plot below another one: a difference over the same axis.
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/chart/plot_items.h"
#include "ui/chart/plot_marks.h"
#include "ui/chart/tick_label.h"
#include "ui/draw/log_ticks.h"
#include "ui/draw/ticks.h"

namespace asperity {

namespace {

constexpr double kRadius = 3.6;    // of a point
constexpr double kLabelRoom = 44;  // width that a label along needs

}  // namespace

QRectF StripItem::boundingRect() const {
  if (geometry_.strip.isEmpty()) return {};
  const double scale = geometry_.scale;
  return geometry_.strip.adjusted(-geometry_.strip.left(), -40 * scale, 20 * scale, 70 * scale);
}

void StripItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!plot_.strip || geometry_.strip.isEmpty()) return;
  painter->setRenderHint(QPainter::Antialiasing);
  paintAxis(*painter);
  paintAlong(*painter);
  painter->setOpacity(plot_.strip->faded ? kFadedOpacity : 1);
  paintPoints(*painter);
  painter->setOpacity(1);
  paintName(*painter);
}

double StripItem::yOf(double value) const {
  const PlotStrip& strip = *plot_.strip;
  const double part = (value - strip.from) / (strip.to - strip.from);
  return geometry_.strip.bottom() - part * geometry_.strip.height();
}

void StripItem::paintAxis(QPainter& painter) const {
  const QRectF& box = geometry_.strip;
  const double line = QFontMetricsF(painter.font()).height();
  const int most = std::max(2, static_cast<int>(box.height() / (line + 2)));
  const AxisTicks axis = linearTicks(plot_.strip->from, plot_.strip->to, most, "%");
  for (const Tick& tick : axis.ticks) {
    const double y = std::floor(yOf(tick.value)) + 0.5;
    painter.setPen(QPen(tick.value == 0 ? colours_.axis : colours_.grid, 1));
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    painter.setPen(colours_.text);
    painter.drawText(QRectF(0, y - line, box.left() - 7, 2 * line),
                     Qt::AlignRight | Qt::AlignVCenter, labelWithUnit(tick, axis));
  }
  painter.setPen(QPen(colours_.axis, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
}

void StripItem::paintAlong(QPainter& painter) const {
  const QRectF& box = geometry_.strip;
  const double line = QFontMetricsF(painter.font()).height();
  const int most = std::max(2, static_cast<int>(box.width() / (kLabelRoom * geometry_.scale)));
  for (const LogTick& tick : logTicks(geometry_.x.from, geometry_.x.to, most)) {
    const double x = geometry_.xOf(std::pow(10, tick.decade));
    painter.setPen(QPen(colours_.grid, 1));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    painter.setPen(colours_.text);
    painter.drawText(QRectF(x - 3 * line, box.bottom() + 5, 6 * line, line), Qt::AlignCenter,
                     QString::fromStdString(tick.label));
  }
  painter.setPen(colours_.text);
  painter.drawText(QRectF(box.left(), box.bottom() + line + 9, box.width(), line), Qt::AlignCenter,
                   plot_.x.title);
}

/// What lies beyond the range stands as an arrowhead at its edge.
void StripItem::paintPoints(QPainter& painter) const {
  const QRectF& box = geometry_.strip;
  const PlotStrip& strip = *plot_.strip;
  painter.save();
  const double scale = geometry_.scale;
  painter.setClipRect(box.adjusted(-6 * scale, -6 * scale, 6 * scale, 6 * scale));
  for (const PlotPoint& point : strip.points) {
    if (!isPlottable(point.x, 1) || !std::isfinite(point.y)) continue;
    const double x = geometry_.xOf(point.x);
    const bool above = point.y > strip.to, below = point.y < strip.from;
    painter.setBrush(colours_.difference);
    if (above || below) {
      painter.setPen(Qt::NoPen);
      const double edge = above ? box.top() + 1 : box.bottom() - 1, way = (above ? 7 : -7) * scale;
      painter.drawPolygon(
          QPolygonF({{x, edge}, {x - 5 * scale, edge + way}, {x + 5 * scale, edge + way}}));
      continue;
    }
    if (std::isfinite(point.error)) {
      painter.setPen(QPen(colours_.difference, 1.3 * scale));
      paintErrorBar(painter, x, std::max(yOf(point.y + point.error), box.top()),
                    std::min(yOf(point.y - point.error), box.bottom()), 3 * scale);
    }
    painter.setPen(QPen(colours_.background, 1));
    paintMark(painter, PlotMark::Diamond, {x, yOf(point.y)}, kRadius * scale);
  }
  painter.restore();
}

/// Over the strip, where no point comes.
void StripItem::paintName(QPainter& painter) const {
  const QFontMetricsF metrics(painter.font());
  const PlotStrip& strip = *plot_.strip;
  QString text = strip.note.isEmpty() ? strip.name : strip.name + "  ·  " + strip.note;
  const QRectF& box = geometry_.strip;
  text = metrics.elidedText(text, Qt::ElideRight, box.width());
  painter.setPen(colours_.text);
  painter.drawText(
      QRectF(box.left(), box.top() - metrics.height() - 2, box.width(), metrics.height()),
      Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, text);
}

}  // namespace asperity
