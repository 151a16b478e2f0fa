// Detects whether a window is visible: shown, not minimised, on the current desktop and not fully
// covered, as far as the window system reports it. X11 reports covered windows only where no
// compositor runs; Wayland and macOS do it by ending the exposure. GUI thread; owned by the
// window. Cannot fail: what is not reported counts as visible.
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <QPointer>

class QWidget;
class QWindow;

namespace asperity {

class WindowVisibility : public QObject, private QAbstractNativeEventFilter {
  Q_OBJECT

 public:
  explicit WindowVisibility(QWidget& window);
  ~WindowVisibility() override;

  bool isVisible() const { return isVisible_; }

 signals:
  void changed(bool isVisible);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool nativeEventFilter(const QByteArray& type, void* message, qintptr* result) override;
  void watchHandle();
  void updateVisibility();

  QWidget& window_;
  QPointer<QWindow> handle_;
  bool isCovered_ = false;
  bool isVisible_ = true;  // until an event reports something else
};

}  // namespace asperity
