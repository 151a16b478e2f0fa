#include "ui/chart/chart_marker.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr double kDot = 6;           // radius of the marker's dot
constexpr double kTipPad = 7;        // around a reading's text
constexpr double kTipDistance = 14;  // from the point to its reading
constexpr double kRing = 7.5;        // radius, around the point that is read

}  // namespace

QRectF MarkerItem::update(const ChartGeometry& geometry, const std::optional<DiagramMarker>& marker,
                          double lineX, const ChartStyle& style, const QList<QRectF>& taken,
                          const QRectF& sentence) {
  const QRectF before = std::exchange(drawn_, {});
  geometry_ = geometry;
  sentence_ = sentence;
  marker_ = marker;
  style_ = style;
  label_ = QRectF();
  if (marker_) {
    makeTrace();
    if (std::isfinite(geometry.mapX(marker_->x))) placeLine(lineX, taken);
  }
  if (const QRectF needed = drawn_ | geometry.area; !bounds_.contains(needed)) {
    prepareGeometryChange();
    bounds_ = needed;
  }
  return before | drawn_;
}

/// Places the line, the dot and the label.
void MarkerItem::placeLine(double lineX, const QList<QRectF>& taken) {
  lineX_ = geometry_.mapX(std::isfinite(lineX) ? lineX : marker_->x);
  const QRectF& area = geometry_.area;
  label_ = labelRect(taken);
  const double dot = geometry_.mapX(marker_->x), around = kDot * geometry_.scale + 2;
  drawn_ |= QRectF(std::min(lineX_, dot), area.top(), std::abs(lineX_ - dot), area.height())
                .adjusted(-around, -around, around, around) |
            label_;
}

/// Returns the rectangle of the label at the foot of the line: on its right or on its left,
/// otherwise above the text there; at the head of the line where the text would cover the curve.
QRectF MarkerItem::labelRect(const QList<QRectF>& taken) const {
  const QRectF& area = geometry_.area;
  const QFontMetricsF metrics(style_.font);
  const double width = metrics.horizontalAdvance(QString::fromStdString(marker_->label.text)) + 6;
  const double away = 8 * geometry_.scale;
  const double foot = area.bottom() - away + metrics.descent();
  const QRectF right(lineX_ + away - 3, foot - metrics.height(), width, metrics.height());
  const QRectF left = right.translated(-width - 2 * away + 6, 0);
  const bool fitsRight = right.right() - 3 <= area.right(), fitsLeft = left.left() >= area.left();
  const auto touches = [away](const QRectF& text, const QRectF& position) {
    return text.adjusted(-away, -away / 2, away, away / 2).intersects(position);
  };
  const auto isFree = [&](const QRectF& position) {
    return std::ranges::none_of(taken, [&](const QRectF& text) { return touches(text, position); });
  };
  const double dot = geometry_.at(marker_->x, marker_->y).y(), around = kDot * geometry_.scale;
  const auto isOnCurve = [&](const QRectF& position) {
    return position.top() < dot + around && position.bottom() > dot - around;
  };
  if (fitsRight && isFree(right) && !isOnCurve(right)) return right;
  if (fitsLeft && isFree(left) && !isOnCurve(left)) return left;
  QRectF lifted = fitsRight ? right : left;
  for (const QRectF& text : taken)
    if (touches(text, lifted)) lifted.moveBottom(text.top() - away / 2);
  QRectF head = fitsRight ? right : left;
  head.moveTop(area.top() + away - 3);
  if (isOnCurve(lifted) && !isOnCurve(head) && isFree(head)) return head;
  return lifted.top() >= area.top() ? lifted : fitsRight ? right : left;
}

/// Makes the trace of the marker from the points that the axes can show.
void MarkerItem::makeTrace() {
  trace_.clear();
  bool wasShown = false;
  for (const DiagramPoint& point : marker_->trace) {
    const QPointF at = geometry_.at(point.x, point.y);
    const bool isShown = isFinite(at);
    if (isShown && wasShown)
      trace_.lineTo(at);
    else if (isShown)
      trace_.moveTo(at);
    wasShown = isShown;
  }
  if (!trace_.isEmpty()) drawn_ = geometry_.area;
}

void MarkerItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QRectF& area = geometry_.area;
  if (drawn_.isEmpty()) return;
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setOpacity(marker_->isFaded ? kFadedOpacity : 1);
  paintTrace(*painter);
  if (label_.isEmpty() || lineX_ < area.left() - 1 || lineX_ > area.right() + 1) return;
  paintLine(*painter);
  painter->setFont(style_.font);
  QColor halo = style_.background();
  halo.setAlphaF(0.85F);
  painter->fillRect(label_, halo);
  paintText(*painter, label_, Qt::AlignCenter, QString::fromStdString(marker_->label.text));

  painter->setPen(QPen(style_.background(), 2));
  painter->setBrush(style_.marker());
  const QPointF dot = geometry_.at(marker_->x, marker_->y);
  if (isFinite(dot) && area.adjusted(-1, -1, 1, 1).contains(dot)) {
    const double radius = kDot * geometry_.scale;
    painter->drawEllipse(dot, radius, radius);
  }
}

