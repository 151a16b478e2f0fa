// Keys that a control with the focus needs, and which are shortcuts of the window elsewhere: the
// space bar presses a button rather than pausing, Home goes to the end of a slider rather than
// fitting the picture. Return presses a button, too. GUI thread; belongs to its window. Cannot
// fail.
#pragma once

#include <QObject>

class QWidget;

namespace asperity {

class FocusKeys : public QObject {
 public:
  explicit FocusKeys(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& window_;
};

}  // namespace asperity
