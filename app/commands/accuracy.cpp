// asperity accuracy: error versus run time of every method on the scene's own lines, as tables and
// diagrams.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/accuracy/work_precision_sheet.h"
#include "core/base/atomic_file.h"
#include "core/run/motion_accuracy.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"
#include "core/surface/measured_summary.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

constexpr const char* kFiles[] = {"accuracy.csv",       "accuracy.json",      "work_precision.png",
                                  "work_precision.svg", "work_precision.pdf", "standard_error.png",
                                  "standard_error.svg", "standard_error.pdf"};

WorkPrecision compute(const Scene& scene, const CommonOptions& common) {
  ProgressBar bar(Words::tr("methods"), common.quiet);
  WorkPrecisionOptions options;
  options.progress = [&bar](double part) { bar.showPart(part); };
  return withSceneContext(common, [&] {
    WorkPrecision comparison = workPrecision(scene, options);
    addMarchErrors(comparison);
    return comparison;
  });
}

void writePictures(const FolderCommand& command, const WorkPrecision& comparison) {
  HeadlessPictures pictures(pictureSettings(command.picture).backend);
  const auto write = [&](const DiagramSheet& sheet, const std::string& name) {
    const ProvenanceOptions given(optionsInFolder(command.common.given, name + ".png"));
    const std::string origin = pictureOrigin("accuracy", comparison.scene);
    const PictureSettings settings = pictureSettings(command.picture, printDefaults(sheet));
    const DrawList list = drawSheet(sheet, settings);
    for (const char* extension : {".png", ".svg", ".pdf"})
      pictures.write(fileIn(command.output, name + extension), list,
                     settings.properties(translated(sheet.title), origin));
  };
  write(workPrecisionSheet(comparison), "work_precision");
  write(standardErrorSheet(comparison), "standard_error");
  pictures.finish();
}

/// Aligns numbers in a column at the right.
std::string column(const std::string& number) {
  return fmt::format("{:>8}", number);
}

/// Pads with spaces; counts letters, not bytes.
std::string padded(const std::string& text, std::size_t width) {
  return fmt::format("{:<{}}", text, width);
}

std::size_t letterCount(const std::string& text) {
  return static_cast<std::size_t>(QString::fromStdString(text).size());
}

std::string methodLine(const WorkPrecisionPoint& point, bool isPresent, std::size_t nameWidth) {
  const std::string difference = Words::tr("difference"), error = Words::tr("error");
  const std::size_t width = std::max(letterCount(difference), letterCount(error));
  std::string text = fmt::format(
      "  {} {} {}  {}", padded(translated(methodName(point.choice)), nameWidth),
      column(answerNumber(point.error, 2)), padded(point.isDifference ? difference : error, width),
      column(answerQuantity(point.secondsWithLine, "s", 2)));
  if (point.isExtrapolated) text += " " + Words::tr("(extrapolated)");
  if (point.isOnFront) text += "  " + Words::tr("best for its time");
  if (isPresent) text += "  " + Words::tr("<- this scene");
  return text + "\n";
}

std::string marchLine(const RegionPrecision& region) {
  const auto percent = [](double part) { return answerNumber(100 * part, 2); };
  std::string text =
      "  " + filled(Words::tr("a march in time: half the step changes friction by %1 %"),
                    {percent(region.timeStepError)});
  if (std::isfinite(region.settlingError))
    text += filled(Words::tr(", settling by %1 %"), {percent(region.settlingError)});
  return text + "\n";
}

std::string summaryText(const WorkPrecision& comparison, const std::string& folder) {
  std::string text;
  for (const RegionPrecision& region : comparison.regions) {
    text += filledLine(Words::tr("region %1, %2 to %3 m/s"), region.region,
                       answerNumber(region.velocities.front(), 2),
                       answerNumber(region.velocities.back(), 2));
    std::size_t width = 0;
    for (const WorkPrecisionPoint& point : region.points)
      width = std::max(width, letterCount(translated(methodName(point.choice))));
    for (const WorkPrecisionPoint& point : region.points)
      text += methodLine(point, point.choice == comparison.present, width);
    text += marchLine(region);
  }
  text += translatedLines(readingFacts(comparison.scene));
  for (const char* name : kFiles) text += wroteLine(fileIn(folder, name));
  return text;
}

}  // namespace

int runAccuracy(const FolderCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] {
    requireSteadySliding(scene, "asperity accuracy");
    requireVelocityAxis(scene, "asperity accuracy");
  });
  pictureSettings(command.picture);
  const ColumnChoice columns(command.columns, {"accuracy"});
  makeFolder(command.output);
  for (const char* name : kFiles) {
    checkWritable(fileIn(command.output, name));
    checkNoInput(fileIn(command.output, name), inputFiles(command.common, scene));
  }
  const WorkPrecision comparison = compute(scene, command.common);
  const ProvenanceOptions given(optionsInFolder(command.common.given, "accuracy.csv"));
  const std::string json = workPrecisionJson(comparison);
  writeFileAtomically(fileIn(command.output, "accuracy.csv"),
                      columns.select(provenanceComment("accuracy", comparison.scene) +
                                     workPrecisionCsv(comparison)));
  writeFileAtomically(fileIn(command.output, "accuracy.json"), json);
  writePictures(command, comparison);
  printSummary(command.common, summaryText(comparison, command.output));
  if (command.common.json) fmt::print("{}", json);
  return kDone;
}

}  // namespace asperity
