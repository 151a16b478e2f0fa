#include "core/run/rigid_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/scene/plan.h"
#include "core/scene/scene_check.h"

namespace asperity {

RigidLine::RigidLine(Line made, Scheme scheme, std::int64_t itsElements)
    : line(std::make_shared<Line>(std::move(made))),
      prepared(prepareProfile(*line, scheme)),
      elements(itsElements) {}

RigidLine::RigidLine(const LineSource& source, const Scene& scene, std::int64_t realization)
    : RigidLine(source.make(realization), scene.accuracy.scheme, source.elements()) {}

RigidLine::RigidLine(const Scene& scene, std::int64_t realization, const Profile* profile)
    : RigidLine(LineSource(scene, linePoints(scene), profile), scene, realization) {
  countStage(Stage::Line);
}

RigidLine RigidLine::withPoints(const Scene& scene, std::int64_t points) {
  return {LineSource(scene, points), scene, 0};
}

RigidLine RigidLine::coarser(std::size_t every, std::size_t first) const {
  const auto thinned = [every, first](const std::vector<double>& values) {
    std::vector<double> kept;
    for (std::size_t i = first; i < values.size(); i += every) kept.push_back(values[i]);
    return kept;
  };
  Line coarse = *line;
  coarse.spacing *= static_cast<double>(every);
  coarse.height = thinned(line->height);
  coarse.slopeAfter = thinned(line->slopeAfter);
  coarse.slopeBefore = thinned(line->slopeBefore);
  return {std::move(coarse), prepared.scheme, elements};
}

MarchLoad marchLoad(const Load& load, double length) {
  const Load onLine = loadOn(load, length);
  return {onLine.kind, onLine.normalForce, onLine.depth};
}

TimeMarch steadyMarch(const RigidLine& rigid, const SteadySolver& sliding, double velocity,
                      const SteadyState& state, double distance) {
  const SteadyShape shape = sliding.shape(rigid.prepared, velocity, state);
  const Line& line = *rigid.line;
  const std::size_t nodes = line.nodes(), modes = shape.modes.empty() ? 0 : sliding.modes().modes();
  const auto moved =
      static_cast<std::ptrdiff_t>(std::llround(std::fmod(distance, line.length) / line.spacing));
  const std::ptrdiff_t shift = moved % static_cast<std::ptrdiff_t>(nodes);
  const auto shifted = [&](const std::vector<double>& values) {
    std::vector<double> ordered = inLineOrder(rigid.prepared, values);
    const std::ptrdiff_t back = shift >= 0 ? shift : shift + static_cast<std::ptrdiff_t>(nodes);
    std::rotate(ordered.begin(), ordered.end() - back, ordered.end());
    return ordered;
  };
  std::vector<double> amplitudes(modes * nodes), one(shape.nodes.depth.size());
  for (std::size_t j = 0; j < modes; ++j) {
    for (std::size_t i = 0; i < one.size(); ++i) one[i] = shape.modes[i * modes + j];
    const std::vector<double> ordered = shifted(one);
    for (std::size_t i = 0; i < nodes; ++i) amplitudes[i * modes + j] = ordered[i];
  }
  TimeMarch march(rigid.line, rigid.prepared.lowestHeight, sliding.law());
  march.setState(shifted(shape.nodes.depth), shifted(shape.nodes.pressure), amplitudes,
                 state.result.indentation);
  march.setDistance(line.spacing * static_cast<double>(shift) +
                    line.length * std::trunc(distance / line.length));
  return march;
}

TimeMarch restingMarch(const RigidLine& rigid, const Scene& scene, double distance) {
  requireEquilibrium(scene);
  TimeMarch march(rigid.line, rigid.prepared.lowestHeight, elementLaw(scene.elastomer));
  march.setDistance(distance);
  march.settleAtRest(marchLoad(scene.load, rigid.line->length));
  return march;
}

std::vector<double> steadyContactAge(std::span<const double> pressure, double spacing,
                                     double velocity) {
  const std::size_t count = pressure.size();
  std::vector<double> age(count, std::numeric_limits<double>::infinity());
  const double each =
      velocity != 0 ? spacing / std::abs(velocity) : std::numeric_limits<double>::infinity();
  double now = std::numeric_limits<double>::infinity();
  // Goes around twice, from the side towards which the line slides.
  for (std::size_t step = 0; step < 2 * count; ++step) {
    const std::size_t offset = step % count;
    const std::size_t i = velocity > 0 ? count - 1 - offset : offset;
    now = pressure[i] > 0 ? 0 : now + each;
    age[i] = now;
  }
  return age;
}

void startRecords(TimeMarch& march, MarchRecords wanted, double velocity) {
  const bool isNew = wanted.sinceContact && march.sinceContact().empty();
  march.record(wanted);
  if (isNew && velocity != 0)
    march.setSinceContact(steadyContactAge(march.pressure(), march.line().spacing, velocity));
}

}  // namespace asperity
