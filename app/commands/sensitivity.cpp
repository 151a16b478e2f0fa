// asperity sensitivity: how much friction changes with each parameter at the scene's own state.
#include "app/commands/sheet_command.h"
#include "app/progress_bar.h"
#include "core/base/input_error.h"
#include "core/chart/sensitivity_sheet.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "ui/language/words.h"

namespace asperity {

int runSensitivity(const SheetCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity sensitivity"); });
  const PictureSettings settings = checkSheetOutputs(command, scene, {1200, 800, "print"});
  const std::vector<Exponent> exponents = withSceneContext(command.common, [&] {
    if (choosesAccuracy(scene))
      throw InputError("", "accuracy.target_relative_error",
                       "differences need the same lines on both sides; give accuracy.scheme and "
                       "ensemble.realizations instead of a target");
    ProgressBar bar(Words::tr("states"), command.common.quiet);
    StateOptions options;
    options.threads = command.common.threads;
    options.progress = [&bar](double part) { bar.showPart(part); };
    return sensitivityExponents(scene, sensitivities(scene, options));
  });
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  writeAnswer(command, settings,
              {provenance("sensitivity", scene), sensitivityCsv(exponents),
               sensitivityJson(scene, exponents),
               sensitivityText(exponents, {Words::tr("parameter"), Words::tr("value"),
                                           Words::tr("exponent"), Words::tr("error")}),
               sensitivitySheet(scene, exponents)});
  return kDone;
}

}  // namespace asperity
