#include "core/chart/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/input_error.h"
#include "core/friction/ensemble.h"
#include "core/material/temperature_shift.h"
#include "core/scene/list_text.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

constexpr std::int64_t kTheoryPoints = 160;
constexpr std::int64_t kTheoryPointsOfLines = 48;  // each of a line of its own

double temperatureAt(const MeasuredPoint& point, const Scene& scene) {
  return std::isnan(point.temperature) ? scene.elastomer.temperature : point.temperature;
}

/// Returns the factor that shifts a measured velocity to the temperature of the scene.
double shiftToScene(const MeasuredPoint& point, const Scene& scene) {
  return temperatureShift(scene.elastomer, temperatureAt(point, scene),
                          scene.elastomer.temperature);
}

std::vector<TheoryCurve> theoryCurves(const CurveSet& set, const std::stop_token& stop) {
  std::vector<TheoryCurve> curves;
  const Scene& scene = set.present.scene;
  for (const Theory theory : scene.comparison.theory) {
    if (theory == Theory::Eq11 && set.hasLawInPoints()) continue;
    const bool isOfSurface = scene.sweep.key.starts_with("surface.");
    curves.push_back(
        {theory,
         theoryOverAxis(theory, scene, isOfSurface ? kTheoryPointsOfLines : kTheoryPoints, stop)});
  }
  return curves;
}

/// The quantities of a state that a table may have besides the velocity.
struct MeasuredColumn {
  std::string_view key;
  double MeasuredPoint::*value;
};
constexpr std::array<MeasuredColumn, 4> kMeasuredColumns{
    {{"sliding.velocity", &MeasuredPoint::velocity},
     {"load.normal_force", &MeasuredPoint::normalForce},
     {"load.nominal_pressure", &MeasuredPoint::nominalPressure},
     {"elastomer.temperature", &MeasuredPoint::temperature}}};

/// Returns whether a measured value equals that of the scene, as far as both are known.
bool agrees(const MeasuredColumn& column, const MeasuredPoint& point, const Scene& scene) {
  constexpr double kClose = 0.02;
  const Parameter& row = *findParameter(column.key);
  const double measured = point.*column.value;
  if (std::isnan(measured) || !isApplicable(row, scene)) return true;
  const double own = parameterNumber(row, scene);
  // Two per cent of a temperature would be six kelvins.
  const double allowed = column.key == "elastomer.temperature" ? 1.0 : kClose * std::abs(own);
  return std::abs(measured - own) <= allowed;
}

/// Returns the rows of a table that belong on an axis over another key than velocity. Adds a note
/// where some do not.
FrictionData onAxis(FrictionData table, CurveSet& set) {
  const Scene& scene = set.present.scene;
  const Parameter& row = sweptParameter(scene);
  const auto column = std::ranges::find(kMeasuredColumns, scene.sweep.key, &MeasuredColumn::key);
  const std::size_t all = table.points.size();
  std::size_t known = 0;
  if (column != kMeasuredColumns.end())
    std::erase_if(table.points, [&](const MeasuredPoint& point) {
      if (std::isnan(point.*column->value)) return true;
      ++known;
      return std::ranges::any_of(kMeasuredColumns, [&](const MeasuredColumn& other) {
        return other.key != column->key && !agrees(other, point, scene);
      });
    });
  const Message name(table.name);
  if (known == 0) {
    table.points.clear();
    set.notes.push_back(
        message("{} is not shown: it has no column of {}", name, Message(row.label)));
  } else if (table.points.empty()) {
    set.notes.push_back(
        message("{} is not shown: it was measured at another velocity, load or temperature than "
                "the scene's",
                name));
  } else if (table.points.size() < all) {
    set.notes.push_back(message(
        "{}: {} of {} points; the others were measured at another velocity, load or temperature",
        name, table.points.size(), all));
  }
  return table;
}

double measuredAbscissa(const MeasuredPoint& point, const Scene& scene) {
  if (scene.sweep.isOfVelocity()) return point.velocity * shiftToScene(point, scene);
  return point.*std::ranges::find(kMeasuredColumns, scene.sweep.key, &MeasuredColumn::key)->value;
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

std::vector<FrictionData> addComparisonData(Scene& scene, const std::vector<std::string>& files) {
  std::vector<FrictionData> given;
  for (const std::string& name : files) {
    const std::filesystem::path file(name);
    given.push_back(readFrictionData(file));
    std::error_code error;
    const std::filesystem::path beside =
        std::filesystem::proximate(file, scene.folder.empty() ? "." : scene.folder, error);
    scene.comparison.data.push_back({error ? name : beside.string(), {}});
  }
  if (scene.comparison.data.size() > kMostDataFiles)
    throw InputError(
        "", "--data",
        message("{} tables are more than {}", scene.comparison.data.size(), kMostDataFiles));
  return given;
}

bool hasComparisons(const CurveSet& set) {
  const Comparisons& comparison = set.present.scene.comparison;
  return !(comparison == Comparisons{}) || (!comparison.theory.empty() && !set.hasLawInPoints());
}

void placeMeasured(CurveSet& set) {
  const Scene& scene = set.present.scene;
  set.isReduced = false;
  for (MeasuredCurve& measured : set.measured) {
    measured.abscissas.clear();
    for (const MeasuredPoint& point : measured.data.points) {
      measured.abscissas.push_back(measuredAbscissa(point, scene));
      set.isReduced |=
          set.isOfVelocity() && temperatureAt(point, scene) != scene.elastomer.temperature;
    }
  }
}

void addComparisons(CurveSet& set, std::vector<FrictionData> data, const StateOptions& options) {
  const Scene& scene = set.present.scene;
  set.theories = theoryCurves(set, options.stop);
  for (FrictionData& table : data) {
    if (!set.isOfVelocity()) table = onAxis(std::move(table), set);
    if (table.points.empty()) continue;
    MeasuredCurve curve;
    std::vector<Scene> states;
    for (const MeasuredPoint& point : table.points) states.push_back(sceneAtPoint(point, scene));
    SteadyStates found = slideStates(states, options);
    if (found.isComplete) curve.computed = std::move(found.points);
    curve.data = std::move(table);
    set.measured.push_back(std::move(curve));
  }
  placeMeasured(set);
}

}  // namespace asperity
