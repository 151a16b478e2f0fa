// A scene's line prepared for contact, and the march of its elements from a known state: steady
// sliding, or static equilibrium. Threading: plain functions; a RigidLine may be shared for
// reading.
#pragma once

#include <cstdint>
#include <memory>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/march/time_march.h"
#include "core/contact/steady_solver.h"
#include "core/scene/scene.h"
#include "core/surface/profile_file.h"

namespace asperity {

struct RigidLine {
  /// Makes a line with the scene's own accuracy. profile: replaces the one in the scene's file.
  explicit RigidLine(const Scene& scene, std::int64_t realization = 0,
                     const Profile* profile = nullptr);
  /// Makes realization 0 with this many points per element.
  static RigidLine withPoints(const Scene& scene, std::int64_t points);

  /// Returns the same line with only every `every`-th node; `every` must divide the number of
  /// nodes.
  RigidLine coarser(std::size_t every) const;

  std::shared_ptr<const Line> line;
  PreparedProfile prepared;

 private:
  RigidLine(Line made, Scheme scheme);
};

/// Returns the load on one period of a line of this length (m): a nominal pressure as the force
/// that it means there.
MarchLoad marchLoad(const Load& load, double length);

/// Begins in the steady state, with the line moved to the node nearest to `distance` (m).
TimeMarch steadyMarch(const RigidLine& rigid, const SteadySolver& sliding, double velocity,
                      const SteadyState& state, double distance = 0);

/// Begins in the equilibrium at rest, with the line moved by `distance` (m): nothing creeps. Throws
/// InputError where the elastomer has no equilibrium.
TimeMarch restingMarch(const RigidLine& rigid, const Scene& scene, double distance = 0);

}  // namespace asperity
