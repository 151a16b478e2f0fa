// Frames of steady sliding without a march in time: the elastomer's shape is stationary in the
// line's frame, so each frame is that shape, shifted. Immutable once made; any thread.
// Failure: the constructor throws InputError for a scene that cannot run and std::runtime_error
// where the force balance is not met.
#pragma once

#include <cstdint>
#include <memory>

#include "core/contact/steady_solver.h"
#include "core/run/frame.h"
#include "core/run/rigid_line.h"

namespace asperity {

/// Returns the greatest line load of a steady shape, N/m. NaN where its points bear less than a
/// tenth of the normal force, since contact lies between them: their pressures are then far below
/// those of the contact.
double greatestPressure(const SteadyShape& shape, double spacing, double normalForce);

/// Returns the steady state of a line as a frame, with the line at distance 0. Pressures, slopes
/// and depths at the line's points come from the same pass: for Kelvin elements p = 4 (G |u| + eta
/// v dz/dx) holds at each point in contact. facts: the results shown with the frame.
Frame stillFrame(std::shared_ptr<const Scene> scene, const RigidLine& rigid,
                 const SteadySolver& sliding, const SteadyState& shown, const SteadyResult& facts,
                 const FrameFields& fields);

/// Moves the line and all its values by whole points, towards +x.
void moveByPoints(Frame& frame, std::int64_t points);

class SteadyFrames {
 public:
  /// seen: length of the line in the narrowest picture, m, which determines the density of points;
  /// 0: the whole period.
  explicit SteadyFrames(std::shared_ptr<const Scene> scene, const FrameFields& fields = {},
                        double seen = 0);

  /// Returns frame `index` of `count` that divide one period; framesPerSecond determines the time
  /// scale.
  Frame frame(std::int64_t index, std::int64_t count, double framesPerSecond) const;

  /// Returns the frame after this many periods; timeScale: simulated seconds per second on screen,
  /// 0 for a still.
  Frame frameAt(double periods, double timeScale, std::uint64_t step) const;

  double length() const { return still_.length; }         // m, of the period
  const SteadyResult& result() const { return result_; }  // with the scene's own accuracy

 private:
  std::shared_ptr<const Scene> scene_;
  SteadyResult result_;
  Frame still_;  // of the line at distance 0
};

}  // namespace asperity
