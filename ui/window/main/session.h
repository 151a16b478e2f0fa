// The link between the background runner and the widgets: the present scene and its number, the
// newest frame, the friction diagram so far. The window's timer calls poll(); signals report
// changes. Owned by the main window; GUI thread. Failure: a signal reports the runner's errors; the
// session continues.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/run/runner.h"
#include "ui/chart/friction_chart_model.h"

namespace asperity {

class Session : public QObject {
  Q_OBJECT

 public:
  Session(const Scene& scene, RunnerOptions options, QObject* parent = nullptr);

  /// Gives the runner its first scene, and plays. Call it after the window is made, which would
  /// otherwise wait for the processors that the runner uses.
  void begin();

  /// Sets the scene; the newest one wins. Restart: time begins at 0.
  enum class Begin { Continue, Restart };
  void setScene(const Scene& scene, Begin begin = Begin::Continue);
  const Scene& scene() const { return scene_; }
  std::uint64_t sceneNumber() const { return sceneNumber_; }

  bool isPlaying() const { return runner_.isPlaying(); }
  void setPlaying(bool playing);
  /// Makes a single step after a pause. part: distance that the line moves, as a part of the
  /// period; at least one time step.
  void singleStep(double part = 0);
  /// Sets the seconds on the screen in which the line moves by its period, or a motion takes place.
  void setPace(std::optional<double> secondsPerPeriod);
  /// Goes to a moment of a motion, s, and pauses there.
  void seek(double time);
  /// Returns the moment to which the user went, s, until a frame of it is shown or another command
  /// replaces the request; none: time goes on by itself, or rests.
  std::optional<double> requestedMoment() const { return requestedMoment_; }
  /// Sets whether the frames are visible; time does not advance otherwise.
  void setVisible(bool visible);
  bool isVisible() const { return isVisible_; }
  /// Requests frames with these optional values from now on.
  void requestFields(const FrameFields& fields);
  void reset();

  /// Returns whether the session is idle: the run is paused, the curve is complete or stopped, and
  /// no command or frame is recent.
  bool isIdle() const;

  /// The averaging of the present scene's curve. It can be stopped, which keeps the present result,
  /// and restarted.
  enum class Averaging { Running, Stopped, Done };
  Averaging averaging() const;
  void stopCurve();
  void startCurve();

  /// Returns the number of lines times velocities per second, for the present curve so far or for
  /// the last one; 0 before the first.
  double simulationsPerSecond() const { return rate_; }

  /// Returns whether the user waits for the present scene's first frame.
  bool isWaiting() const;
  /// Returns whether the scene cannot be computed, so that frame() is of the previous one.
  bool isRefused() const { return brokenNumber_ == sceneNumber_ && runningNumber_ != sceneNumber_; }

  /// Takes what the runner has made since the last call.
  void poll();

  /// Gives each new frame to `draw`, which calls show() when the picture of it is ready. So
  /// everything that shows frame() changes together with the picture.
  using Draw = std::function<void(const std::shared_ptr<const Frame>& frame)>;
  void drawFirst(Draw draw) { draw_ = std::move(draw); }
  void show(std::shared_ptr<const Frame> frame);

  /// Returns the frame that is shown; null before the first, and while a scene that was opened
  /// cannot be computed: the frame of an unrelated scene would pass for its own.
  std::shared_ptr<const Frame> frame() const { return frame_; }
  const FrictionChartModel& friction() const { return friction_; }
  /// Changes what the diagram shows beside the present curve: pins, axes, a difference.
  void editCurve(const std::function<void(FrictionChartModel&)>& edit);

  /// Returns the newest state of the present scene's curve; null before the first and while it is
  /// stale.
  const CurveUpdate* curve() const { return curve_ && !friction_.isStale() ? &*curve_ : nullptr; }

 signals:
  void playingChanged(bool playing);
  /// Emitted when a command was sent to the runner, whose result is expected soon.
  void commandSent();
  void frameArrived();
  /// Emitted when there is no frame any more: a scene was opened that cannot be computed.
  void frameLost();
  void plotChanged();
  /// Emitted when only the marker has changed, and it lies within the present axes.
  void markChanged();
  /// Emitted when the marker has changed, and the axes with it.
  void axesChanged();
  /// Emitted when isWaiting() changes: the screen has shown the previous scene for more than a
  /// moment.
  void waitingChanged(bool isWaiting);
  /// Emitted with the error of the present scene from the runner or its frame; the key may be
  /// empty.
  void errorOccurred(const QString& key, const Message& text);
  /// Emitted when a valid frame of the present scene arrives without an error, so that an earlier
  /// error is over.
  void sceneRuns();

 private:
  RunnerOptions withCurveNotification(RunnerOptions options);
  void notifyCommandSent();
  void takeMessages();
  void takeCurves();
  void measureRate(const CurveUpdate& update);
  void takeFrame();
  void loseFrame();
  void checkFrame();
  void updateWaiting();

  Scene scene_;
  std::atomic<bool> hasCurveUpdate_ = false;  // the runner has an update that is not taken yet
  Runner runner_;
  std::uint64_t sceneNumber_ = 0;
  std::uint64_t openedNumber_ = 0;   // of the scene that was opened last
  std::uint64_t runningNumber_ = 0;  // newest scene with a frame
  std::uint64_t brokenNumber_ = 0;   // newest scene with an error of the runner
  Message frameError_;               // last error in the frames of the present scene
  std::shared_ptr<const Frame> frame_;
  FrictionChartModel friction_;
  std::optional<CurveUpdate> curve_;
  QElapsedTimer sceneTime_, curveTime_;  // since the scene was set, and since its curve was started
  QElapsedTimer activityTime_;           // since the last command or frame
  bool isStopped_ = false;
  bool wasWaiting_ = false;
  bool isVisible_ = true;
  std::optional<double> requestedMoment_;  // s, of a motion, on the way to it
  double rate_ = 0;                        // 1/s
  std::shared_ptr<const Frame> taken_;     // the runner's newest frame, which may not be drawn yet
  Draw draw_;
};

/// Returns the error of an untrustworthy frame in one sentence; empty without an error.
Message frameError(const Frame& frame);

}  // namespace asperity
