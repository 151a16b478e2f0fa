// The bar below the contact: the moment of a motion, to be dragged, and the slow motion. The pace
// is the time on the screen in which the line moves by one period, or a motion takes place; slow
// motion is this time over the simulated one. When the velocity changes, either the pace stays, so
// that the picture moves as before, or the slow motion, so that twice the velocity looks twice as
// fast. Where that made the pace too slow or too fast to be seen, another scene, and keeping the
// pace, bring back the one that the user chose. GUI thread; owned by its parent. Cannot fail: a
// pace too fast or too slow becomes the nearest possible one.
#pragma once

#include <QWidget>
#include <optional>

#include "core/run/frame.h"
#include "core/scene/scene.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QSlider;

namespace asperity {

class TimeBar : public QWidget {
  Q_OBJECT

 public:
  explicit TimeBar(QWidget* parent = nullptr);

  /// Shows a changed scene, or another one, which was opened.
  void showScene(const Scene& scene);
  void showOtherScene(const Scene& scene);
  /// Shows the moment of a motion, and the length of the line, on which slow motion depends.
  /// requested: the moment on the way to which the motion is, s; the handle waits there, so that
  /// pictures of other moments do not take it back.
  void showFrame(const Frame& frame, std::optional<double> requested = {});
  /// Asks for a moment that is later by this part of the motion; below 0 earlier.
  void stepMoment(double part);

  /// Returns the seconds on the screen for one period, or for a motion. Until the user chooses a
  /// pace, that of a motion shows as many of its steps in each frame, so that no frame repeats.
  double pace() const { return pace_; }
  /// Returns the pace that the user chose, or the one that keeps the slow motion, s; none: the
  /// usual one of each scene.
  std::optional<double> requestedPace() const { return requested_; }
  /// Returns the slow motion: seconds on the screen for a simulated one; 0 where nothing moves.
  double slowMotion() const;
  /// Sets the slow motion; it becomes what the limits of the pace allow.
  void setSlowMotion(double factor);
  bool keepsPace() const;

  QSize minimumSizeHint() const override;

 signals:
  /// Emitted with the new requestedPace().
  void paceChanged(std::optional<double> secondsPerPeriod);
  /// Emitted while the moment is dragged, and for its keys: s, of a motion.
  void seekRequested(double time);
  /// Emitted at the beginning and the end of a drag of the moment.
  void scrubbing(bool isOn);
  /// Emitted with a sentence for the user: a typed pace was refused or changed. A tooltip at the
  /// entry shows it, too.
  void statusMessage(const QString& sentence);

 protected:
  /// Moves the handle of the slider of time to a press anywhere on it, and grips it there.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void showTexts();
  void setWidths();
  int nameWidth() const;
  int momentWidth(bool withDuration) const;
  int durationWidth() const;
  void fit();
  QString momentWords() const;
  void showMoment();
  void takeScene(const Scene& scene);
  void setLimitedPace(std::optional<double> pace);
  void choosePace(double pace);
  void showPace();
  void showMessage(const QString& sentence);
  void showDelay(const Frame& frame);
  void readFactor();
  double simulatedTime() const;

  Scene scene_;
  double length_ = 0, spacing_ = 0;  // m, period of the line and its nodes; 0: not known yet
  double pace_;
  /// The pace that the user set last, s; pace_ may follow the velocity instead.
  std::optional<double> chosen_;
  std::optional<double> requested_;
  double duration_ = 0;  // s, of a motion; 0: steady sliding
  double time_ = 0;      // s, the moment that is shown
  bool showsDuration_ = false;
  QSlider *moment_, *slider_;
  QLabel *momentText_, *behindText_, *name_;
  QLineEdit* factor_;
  QString shown_;            // text of the pace
  int framesBehind_ = 0;     // frames in a row that were slower than requested
  double reachedScale_ = 0;  // simulated seconds per second of a picture that is too slow; 0: none
  QCheckBox* keep_;
};

}  // namespace asperity
