// The readings in the status bar: regime, friction with its error, the paper's two dimensionless
// numbers, what a user must know about how far they hold, the rates and methods of computing and
// drawing; and the progress of the friction curve. They come from the present frame. GUI thread.
#pragma once

#include <QWidget>
#include <vector>

#include "core/run/frame.h"
#include "ui/panels/labels.h"

class QHBoxLayout;
class QTimer;
class QToolButton;

namespace asperity {

class ContactCanvas;
class Session;
class StatusReading;
class WorkIndicator;
struct CurveReading;
struct Work;

class StatusLine : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Shows the rates of computing and drawing, which a timer reads from session and canvas several
  /// times a second.
  void monitor(const Session& session, const ContactCanvas& canvas);

  void showFrame(const Frame& frame, const CurveReading& reading);
  /// Empties the readings: there is no frame of the scene.
  void clearReadings();
  /// Fades the readings while they belong to the previous scene.
  void fadeReadings(bool fades);
  void showWork(const Work& work);
  WorkIndicator& work() { return *work_; }

  /// Shows a message for a few seconds instead of the readings at the right.
  void showMessage(const QString& text);

  void showDrawing(int framesPerSecond, const QString& backend);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  static StatusReading* addReading(QHBoxLayout& line, const char* name);
  void showTips();
  void showFrictionTip();
  void showVelocity(const Frame& frame);
  void showNotes(const CurveReading& reading);
  void reserveWidths();
  void fitReadings();
  void chooseForms(int available);

  bool isOfMotion_ = false, isSettling_ = false;  // the frame that is shown
  int framesPerSecond_ = 0;
  ElidedLabel* message_;
  QTimer* messageTimer_;
  StatusReading* regime_;
  StatusReading* mu_;
  QToolButton* notes_;                   // opens a menu of all notes
  std::vector<Message> shownNotes_;      // their sentences
  int roomForNotes_ = 0;                 // pixels that they may need
  int notesWidth_ = 0;                   // pixels that are kept for them
  std::vector<StatusReading*> leftOut_;  // for lack of room, at the present width
  StatusReading* force_;
  StatusReading* velocity_;
  StatusReading* settling_;
  WorkIndicator* work_;
  StatusReading* simulations_;
  StatusReading* rate_;
  StatusReading* backend_;
  QString backendName_;  // "software"
};

/// Returns Eq. (14), F_N / (G h L); NaN where it does not apply.
double dimensionlessForce(const Frame& frame);

/// Returns Eq. (13), tau v grad / (sqrt(2) h), with the rms slope of the whole line and, for a
/// motion, its present velocity; NaN where it does not apply.
double dimensionlessVelocity(const Frame& frame);

}  // namespace asperity
