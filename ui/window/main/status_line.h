// The facts in the status bar: regime, friction with its error, the paper's two dimensionless
// numbers, how fast is computed and drawn and by what; and the progress of the friction curve with
// the button that stops it. They come from the frame shown. GUI thread.
#pragma once

#include <QLabel>
#include <QWidget>

#include "core/run/frame.h"

class QHBoxLayout;
class QProgressBar;
class QTimer;
class QToolButton;

namespace asperity {

class ContactCanvas;
class Session;
struct CurveReading;

/// A line of text that is shortened where it has no room, and then whole in its tooltip.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// The text as it is shown, perhaps shortened.
  QString shownText() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// The work on the curve or on the line that is under way.
struct Work {
  enum class State { Idle, Running, Stopped, Waiting };  // Waiting: for the scene's first frame
  State state = State::Idle;
  double progress = 0;              // 0 to 1
  double simulationsPerSecond = 0;  // 0: not known
};

class StatusLine : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Asks session and canvas several times a second what is computed and drawn.
  void follow(const Session& session, const ContactCanvas& canvas);

  void showFrame(const Frame& frame, const CurveReading& reading);
  void showWork(const Work& work);

  /// Shows a text for a few seconds, between the facts and in the place of those at the right.
  void say(const QString& text);

  void showDrawing(int framesPerSecond, const QString& backend);

 signals:
  /// The button of what is under way, as showWork() left it.
  void stopWanted();
  void againWanted();
  void backWanted();  // from waiting

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  static QLabel* addFact(QHBoxLayout& line, const char* name);
  void showTips();
  void showVelocity(const Frame& frame);
  void addWork(QHBoxLayout& line);
  void pressed();
  void fallSilent();
  void fitFacts();

  Work work_;
  int framesPerSecond_ = 0;
  ElidedLabel* said_;
  QTimer* silence_;
  QLabel* regime_;
  QLabel* mu_;
  QLabel* force_;
  QLabel* velocity_;
  QLabel* settling_;
  QProgressBar* progress_;
  QToolButton* stop_;
  QLabel* simulations_;
  QLabel* rate_;
  QLabel* backend_;
};

/// Eq. (14), F_N / (G h L); NaN where it does not apply.
double dimensionlessForce(const Frame& frame);

/// Eq. (13), tau v grad / (sqrt(2) h), with the rms slope of the whole line and, of a motion, its
/// velocity at the moment; NaN likewise.
double dimensionlessVelocity(const Frame& frame);

}  // namespace asperity
