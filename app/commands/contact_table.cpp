// asperity render -o FILE.csv|.json: the contact at one moment as a table.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/frame_source.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/run/contact_report.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

using MakeTable = DataTable (*)(const Frame& frame);
constexpr NamedChoices<MakeTable, 4> kContactTables{{{"shape", shapeTable},
                                                     {"contacts", contactsTable},
                                                     {"gaps", gapsTable},
                                                     {"power", powerTable}}};

std::string tableName(const RenderCommand& command) {
  return command.table.empty() ? "shape" : command.table;
}

/// Returns what the points of the frame do not resolve of the numbers in this table.
std::optional<Message> coarsenessNote(const Frame& frame, const std::string& table) {
  const bool hasPower = table == "shape" || table == "power";
  const std::optional<Message> ofLoads = coarsePointsNote(frame);
  return ofLoads || !hasPower ? ofLoads : coarsePowerNote(frame);
}

/// Throws for options of pictures and films.
void checkUsage(const RenderCommand& command) {
  checkUseful(command.picture, {command.output});
  const auto refuse = [](const char* option) {
    throw InputError("", option, "belongs to pictures, and the output is a table");
  };
  if (command.layout != "contact") refuse("--layout");
  if (!command.overlay.empty()) refuse("--overlay");
  if (const char* option = command.view.firstOption()) refuse(option);
  if (const char* option = command.curves.firstOption()) refuse(option);
  const TimeArguments& time = command.time;
  refuseGiven({{"--frames", time.frames > 0},
               {"--fps", time.framesPerSecond > 0},
               {"--duration", time.duration > 0},
               {"--cycles", time.cycles > 0},
               {"--slow-motion", time.slowMotion > 0},
               {"--resume", command.resume}},
              "belongs to films; a table is of one moment, see --at");
}

Json tableAnswer(const Scene& scene, const RenderCommand& command, const Frame& frame,
                 const DataTable& table, const ColumnChoice& columns,
                 const std::vector<Message>& reading, const std::optional<Message>& warning) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".json"));
  Json answer = lineProvenance("render", scene);
  addReadingFacts(answer, reading);
  answer["table"] = tableName(command);
  answer["time"] = frame.time;
  answer["derived"] = derivedNumbers(frame);
  if (warning) answer["warning"] = warning->english();
  answer["rows"] = columns.select(tableJson(table));
  return answer;
}

std::string csvText(const Scene& scene, const RenderCommand& command, const DataTable& table,
                    const ColumnChoice& columns) {
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  return provenanceComment("render", scene) + columns.select(tableCsv(table));
}

}  // namespace

int runContactTable(const RenderCommand& command) {
  const Scene scene = loadScene(command.common);
  checkUsage(command);
  const std::string name = tableName(command);
  const MakeTable makeTable = chosen(kContactTables, name, "--table");
  const ColumnChoice columns(command.columns, {name});
  if (command.output != "-") {
    checkOutputs({command.output}, {".csv", ".json"});
    checkNoInput(command.output, inputFiles(command.common, scene));
  }
  const Frame frame = withSceneContext(command.common, [&] {
    return FrameSource(scene, command.time, true, fieldsForTables(), 0).frame(0);
  });
  const DataTable table = makeTable(frame);
  const bool isCsv = fileExtension(command.output) != ".json";
  const std::vector<Message> reading = readingFacts(scene);
  const std::optional<Message> warning = coarsenessNote(frame, name);
  const std::string json =
      isCsv && !command.common.json
          ? std::string()
          : jsonFile(tableAnswer(scene, command, frame, table, columns, reading, warning));
  if (command.output != "-")
    writeFileAtomically(command.output, isCsv ? csvText(scene, command, table, columns) : json);
  else if (!command.common.json)
    fmt::print("{}", csvText(scene, command, table, columns));
  if (command.common.json) fmt::print("{}", json);
  const std::string lines = translatedLines(reading) + translatedLine(warning);
  const bool isPrinted = command.output == "-";
  printSummary(command.common,
               isPrinted ? lines
                         : filledLine(Words::tr("%1 rows"), table.rows.size()) + lines +
                               wroteLine(command.output),
               isPrinted);
  return kDone;
}

}  // namespace asperity
