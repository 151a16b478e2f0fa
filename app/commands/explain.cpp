// asperity explain: prints the plan of a scene as an ordered list of stages, what is left out and
// why, and the expected cost of the run, or of a map; with --analyze also the real cost.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/explanation_text.h"
#include "app/output.h"
#include "core/run/motion_accuracy.h"
#include "core/scene/scene_check.h"

namespace asperity {

int runExplain(const ExplainCommand& command) {
  const Scene scene = sceneOf(command.common);
  withSceneContext(command.common, [&] {
    Explanation explanation = explainRun(scene, command.common.threads);
    if (!command.x.empty()) {
      needSteadySliding(scene, "asperity map");
      explanation.map =
          predictMap(scene, mapAxis(scene, rangeFromOption("--x", command.x)),
                     mapAxis(scene, rangeFromOption("--y", command.y)), command.common.threads);
    }
    if (command.analyze) analyzeRun(explanation, command.common.threads);
    printSummary(command.common.json, command.common.quiet, explanationText(explanation));
    if (command.common.json) fmt::print("{}", explanationJson(explanation));
  });
  return kDone;
}

}  // namespace asperity
