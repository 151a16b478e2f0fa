// Frames of steady sliding without any march in time: the elastomer's shape is stationary in the
// line's frame, so a frame is that shape moved along. Immutable once made; any thread.
// Failure: the constructor throws InputError for a scene that cannot run and std::runtime_error
// where the force balance is not met.
#pragma once

#include <cstdint>
#include <memory>

#include "core/contact/steady_solver.h"
#include "core/run/frame.h"
#include "core/run/rigid_line.h"

namespace asperity {

/// Makes the frame state forces, contact and friction of this steady state.
void setSteadyFacts(Frame& frame, const SteadyResult& facts);

/// The steady state of a line as a frame, with the line at distance 0. Pressures, slopes and depths
/// are those of the line's points in one and the same pass: of Kelvin elements p = 4 (G |u| + eta v
/// dz/dx) holds at each point in contact. facts: what the frame states.
Frame stillFrame(std::shared_ptr<const Scene> scene, const RigidLine& rigid,
                 const SteadySolver& sliding, const SteadyState& shown, const SteadyResult& facts,
                 const FrameFields& fields);

/// Moves the line and all that belongs to it by whole points, towards +x.
void moveByPoints(Frame& frame, std::int64_t points);

class SteadyFrames {
 public:
  /// seen: m, of the line in the narrowest picture, whose points then lie the closer; 0: the whole
  /// period.
  explicit SteadyFrames(std::shared_ptr<const Scene> scene, const FrameFields& fields = {},
                        double seen = 0);

  /// Frame `index` of `count` that divide one period; framesPerSecond states the time scale.
  Frame frame(std::int64_t index, std::int64_t count, double framesPerSecond) const;

  /// After so many periods; timeScale: simulated seconds per second on screen, 0 where it stands.
  Frame frameAt(double periods, double timeScale, std::uint64_t step) const;

  double length() const { return still_.length; }         // m, of the period
  const SteadyResult& result() const { return result_; }  // at the scene's own accuracy

 private:
  std::shared_ptr<const Scene> scene_;
  SteadyResult result_;
  Frame still_;  // of the line at rest at distance 0
};

}  // namespace asperity
