// asperity fit: parameters of a scene that fit measured friction, with their errors.
#include <fmt/format.h>

#include <algorithm>

#include "app/command_line.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/chart/curve_set.h"
#include "core/chart/fit_report.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"

namespace asperity {
int runFit(const FitCommand& command) {
  const PictureSettings settings = pictureSettings(command.picture);
  CurveArguments beside;
  beside.data = command.data;
  const ColumnChoice columns(command.columns, {"fit", "curve"});
  const ComparedScene compared = withCurveOptions(loadScene(command.common), beside);
  const Scene& scene = compared.scene;
  if (scene.comparison.data.empty()) throw missingFrictionData();
  OutputFolder output(command.output, inputFiles(command.common, scene), settings);
  return withSceneContext(command.common, [&] {
    requireVelocityAxis(scene, "asperity fit");
    const std::vector<VariedParameter> varied = parseVariedParameters(command.varied, scene);
    const std::vector<FrictionData> data = readComparisonData(scene, compared.given);
    FitOptions options;
    options.threads = command.common.threads;
    options.hasProfiles = !command.withoutProfiles;
    ProgressBar bar(Words::tr("evaluations"), command.common.quiet);
    options.progress = [&bar](int evaluations, double) {
      constexpr int kDefault = 150;
      bar.show(std::min(evaluations, kDefault - 1), kDefault);
    };
    FittedCurve fitted = fitWithCurve(scene, data, varied, options);
    fitted.varied = command.varied;
    const FitReport report = [&] {
      const ProvenanceOptions given(optionsInFolder(command.common.given, "fit.json"));
      return fitReport(fitted, command.output);
    }();
    for (const auto& [name, bytes] : report.texts)
      output.addText(name, name.ends_with(".csv") ? columns.selectAvailable(bytes) : bytes);
    for (const NamedSheet& sheet : report.sheets) output.addSheet(sheet);
    output.setOtherSheets({"profiles"});
    output.write(command.common.given, [&] { return fitProvenance(fitted.start, fitted.fit); });
    printSummary(command.common, translatedLines(describeFit(fitted.fit)) +
                                     translatedLines(report.reading) + output.summary());
    if (command.common.json) fmt::print("{}", report.texts.front().second);
    return kDone;
  });
}

}  // namespace asperity
