#include "core/friction/line_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/contact/complete_contact.h"
#include "core/contact/steady_solver.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

constexpr std::int64_t kLongLine = std::int64_t{1} << 15;  // points

/// Velocities at which the purpose asks for steady sliding.
std::vector<double> velocitiesOf(const Scene& scene, Purpose purpose) {
  return purpose == Purpose::Picture ? std::vector<double>{scene.sliding.velocity}
                                     : sweepVelocities(scene.sweep);
}

}  // namespace

std::vector<PlanStage> planOnLine(const Scene& scene, Purpose purpose) {
  std::vector<PlanStage> stages = planOf(scene, purpose);
  PlanStage& search = stages[static_cast<std::size_t>(Stage::ContactSearch)];
  if (!search.runs || scene.accuracy.scheme == Scheme::Nodal) return stages;
  const SteadySolver sliding(scene);
  const std::int64_t points =
      purpose == Purpose::Curve ? pointsPerElementOfCurve(scene) : pointsPerElement(scene);
  // What a long line would say costs as much as to slide it.
  const LineExtent extent = lineExtent(scene);
  if (std::max(extent.rows, extent.elements * points) > kLongLine) return stages;
  const PreparedProfile line =
      prepareProfile(LineSource(scene, points).make(0), scene.accuracy.scheme);
  const double depth =
      scene.load.kind == LoadKind::Indentation
          ? scene.load.depth
          : depthOfComplete(line, scene.load.normalForce / (4 * sliding.law().equilibriumModulus));
  const std::vector<double> velocities = velocitiesOf(scene, purpose);
  // The faster, the deeper it has to be pressed.
  const auto complete = static_cast<std::size_t>(
      std::partition_point(
          velocities.begin(), velocities.end(),
          [&](double velocity) { return sliding.isComplete(line, depth, velocity); }) -
      velocities.begin());
  const auto above = [&](double velocity) {
    return fmt::format("contact is complete above d = {:.3g} m at {:.3g} m/s",
                       sliding.completeAbove(line, velocity), velocity);
  };
  if (complete == velocities.size()) {
    search.runs = false;
    search.reason = above(velocities.back()) + fmt::format(", and it is {:.3g} m", depth);
  } else if (complete > 0) {
    search.reason = fmt::format("at {} of {} velocities; at {} {}", velocities.size() - complete,
                                velocities.size(), complete == 1 ? "the other" : "the others",
                                "contact is complete, and depth and friction are known");
  } else {
    search.reason = "edges of contact are found inside the segments: " + above(velocities.front());
  }
  return stages;
}

}  // namespace asperity
