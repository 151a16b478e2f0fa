// asperity accuracy: error against time of every method on the scene's own lines, as tables and
// diagrams.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/command_line.h"
#include "app/headless_pictures.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "core/accuracy/work_precision_file.h"
#include "core/run/motion_accuracy.h"
#include "core/scene/atomic_file.h"
#include "core/scene/effects.h"
#include "core/scene/provenance.h"
#include "ui/language/translated.h"
#include "ui/picture/diagram_picture.h"
#include "ui/picture/picture_origin.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles[] = {"accuracy.csv",       "accuracy.json",      "work_precision.png",
                                  "work_precision.svg", "standard_error.png", "standard_error.svg"};

std::string fileIn(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

WorkPrecision compute(const Scene& scene, const CommonOptions& common) {
  ProgressBar bar("methods", common.quiet);
  WorkPrecisionOptions options;
  options.progress = [&bar](double part) {
    bar.show(static_cast<std::int64_t>(1000 * part), 1000);
  };
  return saidOfScene(common, [&] {
    WorkPrecision comparison = workPrecision(scene, options);
    addMarchErrors(comparison);
    return comparison;
  });
}

void writePictures(const std::string& folder, const WorkPrecision& comparison) {
  HeadlessPictures pictures;
  const std::string origin = pictureOrigin("accuracy", comparison.scene);
  const auto write = [&](const DiagramSheet& sheet, const char* png, const char* svg) {
    const DrawList list = composeDiagrams(sheet, printOptions(sheet));
    for (const char* name : {png, svg})
      pictures.write(fileIn(folder, name), list,
                     {translated(sheet.title), origin, printOptions(sheet).scale});
  };
  write(workPrecisionSheet(comparison), "work_precision.png", "work_precision.svg");
  write(standardErrorSheet(comparison), "standard_error.png", "standard_error.svg");
  pictures.finish();
}

std::string summaryOf(const WorkPrecision& comparison, const std::string& folder) {
  std::string text;
  for (const RegionPrecision& region : comparison.regions) {
    text += fmt::format("region {}, {:.2g} to {:.2g} m/s\n", region.region,
                        region.velocities.front(), region.velocities.back());
    for (const WorkPrecisionPoint& point : region.points) {
      const bool isPresent = point.choice == comparison.present;
      text += fmt::format("  {:<14} {:>8.1e} {}  {:>8.2g} s{}{}{}\n", nameOf(point.choice),
                          point.error, point.isDifference ? "difference" : "error     ",
                          point.seconds, point.isExtrapolated ? " (extrapolated)" : "",
                          point.isOnFront ? "  best for its time" : "",
                          isPresent ? "  <- this scene" : "");
    }
    text += fmt::format("  a march in time: half the step changes friction by {:.2g} %{}\n",
                        100 * region.timeStepError,
                        std::isfinite(region.settlingError)
                            ? fmt::format(", settling by {:.2g} %", 100 * region.settlingError)
                            : std::string());
  }
  for (const char* name : kFiles) text += fmt::format("wrote {}\n", fileIn(folder, name));
  return text;
}

}  // namespace

int runAccuracy(const AccuracyCommand& command) {
  const Scene scene = sceneOf(command.common);
  saidOfScene(command.common, [&] { needSteadySliding(scene, "asperity accuracy"); });
  makeFolder(command.output);
  for (const char* name : kFiles) {
    checkWritable(fileIn(command.output, name));
    checkNoInput(fileIn(command.output, name), inputsOf(command.common, scene));
  }
  const WorkPrecision comparison = compute(scene, command.common);
  const std::string json = workPrecisionJson(comparison);
  writeFileAtomically(
      fileIn(command.output, "accuracy.csv"),
      provenanceComment("accuracy", comparison.scene) + workPrecisionCsv(comparison));
  writeFileAtomically(fileIn(command.output, "accuracy.json"), json);
  writePictures(command.output, comparison);
  printSummary(command.common.json, command.common.quiet, summaryOf(comparison, command.output));
  if (command.common.json) fmt::print("{}", json);
  return kDone;
}

}  // namespace asperity
