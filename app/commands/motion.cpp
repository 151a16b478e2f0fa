// asperity motion: friction, indentation, contact and power over time while the velocity changes,
// as a table and as a picture.
#include "core/run/motion_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "app/picture_options.h"
#include "app/pictures/headless_pictures.h"
#include "app/progress_bar.h"
#include "core/base/atomic_file.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

/// The size of texts relative to the usual one, times the scale. Four strips make texts this small
/// in the usual picture; a picture of few pixels for print then has relatively larger texts.
constexpr float kMotionText = 0.6F;

MotionTable compute(const Scene& scene, const MotionCommand& command) {
  ProgressBar bar(Words::tr("time steps"), command.common.quiet);
  MotionOptions options;
  options.every = command.every;
  options.lines = command.lines;
  options.threads = command.common.threads;
  options.progress = [&bar](std::int64_t done, std::int64_t total) { bar.show(done, total); };
  return withSceneContext(command.common, [&] { return marchMotion(scene, options); });
}

void writePicture(const std::string& output, const Scene& scene, const MotionTable& table,
                  const PictureSettings& settings, const MotionCommand& command,
                  HeadlessPictures& pictures) {
  const ProvenanceOptions given(optionsFor(command.common.given, output));
  nlohmann::ordered_json origin = motionProvenance("motion", scene, table);
  origin["picture"] = settings.json();
  const DiagramSheet sheet = motionSheet(scene, table);
  pictures.write(output, drawSheet(sheet, settings, kMotionText),
                 settings.properties(translated(sheet.title), provenanceLine(origin)));
}

std::string csvText(const Scene& scene, const MotionTable& table, const MotionCommand& command,
                    const ColumnChoice& columns) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  return "# asperity: " + provenanceLine(motionProvenance("motion", scene, table)) + "\n" +
         columns.select(motionCsv(table));
}

std::string jsonText(const Scene& scene, const MotionTable& table, const MotionCommand& command,
                     const ColumnChoice& columns) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".json"));
  const std::string text = motionJson(scene, table);
  if (columns.isAll()) return text;
  auto answer = nlohmann::ordered_json::parse(text);
  answer["points"] = columns.select(answer["points"]);
  return answer.dump(2) + "\n";
}

std::string summaryText(const MotionTable& table, const std::vector<std::string>& outputs) {
  std::string text =
      filled(Words::tr("%1 rows of each of %2 lines"),
             {std::to_string(table.lines.front().size()), std::to_string(table.lines.size())});
  if (table.lines.size() == 1)
    text = filled(Words::tr("%1 rows"), {std::to_string(table.lines.front().size())});
  if (std::isfinite(table.muError))
    text +=
        ", " + filled(Words::tr("estimated error of mu by elements and time steps %1 (%2 %)"),
                      {shortNumber(table.muError, 2), shortNumber(100 * table.relativeError, 2)});
  text += "\n";
  return text + wroteLines(outputs);
}

}  // namespace

int runMotion(const MotionCommand& command) {
  const Scene scene = loadScene(command.common);
  checkOutputs(command.outputs, kOutputExtensions, DefaultOutput::PrintsTable);
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputFiles(command.common, scene));
  checkUseful(command.picture, command.outputs);
  const PictureSettings settings = pictureSettings(command.picture, {1200, 1000, "print"});
  const ColumnChoice columns(command.columns, {"motion"});
  const MotionTable table = compute(scene, command);
  HeadlessPictures pictures(settings.backend);
  for (const std::string& output : command.outputs) {
    const std::string extension = fileExtension(output);
    if (extension == ".csv")
      writeFileAtomically(output, csvText(scene, table, command, columns));
    else if (extension == ".json")
      writeFileAtomically(output, jsonText(scene, table, command, columns));
    else if (output != "-")
      writePicture(output, scene, table, settings, command, pictures);
  }
  pictures.finish();
  const bool tableOnStdout = command.outputs.empty() || hasStandardOutput(command.outputs);
  if (command.common.json)
    fmt::print("{}", jsonText(scene, table, command, columns));
  else if (tableOnStdout)
    fmt::print("{}", csvText(scene, table, command, columns));
  if (!command.outputs.empty())
    printSummary(command.common.json || tableOnStdout, command.common.quiet,
                 summaryText(table, command.outputs));
  return kDone;
}

}  // namespace asperity
