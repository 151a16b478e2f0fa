#include "ui/panels/tips.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QRect>
#include <QScreen>
#include <QToolTip>
#include <QWidget>

namespace asperity {

namespace {

constexpr int kBelowPointer = 16;  // pixels from a position to a tip there; from QTipLabel

/// Returns the size of a tip, or a little more.
QSize tipSize(const QString& text) {
  constexpr QSize kFrame(28, 20);  // margin, padding and border, and the distance from the position
  QLabel tip(text);
  tip.setFont(QToolTip::font());
  tip.setWordWrap(Qt::mightBeRichText(text));
  return tip.sizeHint() + kFrame;
}

QRect screenAt(const QRect& place) {
  const QScreen* screen = QGuiApplication::screenAt(place.center());
  return screen ? screen->availableGeometry() : place;
}

/// Sends the tips of the children to a place beside the widget.
class TipsBeside : public QObject {
 public:
  explicit TipsBeside(QWidget& widget) : QObject(&widget), widget_(widget) {
    for (QWidget* child : widget.findChildren<QWidget*>()) child->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* child = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::ToolTip || isPlaced_ || !child || child->toolTip().isEmpty())
      return QObject::eventFilter(watched, event);
    const QRect place(widget_.mapToGlobal(QPoint()), widget_.size());
    QHelpEvent placed(QEvent::ToolTip, static_cast<QHelpEvent*>(event)->pos(),
                      tipBeside(child->toolTip(), place));
    isPlaced_ = true;
    QCoreApplication::sendEvent(watched, &placed);
    isPlaced_ = false;
    return true;
  }

 private:
  QWidget& widget_;
  bool isPlaced_ = false;
};

}  // namespace

QPoint tipAbove(const QString& text, const QRect& place, int x) {
  const int above = place.top() - tipSize(text).height();
  return above >= screenAt(place).top() ? QPoint(x, above - kBelowPointer) : tipBelow(place, x);
}

QPoint tipBelow(const QRect& place, int x) {
  return {x, place.bottom() - kBelowPointer};
}

QPoint tipBeside(const QString& text, const QRect& place) {
  const int left = place.left() - tipSize(text).width();
  return {left >= screenAt(place).left() ? left : place.right(), place.top() - kBelowPointer};
}

void keepTipsBeside(QWidget& widget) {
  new TipsBeside(widget);
}

}  // namespace asperity
