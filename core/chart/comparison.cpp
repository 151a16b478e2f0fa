#include "core/chart/comparison.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/friction/ensemble.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

constexpr std::int64_t kTheoryPoints = 160;

double temperatureOf(const MeasuredPoint& point, const Scene& scene) {
  return std::isnan(point.temperature) ? scene.elastomer.temperature : point.temperature;
}

/// Returns the factor that shifts a measured velocity to the temperature of the scene.
double shiftToScene(const MeasuredPoint& point, const Scene& scene) {
  Elastomer there = scene.elastomer;
  there.temperature = temperatureOf(point, scene);
  return temperatureShift(there) / temperatureShift(scene.elastomer);
}

/// Returns the theories other than Eq. (11) over the velocities of the scene's sweep.
std::vector<TheoryCurve> theoryCurves(const Scene& scene) {
  std::vector<TheoryCurve> curves;
  const std::vector<Theory>& theories = scene.comparison.theory;
  if (std::ranges::all_of(theories, [](Theory theory) { return theory == Theory::Eq11; }))
    return curves;
  const LineSource source(scene, 1);
  Sweep fine = scene.sweep;
  fine.points = std::max(fine.points, kTheoryPoints);
  const std::vector<double> velocities = sweepVelocities(fine);
  for (const Theory theory : theories)
    if (theory != Theory::Eq11)
      curves.push_back({theory, theoryCurve(theory, scene, source, velocities)});
  return curves;
}

}  // namespace

std::vector<FrictionData> readComparisonData(const Scene& scene,
                                             const std::vector<FrictionData>& known) {
  const std::vector<DataFile>& tables = scene.comparison.data;
  std::vector<FrictionData> data;
  for (std::size_t i = 0; i + known.size() < tables.size(); ++i)
    data.push_back(readFrictionData(scene.folder / tables[i].file, tables[i].label));
  data.insert(data.end(), known.begin(), known.end());
  return data;
}

void addComparisons(CurveSet& set, std::vector<FrictionData> data, const StateOptions& options) {
  const Scene& scene = set.present.scene;
  set.theories = theoryCurves(scene);
  for (const FrictionData& table : data)
    for (const MeasuredPoint& point : table.points)
      set.isReduced |= temperatureOf(point, scene) != scene.elastomer.temperature;
  for (FrictionData& table : data) {
    MeasuredCurve curve;
    std::vector<Scene> states;
    for (const MeasuredPoint& point : table.points) {
      curve.velocities.push_back(point.velocity * shiftToScene(point, scene));
      states.push_back(sceneOf(point, scene));
    }
    SteadyStates found = slideStates(states, options);
    if (found.isComplete) curve.computed = std::move(found.points);
    curve.data = std::move(table);
    set.measured.push_back(std::move(curve));
  }
}

}  // namespace asperity
