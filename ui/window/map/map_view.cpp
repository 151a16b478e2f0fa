#include "ui/window/map/map_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr int kCrossColour = 1;                           // as the marker of a diagram
constexpr int kLines = Qt::AlignLeft | Qt::TextWordWrap;  // of the reading beside the cut

}  // namespace

void MapView::setCross(double x, double y) {
  x_ = x;
  y_ = y;
  hasCross_ = true;
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);  // the arrow keys move the cross
  update();
}

void MapView::setReading(const QString& text) {
  if (text == reading_) return;
  reading_ = text;
  update();
}

/// Returns the frame of the map, which is the last diagram; null where it is not drawn.
const ChartGeometry* MapView::map() const {
  return frames().empty() || !(frames().back().area.width() > 0) ? nullptr : &frames().back();
}

void MapView::moveCross(const QPointF& to) {
  const ChartGeometry* frame = map();
  if (!frame) return;
  const QRectF& area = frame->area;
  setCross(frame->xAt(std::clamp(to.x(), area.left(), area.right())),
           frame->yAt(std::clamp(to.y(), area.top(), area.bottom())));
  emit crossMoved(x_, y_);
}

void MapView::mousePressEvent(QMouseEvent* event) {
  const ChartGeometry* frame = map();
  if (event->button() != Qt::LeftButton || !frame || !frame->area.contains(event->position()))
    return DiagramView::mousePressEvent(event);
  isDragged_ = true;
  moveCross(event->position());
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  if (isDragged_) moveCross(event->position());
  const ChartGeometry* frame = map();
  const bool isOnMap = frame && frame->area.contains(event->position());
  setCursor(isOnMap ? Qt::CrossCursor : Qt::ArrowCursor);
  if (isOnMap)
    emit pointedAt(frame->xAt(event->position().x()), frame->yAt(event->position().y()));
  else
    emit left();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  isDragged_ = false;
  DiagramView::mouseReleaseEvent(event);
}

/// The arrow keys move the cross, in fine steps with Shift.
void MapView::keyPressEvent(QKeyEvent* event) {
  constexpr double kSteps = 50, kFineSteps = 250;  // across the map
  int right = 0, down = 0;
  switch (event->key()) {
    case Qt::Key_Left:
      right = -1;
      break;
    case Qt::Key_Right:
      right = 1;
      break;
    case Qt::Key_Up:
      down = -1;
      break;
    case Qt::Key_Down:
      down = 1;
      break;
    default:
      return DiagramView::keyPressEvent(event);
  }
  const ChartGeometry* frame = map();
  if (!frame || !hasCross_) return;
  const double steps = event->modifiers().testFlag(Qt::ShiftModifier) ? kFineSteps : kSteps;
  moveCross(frame->at(x_, y_) +
            QPointF(right * frame->area.width() / steps, down * frame->area.height() / steps));
}

void MapView::leaveEvent(QEvent* event) {
  DiagramView::leaveEvent(event);
  emit left();
}

void MapView::paintEvent(QPaintEvent* event) {
  DiagramView::paintEvent(event);
  const ChartGeometry* frame = map();
  if (!hasCross_ || !frame) return;
  const QPointF at = frame->at(x_, y_);
  const QRectF& area = frame->area;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(area);
  for (const auto& [colour, broad] :
       {std::pair{kEdgeOnField, kEdgeOnFieldWidth}, std::pair{kLineOnField, kLineOnFieldWidth}}) {
    painter.setPen(QPen(toQColor(colour), static_cast<qreal>(broad)));
    if (std::isfinite(at.x()))
      painter.drawLine(QPointF(at.x(), area.top()), QPointF(at.x(), area.bottom()));
    if (std::isfinite(at.y()))
      painter.drawLine(QPointF(area.left(), at.y()), QPointF(area.right(), at.y()));
  }
  painter.setPen(Qt::NoPen);
  for (const auto& [colour, radius] : {std::pair{kEdgeOnField, 8.0}, std::pair{kLineOnField, 6.7},
                                       std::pair{seriesColour(kCrossColour, theme()), 5.2}}) {
    painter.setBrush(toQColor(colour));
    if (std::isfinite(at.x()) && std::isfinite(at.y())) painter.drawEllipse(at, radius, radius);
  }
  paintReading(painter, area);
}

QRectF MapView::placeBesideCut() const {
  constexpr qreal kGap = 8, kEdge = 4;  // pixels
  if (frames().size() < 2) return {};
  const QRectF& cut = frames().front().area;
  const QRectF place(QPointF(cut.right() + kGap, cut.top()),
                     QPointF(width() - kEdge, cut.bottom()));
  const QRectF text = QFontMetricsF(font()).boundingRect(place, kLines, keptTogether(reading_));
  // In a low view the map stands beside the cut, too.
  const bool isFree = !place.intersects(frames().back().area);
  return isFree && place.contains(text) ? place : QRectF();
}

void MapView::paintReading(QPainter& painter, const QRectF& frame) const {
  if (reading_.isEmpty()) return;
  const QString text = keptTogether(reading_);
  painter.setClipping(false);
  if (const QRectF place = placeBesideCut(); !place.isEmpty()) {
    painter.setPen(toQColor(theme().text));
    return painter.drawText(place, kLines, text);
  }
  constexpr qreal kBorder = 4;                               // pixels
  constexpr int kFlags = Qt::AlignRight | Qt::TextWordWrap;  // a narrow map has it in two lines
  const QRectF available = frame.adjusted(2 * kBorder, 0, -2 * kBorder, 0);
  const QSizeF size = QFontMetricsF(font()).boundingRect(available, kFlags, text).size();
  QRectF box(frame.topLeft() + QPointF(0, kBorder), size + QSizeF(2 * kBorder, kBorder));
  box.moveRight(frame.right() - kBorder);
  QColor ground = toQColor(theme().background);
  ground.setAlphaF(0.85F);
  painter.fillRect(box, ground);
  painter.setPen(toQColor(theme().text));
  painter.drawText(box.adjusted(kBorder, 0.5 * kBorder, -kBorder, 0), kFlags, text);
}

}  // namespace asperity
