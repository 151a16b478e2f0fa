#include "ui/window/main/focus_keys.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include "ui/chart/chart_view.h"
#include "ui/window/lesson/prediction_point.h"

namespace asperity {

namespace {

bool isSpace(int key) {
  return key == Qt::Key_Space || key == Qt::Key_Select;
}

/// Returns whether a key goes to an end of a slider or a list. The page keys do not count, because
/// a presenter's remote control sends them to the tour.
bool isEnd(int key) {
  return key == Qt::Key_Home || key == Qt::Key_End;
}

bool isArrow(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

/// Returns whether a control handles a key that is also a shortcut of the window.
bool needs(const QWidget& widget, const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const int key = event.key();
  if (modifiers == Qt::ShiftModifier && isArrow(key))
    return qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const PredictionPoint*>(&widget);
  if (modifiers != Qt::NoModifier) return false;
  if (qobject_cast<const QAbstractButton*>(&widget)) return isSpace(key);
  if (qobject_cast<const QComboBox*>(&widget)) return isSpace(key) || isEnd(key);
  if (qobject_cast<const QAbstractSlider*>(&widget) ||
      qobject_cast<const QAbstractItemView*>(&widget))
    return isEnd(key);
  return qobject_cast<const ChartView*>(&widget) && key == Qt::Key_Home;
}

bool isReturn(const QKeyEvent& event) {
  const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  return isPlain && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter);
}

/// Clicks a push or tool button, or opens its menu. Returns whether the widget is such a button.
bool press(QWidget& widget) {
  auto* tool = qobject_cast<QToolButton*>(&widget);
  auto* button = qobject_cast<QPushButton*>(&widget);
  if (tool && tool->isEnabled() && tool->popupMode() == QToolButton::InstantPopup && tool->menu())
    tool->showMenu();
  else if (tool)
    tool->click();
  else if (button)
    button->click();
  return tool || button;
}

}  // namespace

FocusKeys::FocusKeys(QWidget& window) : QObject(&window), window_(window) {
  QApplication::instance()->installEventFilter(this);
}

bool FocusKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool isOffer = event->type() == QEvent::ShortcutOverride;
  if (!isOffer && event->type() != QEvent::KeyPress) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget->window() != &window_) return false;
  const auto& key = *static_cast<QKeyEvent*>(event);
  // With Alt an arrow leads through the tour; at its end it must not move a slider.
  const bool isIdle = !isOffer && key.modifiers() & Qt::AltModifier && isArrow(key.key()) &&
                      qobject_cast<QAbstractSlider*>(widget);
  if (isIdle) return true;
  if (!isOffer) return isReturn(key) && press(*widget);
  if (!needs(*widget, key)) return false;
  event->accept();  // the key is the control's
  return true;
}

}  // namespace asperity
