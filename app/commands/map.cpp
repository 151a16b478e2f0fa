// asperity map: friction over two parameters, as a picture with contour lines and as a table.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/output.h"
#include "app/picture_options.h"
#include "app/pictures/headless_pictures.h"
#include "app/progress_bar.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/chart/map_sheet.h"
#include "core/friction/parameter_map.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "ui/chart/diagram_picture.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

const std::vector<std::string_view> kTables{"map"};

ParameterMap compute(const Scene& scene, const MapCommand& command) {
  const ParameterRange xRange = parseRangeOption("--x", command.x);
  const ParameterRange yRange = parseRangeOption("--y", command.y);
  const MapAxis x = mapAxis(scene, xRange, &yRange), y = mapAxis(scene, yRange, &xRange);
  ProgressBar bar(Words::tr("states"), command.common.quiet);
  const auto cells = static_cast<double>(x.values.size() * y.values.size());
  MapOptions options;
  options.threads = command.common.threads;
  options.progress = [&](double part) {
    bar.show(static_cast<std::int64_t>(part * cells), static_cast<std::int64_t>(cells));
  };
  return parameterMap(scene, x, y, options);
}

void writePicture(const std::string& output, const ParameterMap& map, const std::string& quantity,
                  const PictureSettings& settings, HeadlessPictures& pictures) {
  nlohmann::ordered_json origin = mapProvenance(map, quantity);
  origin["picture"] = settings.json();
  const DiagramSheet sheet = mapSheet(map, quantity);
  pictures.write(output, drawSheet(sheet, settings),
                 settings.properties(translated(sheet.title), provenanceLine(origin)));
}

/// Returns the table after a comment with its provenance.
std::string csvText(const ParameterMap& map, const MapCommand& command) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  return "# asperity: " + provenanceLine(mapProvenance(map, command.quantity)) + "\n" +
         ColumnChoice(command.columns, kTables).select(mapCsv(map, command.quantity));
}

std::string jsonText(const ParameterMap& map, const MapCommand& command) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".json"));
  const ColumnChoice columns(command.columns, kTables);
  if (columns.isAll()) return mapJson(map, command.quantity);
  auto answer = nlohmann::ordered_json::parse(mapJson(map, command.quantity));
  answer["points"] = columns.select(answer["points"]);
  return answer.dump(2) + "\n";
}

std::string summaryText(const ParameterMap& map, const std::vector<std::string>& outputs) {
  std::string text = filled(Words::tr("%1 times %2 states, %3 of them different"),
                            {std::to_string(map.x.values.size()),
                             std::to_string(map.y.values.size()), std::to_string(map.computed)}) +
                     "\n";
  for (const bool alongX : {true, false})
    if (isWithoutEffect(map, alongX))
      text += filled(Words::tr("friction does not depend on %1 in this scene"),
                     {std::string((alongX ? map.x : map.y).key())}) +
              "\n";
  return text + wroteLines(outputs);
}

}  // namespace

int runMap(const MapCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity map"); });
  checkOutputs(command.outputs, kOutputExtensions, DefaultOutput::PrintsTable);
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputFiles(command.common, scene));
  checkUseful(command.picture, command.outputs);
  if (!isMapQuantity(command.quantity))
    throw InputError("", "--show", notOneOf(command.quantity, mapQuantities()));
  const ColumnChoice checked(command.columns, kTables);
  const PictureSettings settings = pictureSettings(command.picture, {1200, 900, "print"});
  const ParameterMap map =
      withSceneContext(command.common, [&] { return compute(scene, command); });
  HeadlessPictures pictures(settings.backend);
  for (const std::string& output : command.outputs) {
    const std::string extension = fileExtension(output);
    if (extension == ".csv") {
      writeFileAtomically(output, csvText(map, command));
    } else if (extension == ".json") {
      writeFileAtomically(output, jsonText(map, command));
    } else if (output != "-") {
      const ProvenanceOptions given(optionsFor(command.common.given, output));
      writePicture(output, map, command.quantity, settings, pictures);
    }
  }
  pictures.finish();
  const bool tableOnStdout = command.outputs.empty() || hasStandardOutput(command.outputs);
  if (command.common.json)
    fmt::print("{}", jsonText(map, command));
  else if (tableOnStdout)
    fmt::print("{}", csvText(map, command));
  if (!command.outputs.empty())
    printSummary(command.common.json || tableOnStdout, command.common.quiet,
                 summaryText(map, command.outputs));
  return kDone;
}

}  // namespace asperity
