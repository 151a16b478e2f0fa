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
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"

namespace asperity {

/// The present state of a friction curve; points with 0 realizations are not known yet.
struct CurveUpdate {
  std::shared_ptr<const Scene> scene;
  std::uint64_t sceneNumber = 0;
  std::int64_t realizationsDone = 0;
  std::int64_t realizationsTotal = 0;  // as planned so far, if the scene has a target
  std::vector<CurvePoint> points;
  bool isComplete = false;                // no more results follow
  std::optional<Message> missedTarget{};  // of a complete curve: why it misses its target
};

struct PostedScene {
  std::shared_ptr<const Scene> scene;
  std::uint64_t number = 0;
};

/// A curve to average until `stop` is requested.
struct CurveWork {
  PostedScene scene;
  std::uint64_t number = 0;  // number of the curve for offer()
  std::stop_token stop;
};

/// The requests for friction curves and their results so far: the commands of a window and the
/// updates that it has not taken yet. A curve belongs to every scene that differs only in
/// parameters on which the curve does not depend; a scene with another curve stops the present one,
/// whose results are dropped. Threading: none of its own; its owner locks.
class CurveRequests {
 public:
  /// Sets the present scene. If its curve is the same as before, that curve is reported again under
  /// the scene's number; else a new one is requested.
  void post(const PostedScene& scene);

  /// Stops the present or requested curve; its results so far are kept.
  void stop();
  /// Starts the requested curve from its beginning.
  void start();
  /// Ends all averaging.
  void end() { working_.request_stop(); }

  /// Returns whether a curve was requested after this one.
  bool hasNewerThan(std::uint64_t number) const { return number_ != number; }
  /// Returns the newest curve, for the thread that averages it.
  CurveWork begin();

  /// Stores the state of a curve under the newest scene that has this curve, whatever scene the
  /// update names; returns false, and stores nothing, where another curve was requested since.
  bool offer(std::uint64_t number, const CurveUpdate& update);

  /// Returns all updates of the present scene since the last call, oldest first.
  std::vector<CurveUpdate> takeUpdates();

 private:
  PostedScene present_, requested_;
  std::uint64_t number_ = 0;
  std::stop_source working_;
  bool isStopped_ = false;
  std::optional<CurveUpdate> last_;
  std::vector<CurveUpdate> updates_;
};

struct RunnerMessage {
  std::uint64_t sceneNumber = 0;
  std::string key;  // the parameter that is wrong, may be empty
  Message text;     // one sentence
};

/// The pace is the time (s) on the screen in which the line moves by one period, or a whole motion
/// takes place: the one of a new window, and the slowest one with which an opened scene begins.
inline constexpr double kDefaultPace = 12, kSlowestFirstPace = 60;

struct RunnerOptions {
  int threads = 0;              // for the curve; 0: as many as the machine has
  double framesPerSecond = 60;  // maximum number of frames
  double secondsPerPeriod = kDefaultPace;
  /// Called on the curve's thread when there is a curve update; must return at once. May be empty.
  std::function<void()> curveUpdated{};

  double secondsPerFrame() const { return 1 / framesPerSecond; }
  /// Returns the part of the period, or of a motion's duration, between two frames.
  double partPerFrame() const { return secondsPerFrame() / secondsPerPeriod; }
};

/// Returns the pace of a scene until a user chooses another one: the default pace, or, of a motion,
/// one near it at which each frame shows the same number of its steps, also where the steps before
/// and after a jump of the velocity are not equally long. Other paces would repeat frames, because
/// the contact is known at whole steps alone. spacing: of the line's nodes (m); 0: not known yet.
double usualPace(const Sliding& sliding, double spacing);

class Runner {
 public:
  explicit Runner(RunnerOptions options = {});
  ~Runner();  // stops and joins the threads
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Sets the present scene and returns its number (1, 2, ...). The animation continues from the
  /// present shape of the elastomer if length and elements are unchanged.
  std::uint64_t post(Scene scene);

  /// Does the same for a scene that is unrelated to the previous one: it begins at time 0.
  std::uint64_t open(Scene scene);

  /// Requests frames with these optional values; while paused, one more frame is made with them.
  void requestFields(const FrameFields& fields);

  void play();
  void pause();
  bool isPlaying() const;
  /// Makes one frame while paused. The line moves by this part of its period, or by one time step
  /// if that is more; a motion advances by at least one time step.
  void singleStep(double part = 0);

  /// Sets the pace: the seconds on the screen for one period of the line, or for a whole motion;
  /// none: the usual one of each scene, from its first frame on. Lines with very many elements move
  /// more slowly than requested.
  void setPace(std::optional<double> secondsPerPeriod);

  /// Goes to a moment of a motion (s), forward or back; frames on the way are shown. The newest
  /// moment wins, and a new scene, a step or reset() ends it. In steady sliding nothing happens.
  void seek(double time);

  /// Sets whether the frames are visible. Invisible ones do not advance, as if paused; curves and
  /// answers to new scenes continue.
  void setVisible(bool seen);
  /// Returns to the scene's steady state at time 0.
  void reset();

  /// Stops the averaging of the present curve and keeps its results; startCurve() begins it again.
  /// A new curve is averaged automatically.
  void stopCurve();
  void startCurve();

  /// Returns the newest frame, or null before the first. The pointer is the same until a newer one
  /// exists.
  std::shared_ptr<const Frame> newestFrame() const;

  /// Returns all curve updates since the last call, oldest first. None is lost, except that updates
  /// of older scenes than the present one may be dropped.
  std::vector<CurveUpdate> takeCurveUpdates();

  std::vector<RunnerMessage> takeMessages();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asperity
