#include "ui/window/main/gesture_counter.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <utility>

namespace asperity {

GestureCounter::GestureCounter(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool GestureCounter::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TouchBegin:
    case QEvent::Shortcut:
      ++present_;
      break;
    case QEvent::KeyPress:
      if (!static_cast<QKeyEvent*>(event)->isAutoRepeat()) ++present_;
      break;
    case QEvent::Wheel:  // turned further is one gesture, turned after a drag another
      if (!std::exchange(isTurning_, true)) ++present_;
      return QObject::eventFilter(watched, event);
    default:
      return QObject::eventFilter(watched, event);
  }
  isTurning_ = false;
  return QObject::eventFilter(watched, event);
}

}  // namespace asperity
