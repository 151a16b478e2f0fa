#include "core/accuracy/explanation.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "core/accuracy/compute_curve.h"
#include "core/accuracy/target_curve.h"
#include "core/base/json_text.h"
#include "core/chart/curve_regions.h"
#include "core/chart/material_sheets.h"
#include "core/friction/ensemble.h"
#include "core/friction/theory_curve.h"
#include "core/scene/list_text.h"
#include "core/scene/provenance.h"
#include "core/scene/sweep.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMeasuredLines = 16;  // for the measured error of resolution

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

Json budgetJson(const ErrorBudget& error) {
  return {{"total", numberOrNull(error.total())},
          {"resolution", numberOrNull(error.resolution)},
          {"standard_error", numberOrNull(error.standardError)},
          {"force_balance", numberOrNull(error.forceBalance)},
          {"time_step", numberOrNull(error.timeStep)},
          {"settling", numberOrNull(error.settling)},
          {"model_difference", numberOrNull(error.modelDifference)}};
}

/// Adds the properties of the line and of its load. It reads no long profile and makes no long
/// line.
void addLine(Explanation& explanation) {
  constexpr std::int64_t kLongProfile = std::int64_t{1} << 16;  // rows
  constexpr std::int64_t kLongLine = std::int64_t{1} << 22;     // elements
  const Scene& scene = explanation.scene;
  const LineExtent extent = lineExtent(scene);
  explanation.reading = readingFacts(scene);
  explanation.length = extent.length;
  if (scene.load.kind != LoadKind::Indentation)
    explanation.normalForce = loadOn(scene.load, extent.length).normalForce;
  if (extent.rows > kLongProfile || extent.elements > kLongLine) return;
  const LineSource source(scene, 1);
  explanation.notes = lineNotes(source);
  if (!measuredFrequencies(scene.elastomer)) return;
  const Excitation excitation(scene, source);
  explanation.excitation = describeExcitation(scene, excitation);
  explanation.notes.add(elastomerNotes(scene.elastomer, source.statistics().rmsSlope,
                                       excitation.shareNotMeasured(scene.sliding.velocity)));
}

/// A curve over velocity that costs as much as the scene's curve over another key: all points on
/// the same lines where only their scaling differs, else one point that is computed `times` times.
struct EqualCost {
  Scene scene;
  double times = 1;
};

EqualCost equalCost(const Scene& scene) {
  if (scene.sweep.isOfVelocity()) return {scene};
  const std::vector<double> values = sweepValues(scene);
  Scene first = sceneAt(scene, values.front()), last = sceneAt(scene, values.back());
  first.surface.rmsHeight = last.surface.rmsHeight;  // it scales a line
  const bool sharesLines = first.surface == last.surface;
  const auto points = static_cast<std::int64_t>(values.size());
  EqualCost equal{sceneAt(scene, values[values.size() / 2]),
                  sharesLines ? 1 : static_cast<double>(points)};
  equal.scene.sweep.velocityFrom = equal.scene.sweep.velocityTo = scene.sliding.velocity;
  equal.scene.sweep.points = sharesLines ? points : 1;
  return equal;
}

}  // namespace

Explanation explain(const Scene& scene, int threads) {
  const bool isSteady = scene.sliding.kind == SlidingKind::Steady;
  Explanation explanation{scene, isSteady ? "curve" : "render",
                          planOnLine(scene, isSteady ? Purpose::Curve : Purpose::Picture)};
  addLine(explanation);
  if (!isSteady) return explanation;
  Scene atForce = scene;
  atForce.load = loadOn(scene.load, explanation.length);
  explanation.fewContactsVelocity = fewContactsVelocity(atForce, lineExtent(scene).rmsHeight);
  const EqualCost equal = equalCost(scene);
  explanation.predicted = predictCurve(equal.scene, threads);
  explanation.predicted->seconds *= equal.times;
  explanation.predicted->simulations *= equal.times;
  return explanation;
}

std::vector<Theory> theoriesBeside(const Scene& scene) {
  if (scene.comparison.theory == Comparisons{}.theory) return {};
  return scene.comparison.theory;
}

void analyze(Explanation& explanation, int threads) {
  if (!explanation.predicted) return;
  const double before = peakMemory();
  const auto start = std::chrono::steady_clock::now();
  CurveOptions options;
  options.threads = threads;
  computeCurve(explanation.scene, options);
  Measurement measured;
  measured.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  measured.memory = peakMemory() - before;
  measured.error = measureError(equalCost(explanation.scene).scene, kMeasuredLines, threads);
  explanation.measured = measured;
}

std::string explanationJson(const Explanation& explanation) {
  Json root = provenance("explain", explanation.scene);
  root["oversampling_used"] =
      lineProvenance(explanation.verb, explanation.scene)["oversampling_used"];
  root["of_verb"] = explanation.verb;
  Json stages = Json::array();
  for (const PlanStage& stage : explanation.stages)
    stages.push_back(
        {{"name", stage.name}, {"runs", stage.runs}, {"reason", stage.reason.english()}});
  root["stages"] = std::move(stages);
  root["few_summits_above"] = numberOrNull(explanation.fewContactsVelocity);
  if (!explanation.excitation.empty()) root["excitation"] = explanation.excitation.english();
  root["length"] = explanation.length;
  root["normal_force"] = numberOrNull(explanation.normalForce);
  root["force_per_length"] = numberOrNull(explanation.normalForce / explanation.length);
  addReadingFacts(root, explanation.reading);
  root["notes"] = Json::array();
  for (const Note note : explanation.notes.list())
    root["notes"].push_back({{"word", noteWord(note)}, {"meaning", noteSentence(note).english()}});
  for (const Theory theory : theoriesBeside(explanation.scene)) {
    const TheoryEntry& entry = theoryEntry(theory);
    root["theories"].push_back({{"theory", theoryWords()[static_cast<std::size_t>(theory)]},
                                {"name", entry.name},
                                {"range", entry.range}});
  }
  root["predicted"] = nullptr;
  root["measured"] = nullptr;
  if (const auto& predicted = explanation.predicted) {
    root["predicted"] = {
        {"seconds", predicted->seconds},         {"threads", predicted->threads},
        {"memory_bytes", predicted->memory},     {"lines", predicted->lines},
        {"simulations", predicted->simulations}, {"relative_error", budgetJson(predicted->error)}};
    if (const auto warning = warningOf(explanation.scene, *predicted))
      root["predicted"]["warning"] = warning->english();
  }
  if (explanation.predicted && explanation.predicted->steps > 0) {
    root["predicted"]["steps"] = explanation.predicted->steps;
    root["predicted"]["elements"] = explanation.predicted->elements;
  }
  if (const auto& measured = explanation.measured)
    root["measured"] = {{"seconds", measured->seconds},
                        {"memory_bytes", measured->memory},
                        {"relative_error", budgetJson(measured->error)}};
  if (const auto& map = explanation.map)
    root["map"] = {{"columns", map->columns},
                   {"rows", map->rows},
                   {"different", map->different > 0 ? Json(map->different) : Json(nullptr)},
                   {"lines", map->lines},
                   {"seconds", map->seconds},
                   {"threads", map->threads}};
  return jsonFile(root);
}

}  // namespace asperity
