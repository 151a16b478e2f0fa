// What lies between the background runner and the widgets: the present scene and its number, the
// newest frame, the friction diagram so far. The window's timer calls poll(); signals tell what has
// changed. Owned by the main window; GUI thread. Failure: what the runner complains about arrives
// as a signal; the session goes on.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/run/runner.h"
#include "ui/charts/friction_plot.h"

namespace asperity {

class Session : public QObject {
  Q_OBJECT

 public:
  Session(const Scene& scene, RunnerOptions options, QObject* parent = nullptr);

  /// Makes this the scene; the newest wins.
  void setScene(const Scene& scene);
  const Scene& scene() const { return scene_; }
  std::uint64_t sceneNumber() const { return sceneNumber_; }

  bool isPlaying() const { return runner_.isPlaying(); }
  void setPlaying(bool playing);
  void singleStep();  // pauses first
  void reset();

  /// Takes what the runner has made since the last call.
  void poll();

  std::shared_ptr<const Frame> frame() const { return frame_; }
  Plot plot() const { return friction_.plot(); }

  /// The newest state of a curve of the present scene; null before the first and once it is stale.
  const CurveUpdate* curve() const { return curve_ && !friction_.isStale() ? &*curve_ : nullptr; }

 signals:
  void playingChanged(bool playing);
  void frameArrived();
  void plotChanged();
  /// What is wrong with the present scene, by the runner's word or by its frame; key may be empty.
  void complained(const QString& key, const QString& text);
  /// A sound frame of the present scene is here and nothing was said against it: whatever was wrong
  /// before is over.
  void sceneRuns();

 private:
  void takeMessages();
  void takeCurves();
  void takeFrame();
  void judgeFrame();

  Scene scene_;
  Runner runner_;
  std::uint64_t sceneNumber_ = 0;
  std::uint64_t runningNumber_ = 0;  // newest scene of which a frame was seen
  std::uint64_t brokenNumber_ = 0;   // newest scene that the runner complained about
  QString trouble_;                  // said of that scene's frames
  std::shared_ptr<const Frame> frame_;
  FrictionPlot friction_;
  std::optional<CurveUpdate> curve_;
};

/// One sentence on a frame that cannot be believed; empty where nothing is wrong.
QString troubleOf(const Frame& frame);

}  // namespace asperity
