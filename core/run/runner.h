// Runs scenes in the background for the window: one thread marches the present scene in time and
// makes frames, another averages its friction curve. Commands go in, immutable values come out.
//
// Threading: every member may be called from any thread and returns at once. Newest scene wins;
// work for an older one is dropped within a step. Nobody holds a lock while computing.
// Failure: a scene that cannot run (unreadable profile, no balance) becomes an entry of
// takeMessages(); the runner goes on with the next scene.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/run/curve_orders.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"

namespace asperity {

struct RunnerMessage {
  std::uint64_t sceneNumber = 0;
  std::string key;   // the parameter it is about, may be empty
  std::string text;  // one sentence
};

struct RunnerOptions {
  int threads = 0;               // for the curve; 0: as many as the machine has
  double framesPerSecond = 60;   // frames made at most
  double secondsPerPeriod = 12;  // on screen, for the line to pass by once
  /// Called where a curve update is there, on the curve's thread; returns at once. May be empty.
  std::function<void()> curveNews{};

  double secondsPerFrame() const { return 1 / framesPerSecond; }
  /// The part of the period, or of a motion's duration, that passes from frame to frame.
  double partPerFrame() const { return secondsPerFrame() / secondsPerPeriod; }
};

class Runner {
 public:
  explicit Runner(RunnerOptions options = {});
  ~Runner();  // stops and joins
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Makes this the present scene and returns its number (1, 2, ...). The animation goes on from
  /// the present shape of the elastomer where length and elements are unchanged.
  std::uint64_t post(Scene scene);

  /// The same for a scene that has nothing to do with the one before: it begins at time 0.
  std::uint64_t open(Scene scene);

  /// Frames hold these fields from now on; while paused, one more frame is made with them.
  void want(const FrameFields& fields);

  void play();
  void pause();
  bool isPlaying() const;
  /// While paused: one frame, and the line has moved by this part of its period, or by one time
  /// step where that is more; a motion goes on by one time step at least.
  void singleStep(double part = 0);

  /// Whether anybody sees the frames. Unseen, time stands still as if paused; curves and answers to
  /// new scenes go on.
  void setSeen(bool seen);
  /// Back to the scene's steady state at time 0.
  void reset();

  /// The present scene's curve stays as far as it is; averaging it begins anew. A new curve is
  /// averaged without being told.
  void stopCurve();
  void startCurve();

  /// The newest frame, or null before the first. The same pointer until a newer one exists.
  std::shared_ptr<const Frame> newestFrame() const;

  /// All curve updates since the last call, oldest first. None is lost, except that updates of
  /// scenes older than the present one may be dropped.
  std::vector<CurveUpdate> takeCurveUpdates();

  std::vector<RunnerMessage> takeMessages();

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
