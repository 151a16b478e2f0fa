// What lies between the background runner and the widgets: the present scene and its number, the
// newest frame, the friction diagram so far. The window's timer calls poll(); signals tell what has
// changed. Owned by the main window; GUI thread. Failure: what the runner complains about arrives
// as a signal; the session goes on.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/run/runner.h"
#include "ui/chart/friction_chart_model.h"

namespace asperity {

class Session : public QObject {
  Q_OBJECT

 public:
  Session(const Scene& scene, RunnerOptions options, QObject* parent = nullptr);

  /// The runner gets its first scene, and plays. Not before the window is made: it would wait for
  /// the processors that the runner takes.
  void begin();

  /// Makes this the scene; the newest wins. Opened: it begins at time 0, whatever was there.
  enum class Begin { GoesOn, Opened };
  void setScene(const Scene& scene, Begin begin = Begin::GoesOn);
  const Scene& scene() const { return scene_; }
  std::uint64_t sceneNumber() const { return sceneNumber_; }

  bool isPlaying() const { return runner_.isPlaying(); }
  void setPlaying(bool playing);
  /// Pauses first. part: of the period, that the line moves by; one time step at least.
  void singleStep(double part = 0);
  /// Whether anybody sees the frames: otherwise time stands still.
  void setSeen(bool seen);
  bool isSeen() const { return isSeen_; }
  /// Frames hold these fields from now on.
  void wantFields(const FrameFields& fields) { runner_.want(fields); }
  void reset();

  /// The averaging of the present scene's curve: it may be stopped, keeping what is there, and
  /// begun anew.
  enum class Averaging { Running, Stopped, Done };
  Averaging averaging() const;
  void stopCurve();
  void startCurve();

  /// Lines at one velocity each, of the present curve so far or of the last one; 0 before the
  /// first.
  double simulationsPerSecond() const { return rate_; }

  /// Whether the present scene's first frame keeps a user waiting.
  bool isWaiting() const;

  /// Takes what the runner has made since the last call.
  void poll();

  std::shared_ptr<const Frame> frame() const { return frame_; }
  const FrictionChartModel& friction() const { return friction_; }
  /// Changes what the diagram shows beside the present curve: pins, axes, a difference.
  void editCurve(const std::function<void(FrictionChartModel&)>& edit);

  /// The newest state of a curve of the present scene; null before the first and once it is stale.
  const CurveUpdate* curve() const { return curve_ && !friction_.isStale() ? &*curve_ : nullptr; }

 signals:
  void playingChanged(bool playing);
  void frameArrived();
  void plotChanged();
  /// Only the marker has changed, and it lies within the axes as they are.
  void markChanged();
  /// isWaiting() has changed: the screen shows the scene before for longer than a moment.
  void waitingChanged(bool isWaiting);
  /// The runner, or its frame, says what is wrong with the present scene; the key may be empty.
  void complained(const QString& key, const Message& text);
  /// A sound frame of the present scene is here and nothing was said against it: whatever was wrong
  /// before is over.
  void sceneRuns();

 private:
  RunnerOptions withNews(RunnerOptions options);
  void takeMessages();
  void takeCurves();
  void measureRate(const CurveUpdate& update);
  void takeFrame();
  void judgeFrame();
  void tellWaiting();

  Scene scene_;
  std::atomic<bool> hasNews_ = false;  // told, but not taken yet
  Runner runner_;
  std::uint64_t sceneNumber_ = 0;
  std::uint64_t runningNumber_ = 0;  // newest scene of which a frame was seen
  std::uint64_t brokenNumber_ = 0;   // newest scene that the runner complained about
  QString trouble_;                  // said of that scene's frames
  std::shared_ptr<const Frame> frame_;
  FrictionChartModel friction_;
  std::optional<CurveUpdate> curve_;
  QElapsedTimer sceneTime_, curveTime_;  // since the scene came, and since its curve was begun
  bool isStopped_ = false;
  bool wasWaiting_ = false;
  bool isSeen_ = true;
  double rate_ = 0;  // 1/s
};

/// One sentence on a frame that cannot be believed; empty where nothing is wrong.
QString troubleOf(const Frame& frame);

}  // namespace asperity
