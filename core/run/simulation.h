// A scene marched in time for the window: line, elements, their state and the steady answer beside
// it. No threads and no clock of its own, so the same calls give the same frames.
// Failure: constructor and update throw InputError or std::runtime_error; after a failed update
// the simulation goes on with the scene it had.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/contact/steady_sliding.h"
#include "core/contact/time_march.h"
#include "core/run/frame.h"

namespace asperity {

class Simulation {
 public:
  Simulation(std::shared_ptr<const Scene> scene, std::uint64_t number);

  /// Which shape a new scene starts from.
  enum class Shape { Present, Steady };

  /// Goes on under a new scene from the present shape (which then relaxes), or in the scene's
  /// steady state, with the line where it was; with other elements always in the steady state at
  /// time 0.
  void update(std::shared_ptr<const Scene> scene, std::uint64_t number,
              Shape shape = Shape::Present);

  /// Back to the steady state, time 0.
  void reset();

  /// The time until the next frame: the line moves by `part` of its period (less where elements
  /// are so many that it would take too long). wallSeconds: what the frame lasts on screen.
  void advance(double part, double wallSeconds);

  /// One time step.
  void singleStep();

  Frame frame() const;

 private:
  struct Rigid;  // the line, ready for contact
  struct Ready;  // a scene made ready: line, conditions, steady result
  void stepOnce(double dt, double distance);
  void settle(double distance);
  void clearReading();
  double naturalStep() const;

  std::shared_ptr<const Ready> ready_;
  std::optional<TimeMarch> march_;
  MarchStep last_;
  std::uint64_t steps_ = 0;
  double time_ = 0, timeScale_ = 0;
  double lineWork_ = 0, normalWork_ = 0;  // J, since the last frame: F_x and F_N times distance
  bool resolves_ = false;                 // steps were short enough to read friction
};

}  // namespace asperity