void MarkerItem::paintLine(QPainter& painter) const {
  const QRectF& area = geometry_.area;
  const double x = std::floor(lineX_) + 0.5;  // the line covers whole pixels
  painter.setPen(QPen(style_.marker(), 1.5 * geometry_.scale));
  const bool isInterrupted = x > sentence_.left() && x < sentence_.right();
  painter.drawLine(QPointF(x, area.top()),
                   QPointF(x, isInterrupted ? sentence_.top() : area.bottom()));
  if (isInterrupted) painter.drawLine(QPointF(x, sentence_.bottom()), QPointF(x, area.bottom()));
}

void MarkerItem::paintTrace(QPainter& painter) const {
  if (trace_.isEmpty()) return;
  QColor colour = style_.marker();
  colour.setAlphaF(0.75F);
  painter.save();
  painter.setClipRect(geometry_.area);
  painter.setPen(QPen(colour, 1.6 * geometry_.scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(trace_);
  painter.restore();
}

namespace {

/// Returns the box of a text at the side of a point where it covers the fewest of these rectangles,
/// within the bounds.
QRectF placeBeside(QPointF point, QSizeF size, double away, const QRectF& bounds,
                   const QList<QRectF>& avoided) {
  const auto clamped = [](double position, double from, double to) {
    return std::clamp(position, from, std::max(from, to));
  };
  QRectF best;
  qsizetype fewest = avoided.size() + 2;
  // The text's centre relative to the point, in parts of their distance: above and below come
  // first, because curves go on to the sides.
  for (const auto& [right, down] :
       {std::pair{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}) {
    const QPointF centre(point.x() + right * (away + size.width() / 2),
                         point.y() + down * (away + size.height() / 2));
    const QRectF box(
        QPointF(
            clamped(centre.x() - size.width() / 2, bounds.left(), bounds.right() - size.width()),
            clamped(centre.y() - size.height() / 2, bounds.top(), bounds.bottom() - size.height())),
        size);
    const qsizetype covered =
        (box.contains(point) ? 1 : 0) +
        std::ranges::count_if(avoided, [&](const QRectF& each) { return each.intersects(box); });
    if (covered >= fewest) continue;
    fewest = covered;
    best = box;
  }
  return best;
}

}  // namespace

/// Shows the text beside its point.
void TipItem::show(const QString& text, QPointF position, bool ringed, const QRectF& bounds,
                   const ChartStyle& style, const QList<QRectF>& avoided) {
  prepareGeometryChange();
  text_ = text;
  position_ = position;
  isRinged_ = ringed;
  style_ = style;
  const double widest = bounds.width() - 4 * kTipPad;
  double most = std::min(360.0 * style_.scale(), widest);
  lines_ = QStaticText(richText(text).replace('\n', QLatin1String("<br>")));
  lines_.setTextFormat(Qt::RichText);
  lines_.prepare({}, style_.font);
  const auto layOut = [&] {
    lines_.setTextWidth(most);
    lines_.prepare({}, style_.font);
  };
  if (lines_.size().width() > most) layOut();
  // A long text becomes wider than usual where the chart is too low for it.
  while (lines_.size().height() + 2 * kTipPad > bounds.height() && most < widest) {
    most = std::min(1.2 * most, widest);
    layOut();
  }
  const QSizeF size = lines_.size() + QSizeF(2 * kTipPad, 2 * kTipPad);
  const double away = kTipDistance * style_.scale(), ring = kRing * style_.scale() + 2;
  box_ = placeBeside(position, size, away, bounds, avoided);
  bounds_ = box_.adjusted(-2, -2, 2, 2);
  if (ringed) bounds_ |= QRectF(position.x() - ring, position.y() - ring, 2 * ring, 2 * ring);
  QGraphicsItem::update();
}

void TipItem::clear() {
  if (text_.isEmpty()) return;
  prepareGeometryChange();
  text_.clear();
  bounds_ = QRectF();
}

void TipItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (text_.isEmpty()) return;
  painter->setFont(style_.font);
  painter->setRenderHint(QPainter::Antialiasing);
  if (isRinged_) {
    painter->setPen(QPen(style_.text(), 1.6 * style_.scale()));
    painter->setBrush(Qt::NoBrush);
    painter->drawEllipse(position_, kRing * style_.scale(), kRing * style_.scale());
  }
  painter->setPen(QPen(style_.axis(), 1));
  painter->setBrush(style_.background());
  painter->drawRoundedRect(box_, 5, 5);
  painter->setPen(style_.text());
  painter->drawStaticText(box_.topLeft() + QPointF(kTipPad, kTipPad), lines_);
}

}  // namespace asperity
