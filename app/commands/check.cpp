// asperity check: reads and validates scenes and lessons, and prints a summary of a few lines.
#include <optional>
#include <vector>

#include "app/command_line.h"
#include "app/output.h"
#include "core/accuracy/prediction.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/contact/steady_solver.h"
#include "core/friction/curve_point.h"
#include "core/friction/law.h"
#include "core/lesson/lesson_answers.h"
#include "core/lesson/lesson_file.h"
#include "core/material/element_law.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

std::string summaryText(const Scene& scene, const LineSource& source, const LawInput& in,
                        const std::vector<Message>& reading) {
  const auto number = [](double value) { return answerNumber(value, 6); };
  const auto meters = [](double value) { return answerQuantity(value, "m", 6); };
  const double spacing = source.length() / static_cast<double>(source.elements());
  std::string text =
      scene.title.empty() ? Words::tr("a valid scene") : printable(translated(scene.title));
  const auto add = [&text](const std::string& line) { text += "\n  " + line; };
  add(filled(Words::tr("line: L = %1, %2 elements of %3, rms height %4, rms slope %5"),
             {meters(source.length()), std::to_string(source.elements()), meters(spacing),
              meters(in.rmsHeight), number(in.rmsSlope)}));
  if (in.rmsHeight > 0 && scene.load.kind != LoadKind::Indentation)
    add(filled(Words::tr("dimensionless force F_N / G h L = %1 (Eq. 14)"),
               {number(dimensionlessForce(in))}));
  if (const auto note = pressureNote(scene)) add(translated(*note));
  // Eq. (13) has one relaxation time. (The literal has two parts because lupdate takes 2 for a
  // digit of the root's code.)
  if (in.rmsHeight > 0 && elementLaw(scene.elastomer).kind() != ElementKind::Arms)
    add(filled(Words::tr("dimensionless velocity \u03C4 v \u2207z / (\u221A"
                         "2 h) = %1 (Eq. 13)"),
               {number(dimensionlessVelocity(in))}));
  for (const Message& fact : reading) add(translated(fact));
  const std::int64_t spikes = source.measured() ? source.measured()->spikes() : 0;
  if (spikes > 0) add(translated(spikesFact(spikes)));
  return text + "\n";
}

/// Returns numbers that follow from the scene.
nlohmann::ordered_json derivedJson(const Scene& scene, const LineSource& source,
                                   const LawInput& in) {
  nlohmann::ordered_json json = {
      {"length", source.length()},
      {"elements", source.elements()},
      {"spacing", source.length() / static_cast<double>(source.elements())},
      {"rms_height", in.rmsHeight},
      {"rms_slope", in.rmsSlope},
      {"normal_force", in.normalForce}};
  if (in.rmsHeight > 0 && scene.load.kind != LoadKind::Indentation)
    json["dimensionless_force"] = dimensionlessForce(in);
  if (in.rmsHeight > 0 && elementLaw(scene.elastomer).kind() != ElementKind::Arms)
    json["dimensionless_velocity"] = dimensionlessVelocity(in);
  return json;
}

/// Returns a warning where the target accuracy needs very many lines. Only a scene with a target is
/// predicted, which takes a part of a second.
std::optional<Message> costWarning(const Scene& scene, int threads) {
  if (scene.sliding.kind != SlidingKind::Steady || !choosesAccuracy(scene)) return {};
  return warningOf(scene, predictCurve(scene, threads));
}

/// Checks one scene; adds its answer to `answers`.
void checkScene(const CommonOptions& command, bool isOneOfMany,
                std::vector<nlohmann::ordered_json>& answers) {
  const Scene scene = loadScene(command);
  withSceneContext(command, [&] {
    // The solver throws where there is no steady state; such a scene is not valid.
    if (scene.sliding.kind == SlidingKind::Steady) const SteadySolver solver(scene);
    const LineSource source(scene, linePoints(scene));
    const LawInput in = lawInput(
        elementLaw(scene.elastomer), source.statistics(), source.length(), scene.surface.hurst,
        loadOn(scene.load, source.length()).normalForce, scene.sliding.velocity);
    const std::vector<Message> reading = readingFacts(scene);
    const std::optional<Message> warning = costWarning(scene, command.threads);
    const std::string name = isOneOfMany ? command.scene + ": " : "";
    printSummary(command, name + summaryText(scene, source, in, reading) +
                              (warning ? "  " + translated(*warning) + "\n" : ""));
    answers.push_back(lineProvenance("check", scene));
    if (isOneOfMany) answers.back()["file"] = command.scene;
    answers.back()["valid"] = true;
    answers.back()["derived"] = derivedJson(scene, source, in);
    addReadingFacts(answers.back(), reading);
    if (warning) answers.back()["warning"] = warning->english();
  });
}

/// Does the same for a lesson: all its scenes are read, and answers that no choice may cover are
/// computed.
void checkLesson(const CommonOptions& command, bool isOneOfMany,
                 std::vector<nlohmann::ordered_json>& answers) {
  if (!command.assignments.empty())
    throw InputError("", "--set", "sets keys of a scene, and this file is a lesson");
  const Lesson lesson = readLessonFile(command.scene, readNamedScene);
  checkChoices(lesson, command.scene, {.threads = command.threads});
  printSummary(command,
               (isOneOfMany ? command.scene + ": " : "") +
                   printable(lesson.title.in(presentLanguage())) + "\n  " +
                   filledLine(Words::tr("%1 minutes, %2 steps, %3 predictions"), lesson.minutes,
                              lesson.steps.size(), predictionCount(lesson)));
  answers.push_back({{"schema", "asperity-check/1"}});
  if (isOneOfMany) answers.back()["file"] = command.scene;
  answers.back()["lesson"] = lesson.title.english;
  answers.back()["steps"] = lesson.steps.size();
  answers.back()["sha256"] = lesson.digest;
  answers.back()["valid"] = true;
}

}  // namespace

int runCheck(const CheckCommand& command) {
  std::vector<nlohmann::ordered_json> answers;
  CommonOptions common = command.common;
  const bool isOneOfMany = command.scenes.size() > 1;
  int status = kDone;
  for (const std::string& scene : command.scenes) {
    common.scene = scene;
    try {
      if (isLessonFile(scene))
        checkLesson(common, isOneOfMany, answers);
      else
        checkScene(common, isOneOfMany, answers);
    } catch (const InputError& error) {
      if (!isOneOfMany) throw;
      printError(error.what());
      answers.push_back({{"schema", "asperity-check/1"},
                         {"file", scene},
                         {"valid", false},
                         {"message", std::string(error.what())}});
      status = kBadInput;
    }
  }
  if (common.json) printJson(isOneOfMany ? nlohmann::ordered_json(answers) : answers.front());
  return status;
}

}  // namespace asperity
