// Whether a window can be seen: it is shown, not minimised, on the desktop in front and not wholly
// covered, as far as the window system tells. X11 tells of covered windows only where nothing
// composes the screen; Wayland and macOS by taking the exposure away. GUI thread; belongs to the
// window. Cannot fail: what is not told counts as seen.
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
  bool isSeen_ = true;  // until something is told
};

}  // namespace asperity
