#include "core/accuracy/explanation.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/accuracy/target_curve.h"
#include "core/friction/line_plan.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMeasuredLines = 16;  // of the resolution

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::string timeText(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} \u00B5s", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.3g} ms", 1e3 * seconds);
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60)
                        : fmt::format("{:.1f} h", seconds / 3600);
}

std::string percent(double part) {
  return fmt::format("{:.2g} %", 100 * part);
}

std::string budgetText(const ErrorBudget& error) {
  std::string parts;
  const auto add = [&](const char* name, double part) {
    if (!std::isfinite(part)) return;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name, percent(part));
  };
  add("resolution", error.resolution);
  add("standard error", error.standardError);
  add("force balance", error.forceBalance);
  add("time step", error.timeStep);
  add("settling", error.settling);
  std::string text = fmt::format("{} ({})", percent(error.total()), parts);
  if (std::isfinite(error.modelDifference))
    text += fmt::format("; differs from the resolved line by {}", percent(error.modelDifference));
  return text;
}

Json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
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

std::string workText(const Prediction& prediction) {
  if (prediction.steps > 0)
    return fmt::format("{:.0f} steps of {:.0f} elements, without drawing", prediction.steps,
                       prediction.elements);
  return fmt::format("{:.0f} simulations", prediction.simulations);
}

std::string stageLines(const std::vector<PlanStage>& stages, bool running) {
  std::string text;
  int number = 0;
  for (const PlanStage& stage : stages)
    if (stage.runs == running)
      text += running ? fmt::format("  {:>2}. {}: {}\n", ++number, stage.name, stage.reason)
                      : fmt::format("   -  no {}: {}\n", stage.name, stage.reason);
  return text;
}

}  // namespace

Explanation explain(const Scene& scene, int threads) {
  const bool isSteady = scene.sliding.kind == SlidingKind::Steady;
  Explanation explanation{scene,
                          isSteady ? "curve" : "render",
                          planOnLine(scene, isSteady ? Purpose::Curve : Purpose::Picture),
                          {},
                          {}};
  if (isSteady) explanation.predicted = predictCurve(scene, threads);
  return explanation;
}

void analyze(Explanation& explanation, int threads) {
  if (!explanation.predicted) return;
  const double before = peakMemory();
  const auto start = std::chrono::steady_clock::now();
  CurveOptions options;
  options.threads = threads;
  curveOf(explanation.scene, options);
  Measurement measured;
  measured.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  measured.memory = peakMemory() - before;
  measured.error = measureError(explanation.scene, kMeasuredLines, threads);
  explanation.measured = measured;
}

std::string explanationText(const Explanation& explanation) {
  const Scene& scene = explanation.scene;
  std::string text = fmt::format("{}asperity {} runs\n",
                                 scene.title.empty() ? "" : scene.title + "\n", explanation.verb) +
                     stageLines(explanation.stages, true) + "and leaves out\n" +
                     stageLines(explanation.stages, false);
  if (const auto& predicted = explanation.predicted) {
    text += fmt::format("predicted\n      time    {} on {} thread{} ({})\n",
                        timeText(predicted->seconds), predicted->threads,
                        predicted->threads == 1 ? "" : "s", workText(*predicted));
    text += fmt::format("      memory  {:.2g} MiB\n", predicted->memory / (1 << 20));
    text += fmt::format("      error   {}\n", budgetText(predicted->error));
  }
  if (const auto& measured = explanation.measured) {
    text += fmt::format("measured\n      time    {}\n", timeText(measured->seconds));
    text +=
        fmt::format("      memory  {:.2g} MiB more than before\n", measured->memory / (1 << 20));
    text += fmt::format("      error   {}\n", budgetText(measured->error));
  }
  return text;
}

std::string explanationJson(const Explanation& explanation) {
  Json root = provenance("explain", explanation.scene);
  root["of_verb"] = explanation.verb;
  Json stages = Json::array();
  for (const PlanStage& stage : explanation.stages)
    stages.push_back({{"name", stage.name}, {"runs", stage.runs}, {"reason", stage.reason}});
  root["stages"] = std::move(stages);
  root["predicted"] = nullptr;
  root["measured"] = nullptr;
  if (const auto& predicted = explanation.predicted)
    root["predicted"] = {
        {"seconds", predicted->seconds},         {"threads", predicted->threads},
        {"memory_bytes", predicted->memory},     {"lines", predicted->lines},
        {"simulations", predicted->simulations}, {"relative_error", budgetJson(predicted->error)}};
  if (explanation.predicted && explanation.predicted->steps > 0) {
    root["predicted"]["steps"] = explanation.predicted->steps;
    root["predicted"]["elements"] = explanation.predicted->elements;
  }
  if (const auto& measured = explanation.measured)
    root["measured"] = {{"seconds", measured->seconds},
                        {"memory_bytes", measured->memory},
                        {"relative_error", budgetJson(measured->error)}};
  return root.dump(2) + "\n";
}

}  // namespace asperity
