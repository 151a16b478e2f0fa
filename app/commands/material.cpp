// asperity material: from a table of measured moduli, or a ready Prony series, to a material that
// scenes can name; or, for a scene, the frequencies at which its rubber is used.
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/command_line.h"
#include "app/output.h"
#include "app/result_files.h"
#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/chart/material_sheets.h"
#include "core/material/material_model.h"
#include "core/material/material_options.h"
#include "core/material/material_summary.h"
#include "core/scene/data_table.h"
#include "core/scene/material_tables.h"
#include "core/scene/provenance.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Returns whether the file is a scene, or the name of a shipped one.
bool isScene(const std::string& file) {
  std::error_code ignored;
  if (file.ends_with(".json") && !fs::exists(file, ignored)) return true;
  const RegularFile opened{fs::path(file)};
  const std::string begin = opened.read(0, 4096);
  const std::size_t first = begin.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != begin.npos && begin[first] == '{';
}

ColumnChoice columnChoice(const MaterialCommand& command) {
  return {command.columns, {"material"}};
}

int makeFromMeasurements(const MaterialCommand& command, const PictureSettings& style) {
  if (!command.common.assignments.empty())
    throw InputError("", "--set", "sets keys of a scene, and this file is a table of moduli");
  OutputFolder output(command.output, {command.common.scene}, style);
  const Material material = readMaterial(command.common.scene, materialChoices(command.options));
  const std::string json = materialJson(material);
  const ColumnChoice columns = columnChoice(command);
  const auto origin = [&material] {
    nlohmann::ordered_json made = materialOrigin(material);
    addOptions(made);
    return made;
  };
  const auto addTable = [&](const char* name, const std::string& csv) {
    const ProvenanceOptions given(optionsInFolder(command.common.given, name));
    output.addText(name, columns.selectAvailable(provenanceComment(origin()) + csv));
  };
  output.addText("material.json", json);
  addTable("prony.csv", pronyCsv(material));
  if (material.isMeasured()) {
    addTable("isotherms.csv", isothermsCsv(material));
    addTable("shifts.csv", shiftsCsv(material));
  }
  for (NamedSheet& sheet : materialSheets(material)) output.addSheet(std::move(sheet));
  output.setOtherSheets({"isotherms", "shifts"});
  output.write(command.common.given, origin);
  std::string text = material.name + "\n";
  for (const Message& line : materialSummary(material)) text += "  " + translated(line) + "\n";
  printSummary(command.common, text + output.summary());
  if (command.common.json) fmt::print("{}", json);
  return kDone;
}

int showInScene(const MaterialCommand& command, const PictureSettings& style) {
  if (!command.options.empty())
    throw InputError("", command.options.front().first,
                     "applies only to tables of moduli, and this file is a scene");
  const Scene scene = loadScene(command.common);
  OutputFolder output(command.output, inputFiles(command.common, scene), style);
  return withSceneContext(command.common, [&] {
    const Excitation excitation = computeExcitation(scene);
    {
      const ProvenanceOptions given(optionsInFolder(command.common.given, "excitation.csv"));
      output.addText("excitation.csv",
                     columnChoice(command).selectAvailable(provenanceComment("material", scene) +
                                                           excitationCsv(scene, excitation)));
    }
    output.addSheet({"excitation", excitationSheet(scene, excitation)});
    output.write(command.common.given, [&] { return provenance("material", scene); });
    printSummary(command.common,
                 translated(describeExcitation(scene, excitation)) + "\n" + output.summary());
    if (command.common.json) {
      nlohmann::ordered_json answer = provenance("material", scene);
      answer["excitation"] = excitationJson(scene, excitation);
      printJson(answer);
    }
    return kDone;
  });
}

}  // namespace

int runMaterial(const MaterialCommand& command) {
  const PictureSettings style = pictureSettings(command.picture);
  columnChoice(command);
  return command.common.remade || isScene(command.common.scene)
             ? showInScene(command, style)
             : makeFromMeasurements(command, style);
}

}  // namespace asperity
