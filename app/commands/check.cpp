// asperity check: reads and validates a scene, and prints a summary of a few lines.
#include <fmt/format.h>

#include <cstdio>
#include <vector>

#include "app/command_line.h"
#include "app/output.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/law.h"
#include "core/material/element_law.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

LawInput lawInputOf(const Scene& scene, const LineSource& source) {
  const SlidingConditions conditions = slidingConditions(scene, scene.sliding.velocity);
  return {conditions.shearModulus,
          conditions.relaxationTime,
          source.length(),
          source.statistics().rmsHeight,
          source.statistics().rmsSlope,
          scene.surface.hurst,
          loadOn(scene.load, source.length()).normalForce,
          scene.sliding.velocity};
}

std::string summaryOf(const Scene& scene, const LineSource& source, const LawInput& in) {
  const auto number = [](double value) { return shortNumber(value, 6); };
  const double spacing = source.length() / static_cast<double>(source.elements());
  std::string text =
      scene.title.empty() ? Words::tr("a valid scene") : printable(translated(scene.title));
  const auto add = [&text](const std::string& line) { text += "\n  " + line; };
  add(filled(Words::tr("line: L = %1 m, %2 elements of %3 m, rms height %4 m, rms slope %5"),
             {number(source.length()), std::to_string(source.elements()), number(spacing),
              number(in.rmsHeight), number(in.rmsSlope)}));
  if (in.rmsHeight > 0 && scene.load.kind != LoadKind::Indentation)
    add(filled(Words::tr("dimensionless force F_N / G h L = %1 (Eq. 14)"),
               {number(dimensionlessForce(in))}));
  // Eq. (13) has one relaxation time.
  if (in.rmsHeight > 0 && lawOf(scene.elastomer).kind() != ElementKind::Arms)
    add(filled(Words::tr("dimensionless velocity tau v slope / (sqrt(2) h) = %1 (Eq. 13)"),
               {number(dimensionlessVelocity(in))}));
  return text + "\n";
}

/// Numbers that follow from the scene.
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
  if (in.rmsHeight > 0 && lawOf(scene.elastomer).kind() != ElementKind::Arms)
    json["dimensionless_velocity"] = dimensionlessVelocity(in);
  return json;
}

/// Checks one scene; adds its answer to `answers`.
void checkScene(const CommonOptions& command, bool isOneOfMany,
                std::vector<nlohmann::ordered_json>& answers) {
  const Scene scene = sceneOf(command);
  withSceneContext(command, [&] {
    const LineSource source(scene, pointsPerElement(scene));
    const LawInput in = lawInputOf(scene, source);
    const std::string name = isOneOfMany ? command.scene + ": " : "";
    printSummary(command.json, command.quiet, name + summaryOf(scene, source, in));
    answers.push_back(provenance("check", scene));
    if (isOneOfMany) answers.back()["file"] = command.scene;
    answers.back()["valid"] = true;
    answers.back()["derived"] = derivedJson(scene, source, in);
  });
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
      checkScene(common, isOneOfMany, answers);
    } catch (const InputError& error) {
      if (!isOneOfMany) throw;
      std::fputs(("asperity: " + printable(error.what()) + "\n").c_str(), stderr);
      answers.push_back({{"schema", "asperity-check/1"},
                         {"file", scene},
                         {"valid", false},
                         {"message", std::string(error.what())}});
      status = kBadInput;
    }
  }
  if (common.json)
    fmt::print("{}\n",
               isOneOfMany ? nlohmann::ordered_json(answers).dump(2) : answers.front().dump(2));
  return status;
}

}  // namespace asperity
