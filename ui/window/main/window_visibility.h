// Whether a window can be seen: it is shown, not minimised, on the visible desktop and not fully
// covered, as far as the window system reports it. X11 reports covered windows only where no
// compositor runs; Wayland and macOS do it by ending the exposure. GUI thread; belongs to the
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

  bool isSeen() const { return isSeen_; }

 signals:
  void changed(bool isSeen);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool nativeEventFilter(const QByteArray& type, void* message, qintptr* result) override;
  void watchHandle();
  void judge();

  QWidget& window_;
  QPointer<QWindow> handle_;
  bool isCovered_ = false;
  bool isSeen_ = true;  // until an event says otherwise
};

}  // namespace asperity
