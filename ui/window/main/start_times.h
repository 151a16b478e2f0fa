// How long the program takes to be there: from the start of its process to the window on the
// screen, its first picture and the first curve, each said once on standard error. GUI thread.
#pragma once

#include <QObject>

namespace asperity {

class MainWindow;

/// Seconds since the process was started, by the system's own clock (to 0.01 s); 0 where it is not
/// known.
double secondsSinceStart();

/// Says "NAME after 0.312 s, 0.210 s of them computing": the processor time of this thread tells a
/// slow start from a busy machine.
void sayTime(const char* name);

/// Watches the window until all is said. Owned by the window.
class StartTimes : public QObject {
 public:
  explicit StartTimes(MainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace asperity
