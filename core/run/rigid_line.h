// A scene's line prepared for contact, and the march of its elements from a known state: steady
// sliding, with the times since contact that it determines, or static equilibrium.
// Threading: plain functions; a RigidLine may be shared for reading.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/march/time_march.h"
#include "core/contact/steady_solver.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"
#include "core/surface/profile_file.h"

namespace asperity {

struct RigidLine {
  /// Makes a line with the scene's own accuracy. profile: replaces the one in the scene's file.
  explicit RigidLine(const Scene& scene, std::int64_t realization = 0,
                     const Profile* profile = nullptr);
  /// Makes realization 0 with this many points per element.
  static RigidLine withPoints(const Scene& scene, std::int64_t points);

  /// Returns the same line with only every `every`-th node from node `first` on, which becomes node
  /// 0; `every` must divide the number of nodes.
  RigidLine coarser(std::size_t every, std::size_t first = 0) const;

  LineSize size() const { return {line->length, elements}; }

  std::shared_ptr<const Line> line;
  PreparedProfile prepared;
  std::int64_t elements = 0;  // per period, whatever part of their points the line has

 private:
  RigidLine(Line made, Scheme scheme, std::int64_t itsElements);
  RigidLine(const LineSource& source, const Scene& scene, std::int64_t realization);
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

/// Returns the time since contact ended at each of the periodic points, s: 0 in contact. Elements
/// behind a contact were in it a moment ago: the time is the distance to the nearest contact in the
/// direction of sliding over the velocity (m/s, either sign), to within one spacing (m). Infinite
/// where nothing is in contact or nothing slides.
std::vector<double> steadyContactAge(std::span<const double> pressure, double spacing,
                                     double velocity);

/// Starts records of the elements. Where the march is in steady sliding at `velocity` (m/s; 0: it
/// is not), the times since contact before its records began are known, too.
void startRecords(TimeMarch& march, MarchRecords wanted, double velocity);

}  // namespace asperity
