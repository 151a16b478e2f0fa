// Keys that a control with the focus needs, and which are shortcuts of the window elsewhere: the
// space bar presses a button and does not pause the run, Home goes to the end of a slider and does
// not fit the picture. Return presses a button, too. GUI thread; owned by its window. Cannot fail.
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
