#include "core/friction/figures/element_curves.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "core/accuracy/literal_march.h"
#include "core/contact/time_march.h"
#include "core/friction/jobs.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

struct Reading {
  double mu = 0, jumpFraction = 0;
};

/// read(line, velocity) for all of them; each into its own place.
template <class Read>
std::vector<ElementPoint> curveOf(const Scene& scene, std::span<const double> velocities,
                                  std::int64_t lines, const StudyOptions& options,
                                  const Read& read) {
  const LineSource source(scene, 1);
  const auto columns = static_cast<std::int64_t>(velocities.size());
  std::vector<std::shared_ptr<const Line>> made;
  for (std::int64_t r = 0; r < lines; ++r)
    made.push_back(std::make_shared<const Line>(source.make(r)));
  std::vector<Reading> readings(static_cast<std::size_t>(lines * columns));
  std::atomic<std::int64_t> done = 0;
  Jobs(options.threads).run(lines * columns, [&](std::int64_t k) {
    if (options.stop.stop_requested()) return;
    const auto place = static_cast<std::size_t>(k);
    readings[place] = read(made[place / velocities.size()], velocities[place % velocities.size()]);
    ++done;
  });
  if (options.stop.stop_requested()) throw StudyStopped{};
  if (options.progress) options.progress(done, lines * columns);

  std::vector<ElementPoint> points;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    ElementPoint point{velocities[i], {}, 0};
    double sum = 0, squares = 0;
    for (std::size_t r = 0; r < made.size(); ++r) {
      const Reading& reading = readings[r * velocities.size() + i];
      const double value = reading.mu / source.statistics().rmsSlope;
      sum += value;
      squares += value * value;
      point.jumpFraction += reading.jumpFraction / static_cast<double>(lines);
    }
    const auto n = static_cast<double>(lines);
    point.normalizedMu.value = sum / n;
    if (lines > 1)
      point.normalizedMu.standardError =
          std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)) / (n - 1));
    points.push_back(point);
  }
  return points;
}

Reading fineSteps(const std::shared_ptr<const Line>& line, const Scene& scene, double velocity,
                  const FineSteps& steps) {
  const SlidingConditions conditions = conditionsOf(scene, velocity);
  const double force = scene.load.normalForce;
  const TravelLine travel = prepareTravel(*line, Scheme::Cubic);
  const SteadyResult steady = slideAtForce(travel, conditions, force);
  TimeMarch march(line, travel.lowestHeight, lawOf(scene.elastomer));
  const NodeShape shape = shapeAt(travel, conditions, steady.indentation);
  march.setState(inLineOrder(travel, shape.depth), steady.indentation);
  const MarchLoad load{LoadKind::Force, force, 0};
  const double advance = line->spacing / static_cast<double>(steps.perSpacing);
  double work = 0;
  for (std::int64_t k = 0; k < steps.spacings * steps.perSpacing; ++k) {
    const MarchStep step = march.step(load, advance / velocity, advance);
    if (k >= (steps.spacings - steps.averaged) * steps.perSpacing) work += step.lineWork;
  }
  return {work / (force * static_cast<double>(steps.averaged) * line->spacing), 0};
}

}  // namespace

std::vector<ElementPoint> literalCurve(const Scene& scene, std::span<const double> velocities,
                                       std::int64_t lines, const StudyOptions& options) {
  LiteralOptions march;
  for (const LiteralVectors vectors : {LiteralVectors::Avx2, LiteralVectors::Avx512})
    if (canUse(vectors)) march.vectors = vectors;
  return curveOf(scene, velocities, lines, options,
                 [&](const std::shared_ptr<const Line>& line, double velocity) {
                   const LiteralResult result = literalMarch(*line, conditionsOf(scene, velocity),
                                                             scene.load.normalForce, march);
                   return Reading{result.mu, result.jumpFraction};
                 });
}

std::vector<ElementPoint> fineStepCurve(const Scene& scene, std::span<const double> velocities,
                                        std::int64_t lines, const FineSteps& steps,
                                        const StudyOptions& options) {
  return curveOf(scene, velocities, lines, options,
                 [&](const std::shared_ptr<const Line>& line, double velocity) {
                   return fineSteps(line, scene, velocity, steps);
                 });
}

}  // namespace asperity
