#include "core/friction/line_plan.h"

#include <fmt/format.h>

#include "core/contact/complete_contact.h"
#include "core/contact/scene_sliding.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

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
  const SceneSliding sliding(scene);
  const TravelLine line =
      prepareTravel(LineSource(scene, pointsPerElement(scene)).make(0), scene.accuracy.scheme);
  const double depth =
      scene.load.kind == LoadKind::Indentation
          ? scene.load.depth
          : depthOfComplete(line, scene.load.normalForce / (4 * sliding.law().equilibriumModulus));
  const std::vector<double> velocities = velocitiesOf(scene, purpose);
  std::size_t complete = 0;
  for (const double velocity : velocities) complete += sliding.isComplete(line, depth, velocity);
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
