// The frames of a sequence, one after the other: their number, their spacing in time, and each of
// them. In steady sliding they divide a number of periods; in other motions, the duration.
// Ownership: one thread at a time. Failure: InputError for options that contradict each other or a
// scene that cannot run; std::runtime_error where a force balance is not met.
#pragma once

#include <cstdint>
#include <optional>

#include "core/run/frame.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"

namespace asperity {

/// The number of frames of one period, or of a motion, and of a second of film, where no option
/// gives them.
inline constexpr std::int64_t kDefaultFrames = 60;
inline constexpr double kDefaultFramesPerSecond = 25;

/// The options from the command line; 0: not given.
struct TimeArguments {
  std::int64_t frames = 0;
  double framesPerSecond = 0;
  double duration = 0;    // s of film
  double cycles = 0;      // periods of the line that pass by
  double slowMotion = 0;  // seconds of film per simulated second
  // The time of a single picture:
  std::optional<double> at;    // s, simulated
  std::optional<double> slid;  // m, in steady sliding
};

struct FramePlan {
  std::int64_t count = 1;
  double framesPerSecond = 0;
  double periodsPerFrame = 0;  // in steady sliding
  double timeScale = 0;        // simulated seconds per second of film; 0: nothing moves
};

class FrameSource {
 public:
  /// fields: optional values of the frames. visibleLength: of the line, m; 0: the whole period.
  FrameSource(const Scene& scene, const TimeArguments& arguments, bool single,
              const FrameFields& fields = {}, double visibleLength = 0);

  const FramePlan& plan() const { return plan_; }
  double length() const { return length_; }  // m, of the period

  /// Returns a frame; indices must increase. A single picture of a motion shows its end, unless the
  /// options give a time.
  Frame frame(std::int64_t index);

 private:
  Frame steadyFrame(std::int64_t index) const;
  Frame momentFrame();

  TimeArguments arguments_;
  Sliding sliding_;
  double length_ = 0;
  double spacing_ = 0;  // m, of the nodes of a motion
  std::optional<SteadyFrames> steady_;
  std::optional<Simulation> motion_;
  FramePlan plan_;
  std::int64_t advanced_ = 0;
};

}  // namespace asperity
