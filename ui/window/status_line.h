// The facts in the status bar: friction, the paper's two dimensionless numbers, pictures per second
// and what draws them. They come from the frame shown. GUI thread.
#pragma once

#include <QWidget>

#include "core/run/frame.h"

class QHBoxLayout;
class QLabel;
class QTimer;

namespace asperity {

class StatusLine : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  void showFrame(const Frame& frame);
  /// For a few seconds, in the room between the facts.
  void say(const QString& text);

  void showDrawing(int framesPerSecond, const QString& backend);

 private:
  QLabel* addFact(QHBoxLayout& line, const char* name, const QString& tip);

  QLabel* said_;
  QTimer* silence_;
  QLabel* mu_;
  QLabel* force_;
  QLabel* velocity_;
  QLabel* rate_;
  QLabel* backend_;
};

/// Eq. (14), F_N / (G h L); NaN where it does not apply.
double dimensionlessForce(const Frame& frame);

/// Eq. (13), tau v grad / (sqrt(2) h), with the rms slope of the whole line; NaN likewise.
double dimensionlessVelocity(const Frame& frame);

}  // namespace asperity
