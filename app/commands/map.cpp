// asperity map: friction over two parameters, as a picture with contour lines and as a table.
#include "app/command_line.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/base/input_error.h"
#include "core/chart/map_sheet.h"
#include "core/friction/parameter_map.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

ParameterMap compute(const Scene& scene, const MapCommand& command) {
  const ParameterRange xRange = parseRangeOption("--x", command.x);
  const ParameterRange yRange = parseRangeOption("--y", command.y);
  const MapAxis x = mapAxis(scene, xRange, &yRange), y = mapAxis(scene, yRange, &xRange);
  ProgressBar bar(Words::tr("states"), command.common.quiet);
  const auto cells = static_cast<double>(x.values.size() * y.values.size());
  StateOptions options{.threads = command.common.threads};
  options.progress = [&](double part) {
    bar.show(static_cast<std::int64_t>(part * cells), static_cast<std::int64_t>(cells));
  };
  return parameterMap(scene, x, y, options);
}

std::string summaryText(const ParameterMap& map) {
  std::string text = filledLine(Words::tr("%1 times %2 states, %3 of them different"),
                                map.x.values.size(), map.y.values.size(), map.computed);
  for (const bool alongX : {true, false})
    if (isWithoutEffect(map, alongX))
      text += filledLine(Words::tr("friction does not depend on %1 in this scene"),
                         std::string((alongX ? map.x : map.y).key()));
  return text;
}

/// Returns by which width a nominal pressure became a force; nothing in a map over the width.
std::string pressureText(const ParameterMap& map) {
  constexpr std::string_view kWidth = "load.width";
  if (map.x.key() == kWidth || map.y.key() == kWidth) return {};
  return translatedLine(pressureNote(map.points, map.scene.load.width));
}

}  // namespace

int runMap(const MapCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity map"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  if (!isMapQuantity(command.quantity))
    throw InputError("", "--show", notOneOf(command.quantity, mapQuantities()));
  const ColumnChoice columns(command.columns, {"map"});
  const ParameterMap map =
      withSceneContext(command.common, [&] { return compute(scene, command); });
  const std::string& quantity = command.quantity;
  writeResult(command, settings,
              {.csv =
                   [&] {
                     return provenanceComment(mapProvenance(map, quantity)) +
                            columns.select(mapCsv(map, quantity));
                   },
               .json = [&] { return withColumns(mapJson(map, quantity), columns); },
               .sheet = [&] { return mapSheet(map, quantity); },
               .origin = [&] { return mapProvenance(map, quantity); },
               .summary = summaryText(map) + pressureText(map),
               .reading = readingFacts(scene)});
  return kDone;
}

}  // namespace asperity
