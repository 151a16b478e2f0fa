// asperity sensitivity: how much friction changes with each parameter at the scene's own state.
#include "app/command_line.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/chart/influence_sheets.h"
#include "core/friction/curve_point.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"

namespace asperity {

int runSensitivity(const TableCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity sensitivity"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  const std::vector<Exponent> exponents = withSceneContext(command.common, [&] {
    ProgressBar bar(Words::tr("states"), command.common.quiet);
    StateOptions options{.threads = command.common.threads,
                         .progress = [&bar](double part) { bar.showPart(part); }};
    return sensitivityExponents(scene, sensitivities(scene, options));
  });
  const auto origin = [&] { return provenance("sensitivity", scene); };
  writeResult(command, settings,
              {.csv = [&] { return provenanceComment(origin()) + sensitivityCsv(exponents); },
               .json = [&] { return sensitivityJson(scene, exponents); },
               .sheet = [&] { return sensitivitySheet(scene, exponents); },
               .origin = origin,
               .summary = translatedLine(pressureNote(scene)),
               .reading = readingFacts(scene),
               .printed = sensitivityText(exponents, {Words::tr("parameter"), Words::tr("value"),
                                                      Words::tr("exponent"), Words::tr("error")})});
  return kDone;
}

}  // namespace asperity
