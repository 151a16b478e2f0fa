// A scene marched in time for the window: line, elements, their state and, in steady sliding, the
// steady result; a motion that is not steady runs for its duration and begins again. It has no
// threads and no clock, so the same calls give the same frames.
// Failure: constructor and update throw InputError or std::runtime_error; after a failed update the
// simulation continues with its former scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/contact/march/time_march.h"
#include "core/run/frame.h"
#include "core/run/transient.h"

namespace asperity {

/// The way of a picture to the steady state after a change of the scene. Its distance from that
/// state is relative, with a sign.
class Settling {
 public:
  /// Begins at a change. It ends at this time (s) at the latest, because the march of a coarse line
  /// never reaches the indentation of the resolved one.
  void begin(double latestEnd);
  void end() { latestEnd_ = 0; }
  /// Takes the distance of the next frame, and ends where it is near.
  void take(double distance);

  bool isOn(double time) const { return time < latestEnd_; }
  /// Returns whether this distance is so small that the steady state may replace the picture, is on
  /// the other side of it, or has not become smaller for many frames: few elements in contact
  /// oscillate about their own steady state.
  bool isNear(double distance) const;

 private:
  double latestEnd_ = 0;    // s; 0 once settled
  double first_ = 0;        // distance after the first frame; 0 before
  double smallest_ = 0;     // distance since then
  int framesNoNearer_ = 0;  // frames since the smallest distance
};

class Simulation {
 public:
  /// stepsPerFrame: maximum number of element-steps per frame; they are counted, so that frames do
  /// not depend on a clock.
  Simulation(std::shared_ptr<const Scene> scene, std::uint64_t number,
             double stepsPerFrame = kStepsPerFrame);

  static constexpr double kStepsPerFrame = 6e5;

  /// The initial shape under a new scene.
  enum class Shape { Present, Steady };

  /// Continues with a new scene from the present shape (which then relaxes), or in the scene's
  /// steady state, with the line at its present place. A motion, and a line of another length or
  /// another number of elements, begin at time 0. Keys that do not matter for sliding (texts, the
  /// sweep, comparisons) change no picture.
  void update(std::shared_ptr<const Scene> scene, std::uint64_t number,
              Shape shape = Shape::Present);

  /// Requests optional values for all later frames.
  void requestFields(const FrameFields& fields);

  /// Returns to the steady state at time 0.
  void reset();

  /// Advances to the next frame: the line moves by `part` of its period, or a motion by `part` of
  /// its duration (less where the elements are too many for it). wallSeconds: duration of the frame
  /// on screen.
  void advance(double part, double wallSeconds);

  /// Advances a motion to that time (s), in whole steps, through the frames that advance() would
  /// make; the last one is shorter.
  void advanceTo(double time, double part, double wallSeconds);

  /// Makes one frame on the way to a moment of a motion (s), which begins at the nearest known
  /// state before it. Returns whether it is reached; steady sliding has no moments.
  bool seek(double time, double part, double wallSeconds);

  /// Makes one time step, or as many as move the line by this part of its period. A steady state
  /// with very many elements is shifted unchanged: marching would take too long.
  void singleStep(double part = 0);

  Frame frame() const;
  const Scene& scene() const;
  double spacing() const;  // of the line's nodes, m

 private:
  struct Ready;  // a prepared scene: line, elements, steady result
  void settle(double distance);
  void begin();
  void advanceSteadily(double part);
  bool awaitsStep(double part, double wallSeconds);
  void advanceMotion(double part, double wallSeconds, double end);
  void marchMotion(double time);
  void takeTime();
  double mostSteps() const;
  void stepOnce(double dt, double distance);
  void clearReading();
  void recordFields();
  void addFields(Frame& frame) const;
  void addSteady(Frame& frame) const;
  void addMotion(Frame& frame) const;
  double settlingTime() const;
  bool isSettling() const;
  bool showsSteadyState() const;
  Frame steadyFrame() const;
  Frame marchedFrame() const;
  double awayFromSteady() const;
  ContactState marchedState(const Frame& frame) const;
  void stepMotion(double distance);
  bool beginsAnew();
  void goTo(double time);
  double stepDistance() const;
  double restTimeStep() const;
  bool resolvesContacts() const;
  const TimeMarch& march() const { return motion_ ? motion_->transient().march() : *march_; }

  std::shared_ptr<const Ready> ready_;
  std::optional<TimeMarch> march_;      // in steady sliding
  std::optional<PlayedMotion> motion_;  // in other motions
  FrameFields fields_;
  mutable std::optional<Frame> still_;  // the steady state at distance 0, once it is shown
  std::uint64_t steps_ = 0;
  double stepsPerFrame_;
  double time_ = 0, timeScale_ = 0;
  double towardsStep_ = 0;  // s, passed by slow frames of a motion's next step
  Settling settling_;
  double lineWork_ = 0, normalWork_ = 0;  // J, since the last frame: F_x and F_N times distance
  /// Elements in contact, and contact spots, in the newest steps.
  double touching_ = 0, contactSpots_ = 0;
  bool isChanged_ = false;  // the scene changed since the newest step
  bool resolves_ = false;   // steps were short enough for friction
};

}  // namespace asperity
