#include "ui/window/main/highlight_frame.h"

#include <QEvent>
#include <QPainter>
#include <QScrollArea>

namespace asperity {

namespace {

constexpr int kMargin = 5;      // pixels between the control and the outer edge of the frame
constexpr int kSideMargin = 8;  // the same at its sides, where its text begins
constexpr double kWidth = 2.5;  // of the line, pixels
constexpr double kCorner = 7;   // radius, pixels

QScrollArea* scrollAreaAround(QWidget& control) {
  for (QWidget* each = control.parentWidget(); each; each = each->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(each)) return area;
  return nullptr;
}

}  // namespace

HighlightFrame::HighlightFrame(QWidget& window) : QWidget(&window), window_(window) {
  setObjectName("halo");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void HighlightFrame::highlight(QWidget* control) {
  for (const QPointer<QWidget>& widget : watched_)
    if (widget) widget->removeEventFilter(this);
  watched_.clear();
  control_ = control;
  for (QWidget* each = control; each && each != &window_; each = each->parentWidget()) {
    each->installEventFilter(this);
    watched_.emplace_back(each);
  }
  window_.removeEventFilter(this);
  if (control) {
    window_.installEventFilter(this);
    if (QScrollArea* area = scrollAreaAround(*control)) area->ensureWidgetVisible(control);
  }
  adjustToControl();
}

/// Several widgets may move one after the other; the frame moves once, afterwards.
bool HighlightFrame::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::ParentChange:
      QMetaObject::invokeMethod(
          this, [this] { adjustToControl(); }, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

/// Returns the part of the control that nothing around it cuts off, in pixels of the window.
QRect HighlightFrame::visiblePart() const {
  QRect part(control_->mapTo(&window_, QPoint()), control_->size());
  for (QWidget* each = control_->parentWidget(); each && each != &window_;
       each = each->parentWidget())
    part &= QRect(each->mapTo(&window_, QPoint()), each->size());
  return part;
}

void HighlightFrame::adjustToControl() {
  // A panel that floats is a window of its own.
  const bool isHere = control_ && control_->window() == &window_ && control_->isVisible();
  const QRect part = isHere ? visiblePart() : QRect();
  setVisible(!part.isEmpty());
  if (part.isEmpty()) return;
  setGeometry(part.adjusted(-kSideMargin, -kMargin, kSideMargin, kMargin) & window_.rect());
  raise();
  update();
}

void HighlightFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor colour = palette().color(QPalette::Highlight);
  const QRectF line = QRectF(rect()).adjusted(kWidth, kWidth, -kWidth, -kWidth);
  QColor glow = colour;
  glow.setAlphaF(0.25F);
  painter.setPen(QPen(glow, 2 * kWidth));
  painter.drawRoundedRect(line, kCorner, kCorner);
  painter.setPen(QPen(colour, kWidth));
  painter.drawRoundedRect(line, kCorner, kCorner);
}

}  // namespace asperity
