#include "ui/window/lesson/prediction_point.h"

#include <QAccessible>
#include <QEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/chart/chart_view.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"

namespace asperity {

namespace {

constexpr double kReach = 7;                       // pixels, radius of the point
constexpr double kStep = 0.02, kFineStep = 0.005;  // of an axis, for a key

DrawPoint toDrawPoint(QPointF point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}

/// Returns "0.25 at 1 m/s".
QString positionText(QPointF point, const Diagram& diagram) {
  return PredictionPoint::tr("%1 at %2")
      .arg(quantityLabel(point.y(), diagram.y.unit), quantityLabel(point.x(), diagram.x.unit));
}

}  // namespace

PredictionPoint::PredictionPoint(ChartView& chart) : QWidget(&chart), chart_(chart) {
  setObjectName("predictionPoint");
  setCursor(Qt::CrossCursor);
  chart_.installEventFilter(this);
  hide();
}

void PredictionPoint::ask(std::optional<double> x, const QString& name) {
  x_ = x;
  point_.reset();
  isDecided_ = isComputed_ = isDragged_ = false;
  setAttribute(Qt::WA_TransparentForMouseEvents, false);
  setFocusPolicy(Qt::StrongFocus);
  setGeometry(chart_.rect());
  setQuestion(name);
  show();
  raise();
}

void PredictionPoint::setQuestion(const QString& name) {
  name_ = name;
  if (!isDecided_)
    setToolTip(x_ ? tr("Drag up and down, or use the arrow keys (with Shift finer)")
                  : tr("Drag, or use the arrow keys (with Shift finer)"));
  describePosition();
  update();
}

void PredictionPoint::showDecided(double x, double y, Whose whose) {
  point_ = QPointF(x, y);
  isDecided_ = true;
  isComputed_ = whose == Whose::Computed;
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setToolTip({});
  setGeometry(chart_.rect());
  describePosition();
  show();
  raise();
  update();
}

bool PredictionPoint::hasAxes() const {
  const auto frame = chart_.frame();
  return frame && !frame->x.isEmpty() && !frame->y.isEmpty();
}

QPointF PredictionPoint::valueAt(QPointF pixel) const {
  const ChartGeometry frame = *chart_.frame();
  const QRectF& area = frame.area;
  return {x_ ? *x_ : frame.xAt(std::clamp(pixel.x(), area.left(), area.right())),
          frame.yAt(std::clamp(pixel.y(), area.top(), area.bottom()))};
}

/// Returns the value of the point, and its position on the x-axis unless the question fixes it.
QString PredictionPoint::placeText() const {
  const Diagram& diagram = chart_.sheet().diagrams.front();
  return x_ && !isComputed_ ? quantityLabel(point_->y(), diagram.y.unit)
                            : positionText(*point_, diagram);
}

/// Returns the initial position of a point that has not been placed.
QPointF PredictionPoint::middle() const {
  return valueAt(chart_.frame()->area.center());
}

void PredictionPoint::place(QPointF value) {
  point_ = value;
  describePosition();
  update();
  emit placed();
}

/// Sets the accessible description: the question and the position of the point.
void PredictionPoint::describePosition() {
  QString text = name_;
  if (point_ && hasAxes()) text += ": " + positionText(*point_, chart_.sheet().diagrams.front());
  setAccessibleName(text);
  setAccessibleDescription(toolTip());
}

void PredictionPoint::paintEvent(QPaintEvent*) {
  if (!hasAxes()) return;
  const QPointF value = point_.value_or(middle());
  const ChartGeometry frame = *chart_.frame();
  QPointF at = frame.at(value.x(), value.y());
  if (!std::isfinite(at.x()) || !std::isfinite(at.y())) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = palette().color(QPalette::Highlight);
  const double top = frame.area.top(), bottom = frame.area.bottom();
  // A guess may lie beyond the axis of the curve, which is shown once it is made.
  const QString arrow = at.y() < top      ? QStringLiteral("↑")
                        : at.y() > bottom ? QStringLiteral("↓")
                                          : QString();
  at.setY(std::clamp(at.y(), top, bottom));
  if (!isDecided_) {
    painter.setPen(QPen(colour, 1.2, Qt::DashLine));
    painter.drawLine(QPointF(at.x(), top), QPointF(at.x(), bottom));
  }
  painter.setPen(QPen(colour, hasFocus() ? 3 : 2));
  painter.setBrush(point_ && !isDecided_ ? colour : QColor(Qt::transparent));
  painter.drawEllipse(at, kReach, kReach);
  const QString height = point_ ? placeText() : tr("drag me");
  const QString decided =
      isComputed_
          ? height
          : tr("your answer") +
                (arrow.isEmpty() ? QString() : QStringLiteral(": %1 %2").arg(height, arrow));
  const QString text = isDecided_ ? decided : height;
  const QFontMetricsF metrics(font());
  label_ =
      labelRect(QSizeF(metrics.horizontalAdvance(text) + 6, metrics.height() + 2), at, frame.area);
  paintLeader(painter, at);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(210);
  painter.fillRect(label_, ground);
  painter.drawText(label_, Qt::AlignCenter, text);
}

/// Returns the rectangle of a label within `frame`: beside the point where that hides nothing,
/// otherwise at the nearest free place; where there is none, beside the point where it hides least.
QRectF PredictionPoint::labelRect(QSizeF label, QPointF at, const QRectF& frame) const {
  constexpr double kAside = 1.6 * kReach, kAbove = 0.4 * kReach;
  OccupancyGrid covered = chart_.covered();
  QRectF best(
      {std::clamp(at.x(), frame.left(), std::max(frame.left(), frame.right() - label.width())),
       frame.top()},
      label);  // where the label does not fit beside the point
  float least = std::numeric_limits<float>::infinity();
  for (const bool isBelow : {false, true})
    for (const bool isLeft : {false, true}) {
      const double x = isLeft ? at.x() - kAside - label.width() : at.x() + kAside;
      const double y = isBelow ? at.y() + kAbove : at.y() - kAbove - label.height();
      if (x < frame.left() || x + label.width() > frame.right()) continue;
      const double highest = std::max(frame.top(), frame.bottom() - label.height());
      const QRectF candidate({x, std::clamp(y, frame.top(), highest)}, label);
      const float hidden = covered.under(toBox(candidate));
      if (hidden >= least) continue;
      least = hidden;
      best = candidate;
    }
  if (least <= 0) return best;
  constexpr float kRingStep = 6;
  constexpr int kRings = 60;
  covered.addBox(toBox(QRectF(at, QSizeF()).adjusted(-kReach, -kReach, kReach, kReach)), 1);
  const auto isFree = [&](const Box& box) { return !(covered.greatestUnder(box) > 0); };
  const auto free =
      boxNear(toDrawPoint(at), static_cast<float>(label.width()),
              static_cast<float>(label.height()), toBox(frame), covered, kRingStep, kRings, isFree);
  return free ? QRectF(free->x, free->y, free->width, free->height) : best;
}

/// Joins the label to its point where it is not beside it.
void PredictionPoint::paintLeader(QPainter& painter, QPointF at) const {
  constexpr double kBeside = 2 * kReach;
  const QRectF around = label_.adjusted(-kBeside, -kBeside, kBeside, kBeside);
  const auto from = exitPoint(toBox(label_), toDrawPoint(at));
  if (around.contains(at) || !from) return;
  QLineF leader(at, QPointF(from->x, from->y));
  leader.setP1(leader.pointAt(kReach / leader.length()));
  painter.setPen(QPen(painter.pen().color(), 1));
  painter.drawLine(leader);
}

void PredictionPoint::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !hasAxes()) return;
  setFocus(Qt::MouseFocusReason);
  // A click beside the axes, such as on the legend, is no answer. The edge itself is one.
  constexpr double kEdge = 3;  // pixels
  isDragged_ =
      chart_.frame()->area.adjusted(-kEdge, -kEdge, kEdge, kEdge).contains(event->position());
  if (isDragged_) place(valueAt(event->position()));
}

void PredictionPoint::mouseMoveEvent(QMouseEvent* event) {
  if (isDragged_ && event->buttons() & Qt::LeftButton && hasAxes())
    place(valueAt(event->position()));
}

void PredictionPoint::keyPressEvent(QKeyEvent* event) {
  if (isReturnKey(*event)) return emit returnPressed();
  const double dx = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  const double dy = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  if ((dx == 0 && dy == 0) || !hasAxes() || event->modifiers() & Qt::AltModifier)
    return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier ? kFineStep : kStep;
  const QPointF from = point_.value_or(middle());
  const QPointF at = chart_.frame()->at(from.x(), from.y());
  place(valueAt(at + QPointF(dx * step * width(), dy * step * height())));
  QAccessibleEvent changed(this, QAccessible::NameChanged);
  QAccessible::updateAccessibility(&changed);
}

bool PredictionPoint::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &chart_ && event->type() == QEvent::Resize) setGeometry(chart_.rect());
  return QWidget::eventFilter(watched, event);
}

}  // namespace asperity
