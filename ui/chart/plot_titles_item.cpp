// The titles of a plot's axes.
#include <QFontMetricsF>
#include <QPainter>

#include "ui/chart/plot_items.h"

namespace asperity {

namespace {

constexpr double kBelowLabels = 8;  // pixels from the plot to the title below it, beside the labels
constexpr double kLeft = 6;         // from the edge to the title at the left

}  // namespace

QString TitlesItem::alongWithin(const Plot& plot, const QFont& font, double width) {
  return QFontMetricsF(font).elidedText(plot.x.title, Qt::ElideRight, width);
}

/// Upright the long title needs more room than the plot may have: then the short one, or the
/// symbol.
QString TitlesItem::uprightWithin(const Plot& plot, const QFont& font, double height) {
  const QFontMetricsF metrics(font);
  const auto fits = [&](const QString& title) {
    return metrics.horizontalAdvance(title) + 4 <= height;
  };
  const QString& brief = plot.y.shortTitle;
  if (fits(plot.y.title) || brief.isEmpty()) return plot.y.title;
  return fits(brief) ? brief : brief.section(' ', -1);
}

QRectF TitlesItem::boundingRect() const {
  const QRectF& area = geometry_.area;
  return area.adjusted(-area.left(), 0, area.left(), 0.5 * area.left() + 60);
}

void TitlesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QRectF& area = geometry_.area;
  const double line = QFontMetricsF(painter->font()).height();
  painter->setPen(colours_.text);
  if (geometry_.strip.isEmpty())  // else it stands below the strip
    painter->drawText(QRectF(area.left(), area.bottom() + kBelowLabels + line, area.width(), line),
                      Qt::AlignCenter | Qt::TextDontClip,
                      alongWithin(plot_, painter->font(), area.width()));
  painter->save();
  painter->translate(kLeft, area.center().y());
  painter->rotate(-90);
  painter->drawText(QRectF(-area.height() / 2, 0, area.height(), line),
                    Qt::AlignCenter | Qt::TextDontClip,
                    uprightWithin(plot_, painter->font(), area.height()));
  painter->restore();
}

}  // namespace asperity
