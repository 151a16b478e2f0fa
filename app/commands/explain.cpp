// asperity explain: prints the plan of a scene as an ordered list of stages, what is left out and
// why, and the expected cost of the run, or of a map; with --analyze also the real cost.
#include <fmt/format.h>

#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "core/accuracy/explanation.h"
#include "core/base/text.h"
#include "core/friction/parameter_map.h"
#include "core/friction/theory_curve.h"
#include "core/run/motion_accuracy.h"
#include "core/scene/scene_check.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

std::string timeText(double seconds) {
  if (seconds < 120) return answerQuantity(seconds, "s");
  return seconds < 7200 ? answerNumber(seconds / 60) + " min" : answerNumber(seconds / 3600) + " h";
}

std::string percent(double part) {
  return answerNumber(100 * part, 2) + " %";
}

std::string budgetText(const ErrorBudget& error) {
  std::string parts;
  const auto add = [&](const std::string& name, double part) {
    if (!std::isfinite(part)) return;
    if (!parts.empty()) parts += Words::tr(", ");
    parts += name + " " + percent(part);
  };
  add(Words::tr("resolution"), error.resolution);
  add(Words::tr("standard error"), error.standardError);
  add(Words::tr("force balance"), error.forceBalance);
  add(Words::tr("time step"), error.timeStep);
  add(Words::tr("settling"), error.settling);
  const std::string total =
      error.isStandardErrorUnknown ? Words::tr("unknown") : percent(error.total());
  const std::string text = fmt::format("{} ({})", total, parts);
  if (!std::isfinite(error.modelDifference)) return text;
  return filled(Words::tr("%1; differs from the resolved line by %2"),
                {text, percent(error.modelDifference)});
}

std::string workText(const Prediction& prediction) {
  if (prediction.steps > 0)
    return filled(
        Words::tr("%1 steps of %2 elements, without drawing"),
        {fmt::format("{:.0f}", prediction.steps), fmt::format("{:.0f}", prediction.elements)});
  return filled(Words::tr("%1 simulations"), {fmt::format("{:.0f}", prediction.simulations)});
}

std::string threadsText(int threads) {
  return threads == 1 ? Words::tr("one thread")
                      : filled(Words::tr("%1 threads"), {std::to_string(threads)});
}

std::string stageLines(const std::vector<PlanStage>& stages, bool running) {
  std::string text;
  int number = 0;
  for (const PlanStage& stage : stages) {
    if (stage.runs != running) continue;
    const std::string name = translated(stage.name), reason = translated(stage.reason);
    text += running ? fmt::format("  {:>2}. {}: {}\n", ++number, name, reason)
                    : "   -  " + filledLine(Words::tr("no %1: %2"), name, reason);
  }
  return text;
}

/// Returns time, memory and error below each other.
std::string costLines(const std::string& time, const std::string& memory,
                      const ErrorBudget& error) {
  std::string text;
  for (const auto& [name, value] : {std::pair{Words::tr("time"), time},
                                    {Words::tr("memory"), memory},
                                    {Words::tr("error"), budgetText(error)}})
    text += fmt::format("      {:<10}{}\n", name, value);
  return text;
}

std::string mebibytes(double bytes) {
  return answerNumber(bytes / (1 << 20), 2) + " MiB";
}

std::string mapLines(const MapCost& map) {
  const std::string columns = std::to_string(map.columns), rows = std::to_string(map.rows);
  const std::string lines = fmt::format("{:.0f}", map.lines);
  const std::string work =
      map.different > 0
          ? filled(Words::tr("%1 times %2 states, %3 of them different, on %4 lines each"),
                   {columns, rows, std::to_string(map.different), lines})
          : filled(Words::tr("%1 times %2 states on %3 lines each"), {columns, rows, lines});
  return Words::tr("the map") + "\n" +
         fmt::format("      {:<10}{}\n", Words::tr("time"),
                     filled(Words::tr("%1 on %2 (%3)"),
                            {timeText(map.seconds), threadsText(map.threads), work}));
}

/// Returns the plan of a scene and its expected cost as a text in the present language.
std::string explanationText(const Explanation& explanation) {
  const Scene& scene = explanation.scene;
  std::string text =
      scene.title.empty() ? std::string() : printable(translated(scene.title)) + "\n";
  text += filledLine(Words::tr("asperity %1 runs"), explanation.verb) +
          stageLines(explanation.stages, true) + Words::tr("and leaves out") + "\n" +
          stageLines(explanation.stages, false);
  if (std::isfinite(explanation.fewContactsVelocity))
    text += filledLine(
        Words::tr("above %1 few contacts carry the load (region IV): F_N / (4 eta v), the sum of "
                  "the heights climbed by all contacts of one period, is below 0.1 "
                  "h; the border belongs to the finite period and moves with it"),
        answerQuantity(explanation.fewContactsVelocity, "m/s"));
  if (!explanation.excitation.empty()) text += translated(explanation.excitation) + "\n";
  const bool isMirrored =
      scene.surface.kind == SurfaceKind::Measured && scene.surface.processing.seam == Seam::Mirror;
  if (std::isfinite(explanation.normalForce) &&
      (isMirrored || scene.load.kind == LoadKind::Pressure))
    text += filledLine(
        isMirrored ? Words::tr("F_N = %1 on one period of %2, which is twice the file's; "
                               "F_N / L = %3")
                   : Words::tr("F_N = %1 on one period of %2; F_N / L = %3"),
        answerQuantity(explanation.normalForce, "N"), answerQuantity(explanation.length, "m"),
        answerQuantity(explanation.normalForce / explanation.length, "N/m"));
  for (const Theory theory : theoriesBeside(scene))
    text += translated(message("{}: {}", Message(theoryEntry(theory).name),
                               Message(theoryEntry(theory).range))) +
            "\n";
  text += translatedLines(explanation.reading) + noteLines(explanation.notes);
  if (const auto& predicted = explanation.predicted) {
    text += Words::tr("predicted") + "\n" +
            costLines(filled(Words::tr("%1 on %2 (%3)"),
                             {timeText(predicted->seconds), threadsText(predicted->threads),
                              workText(*predicted)}),
                      mebibytes(predicted->memory), predicted->error);
    text += translatedLine(warningOf(scene, *predicted));
  }
  if (const auto& measured = explanation.measured)
    text += Words::tr("measured") + "\n" +
            costLines(timeText(measured->seconds),
                      filled(Words::tr("%1 more than before"), {mebibytes(measured->memory)}),
                      measured->error);
  if (explanation.map) text += mapLines(*explanation.map);
  return text;
}

}  // namespace

int runExplain(const ExplainCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] {
    Explanation explanation = explainRun(scene, command.common.threads);
    if (!command.x.empty()) {
      requireSteadySliding(scene, "asperity map");
      explanation.map =
          predictMap(scene, mapAxis(scene, parseRangeOption("--x", command.x)),
                     mapAxis(scene, parseRangeOption("--y", command.y)), command.common.threads);
    }
    if (command.analyze) analyzeRun(explanation, command.common.threads);
    printSummary(command.common, explanationText(explanation));
    if (command.common.json) fmt::print("{}", explanationJson(explanation));
  });
  return kDone;
}

}  // namespace asperity
