// The progress of the curve, or of the line before there is a contact, with the button that stops
// it. It is thin, and visible only during work. GUI thread; owned by its parent. Cannot fail.
#pragma once

#include <QWidget>

class QProgressBar;
class QToolButton;

namespace asperity {

class Session;

/// The present work on the curve or on the line.
struct Work {
  enum class State { Idle, Running, Stopped, Waiting };  // Waiting: for the scene's first frame
  State state = State::Idle;
  double progress = 0;              // 0 to 1
  double simulationsPerSecond = 0;  // 0: not known

  bool operator==(const Work&) const = default;
};

Work presentWork(const Session& session);

class WorkIndicator : public QWidget {
  Q_OBJECT

 public:
  explicit WorkIndicator(QWidget* parent = nullptr);

  void showWork(const Work& work);
  const Work& work() const { return work_; }

 signals:
  /// Emitted by the button of the work that is shown.
  void stopRequested();
  void restartRequested();
  void backRequested();  // in the state Waiting

 private:
  void pressButton();

  Work work_;
  QProgressBar* progress_;
  QToolButton* button_;
};

}  // namespace asperity
