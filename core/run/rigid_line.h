// A scene's line made ready, and the march of its elements begun in a state that is known: the
// steady one, or static equilibrium. Threading: plain functions; a RigidLine is shared for reading.
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
  /// At the scene's own accuracy. profile: instead of that in the scene's file.
  explicit RigidLine(const Scene& scene, std::int64_t realization = 0,
                     const Profile* profile = nullptr);
  /// Realization 0 with so many points to an element.
  static RigidLine withPoints(const Scene& scene, std::int64_t points);

  /// Every so many nodes of a line, whose number that divides: the same line, more coarsely.
  RigidLine coarser(std::size_t every) const;

  std::shared_ptr<const Line> line;
  PreparedProfile prepared;

 private:
  RigidLine(Line made, Scheme scheme);
};

MarchLoad marchLoadOf(const Load& load);

/// The steady state, with the line moved to the node nearest to `distance` (m).
TimeMarch steadyMarch(const RigidLine& rigid, const SteadySolver& sliding, double velocity,
                      const SteadyState& state, double distance = 0);

/// Pressed in at rest for ever, the line moved by `distance` (m): nothing creeps. Throws InputError
/// where the elastomer has no equilibrium.
TimeMarch restingMarch(const RigidLine& rigid, const Scene& scene, double distance = 0);

}  // namespace asperity
