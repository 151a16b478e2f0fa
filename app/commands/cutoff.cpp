// asperity cutoff: friction against the short-wave cut-off of the line.
#include "app/commands/sheet_command.h"
#include "app/progress_bar.h"
#include "core/chart/cutoff_sheet.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "ui/language/words.h"

namespace asperity {

int runCutoff(const SheetCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity cutoff"); });
  const PictureSettings settings = checkSheetOutputs(command, scene, {1200, 1000, "print"});
  const std::vector<CutoffPoint> points = withSceneContext(command.common, [&] {
    ProgressBar bar(Words::tr("states"), command.common.quiet);
    StateOptions options;
    options.threads = command.common.threads;
    options.progress = [&bar](double part) { bar.showPart(part); };
    return frictionOverCutoff(scene, options);
  });
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  writeAnswer(command, settings,
              {provenance("cutoff", scene),
               cutoffCsv(points),
               cutoffJson(scene, points),
               {},
               cutoffSheet(scene, points)});
  return kDone;
}

}  // namespace asperity
