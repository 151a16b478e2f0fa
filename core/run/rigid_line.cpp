#include "core/run/rigid_line.h"

#include <algorithm>
#include <cmath>

#include "core/scene/effects.h"
#include "core/scene/plan.h"
#include "core/surface/line_source.h"

namespace asperity {

RigidLine::RigidLine(const Scene& scene)
    : line(std::make_shared<Line>(LineSource(scene, pointsPerElement(scene)).make(0))),
      travel(prepareTravel(*line, scene.accuracy.scheme)) {
  countStage(Stage::Line);
}

MarchLoad marchLoadOf(const Load& load) {
  return {load.kind, load.normalForce, load.depth};
}

TimeMarch steadyMarch(const RigidLine& rigid, const SceneSliding& sliding, double velocity,
                      const SteadyState& state, double distance) {
  const SteadyShape shape = sliding.shape(rigid.travel, velocity, state);
  const Line& line = *rigid.line;
  const std::size_t nodes = line.nodes(), modes = shape.modes.empty() ? 0 : sliding.modes().modes();
  const auto moved =
      static_cast<std::ptrdiff_t>(std::llround(std::fmod(distance, line.length) / line.spacing));
  const std::ptrdiff_t shift = moved % static_cast<std::ptrdiff_t>(nodes);
  const auto placed = [&](const std::vector<double>& values) {
    std::vector<double> ordered = inLineOrder(rigid.travel, values);
    const std::ptrdiff_t back = shift >= 0 ? shift : shift + static_cast<std::ptrdiff_t>(nodes);
    std::rotate(ordered.begin(), ordered.end() - back, ordered.end());
    return ordered;
  };
  std::vector<double> amplitudes(modes * nodes), one(shape.nodes.depth.size());
  for (std::size_t j = 0; j < modes; ++j) {
    for (std::size_t i = 0; i < one.size(); ++i) one[i] = shape.modes[i * modes + j];
    const std::vector<double> ordered = placed(one);
    for (std::size_t i = 0; i < nodes; ++i) amplitudes[i * modes + j] = ordered[i];
  }
  TimeMarch march(rigid.line, rigid.travel.lowestHeight, sliding.law());
  march.setState(placed(shape.nodes.depth), placed(shape.nodes.pressure), amplitudes,
                 state.result.indentation);
  march.setDistance(line.spacing * static_cast<double>(shift) +
                    line.length * std::trunc(distance / line.length));
  return march;
}

TimeMarch restingMarch(const RigidLine& rigid, const Scene& scene, double distance) {
  needEquilibrium(scene);
  TimeMarch march(rigid.line, rigid.travel.lowestHeight, lawOf(scene.elastomer));
  march.setDistance(distance);
  march.settleAtRest(marchLoadOf(scene.load));
  return march;
}

}  // namespace asperity
