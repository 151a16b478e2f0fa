// asperity material: from a table of measured moduli, or a ready Prony series, to a material that
// scenes can name; or, for a scene, the frequencies at which its rubber is used.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/command_line.h"
#include "app/command_options.h"
#include "app/material_values.h"
#include "app/output.h"
#include "app/output_folder.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/chart/material_sheets.h"
#include "core/material/dma_strain.h"
#include "core/material/material_model.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/material_tables.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/png_file.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{64} << 20;  // bytes of measurements
constexpr PictureDefaults kPictures{1200, 800, "print"};

constexpr NamedChoices<std::optional<ShiftKind>, 4> kShifts{{{"auto", std::nullopt},
                                                             {"wlf", ShiftKind::Wlf},
                                                             {"arrhenius", ShiftKind::Arrhenius},
                                                             {"table", ShiftKind::Table}}};
constexpr NamedChoices<ModulusKind, 3> kModuli{{{"auto", ModulusKind::Unknown},
                                                {"shear", ModulusKind::Shear},
                                                {"tension", ModulusKind::Tension}}};

void checkUnit(bool isKnown, const std::string& unit, const char* option,
               const std::string& allowed) {
  if (!unit.empty() && !isKnown)
    throw InputError("", option, message("'{}' is not one of {}", shortened(unit), allowed));
}

MaterialChoices materialChoices(const MaterialCommand& command) {
  MaterialChoices choices;
  choices.columns = command.columns;
  choices.columns.modulus = chosenFrom(kModuli, command.modulus, "--modulus");
  choices.columns.poissonRatio = command.poissonRatio;
  checkUnit(frequencyUnit(command.columns.frequencyUnit, false).has_value(),
            command.columns.frequencyUnit, "--frequency-unit", "rad/s, " + unitNames("Hz"));
  checkUnit(temperatureUnit(command.columns.temperatureUnit).has_value(),
            command.columns.temperatureUnit, "--temperature-unit", unitNames("K"));
  checkUnit(unitSize(command.columns.modulusUnit, "Pa").has_value(), command.columns.modulusUnit,
            "--modulus-unit", unitNames("Pa"));
  if (!command.temperature.empty())
    choices.columns.temperature = kelvinsFrom(command.temperature, "--temperature");
  if (!command.referenceTemperature.empty())
    choices.referenceTemperature =
        kelvinsFrom(command.referenceTemperature, "--reference-temperature");
  if (!command.strain.empty()) {
    choices.strainAmplitude = parseStrain(command.strain);
    if (!choices.strainAmplitude)
      throw InputError("", "--strain",
                       message("'{}' is not a strain such as 1%", shortened(command.strain)));
  }
  for (const std::string& text : command.leftOut)
    choices.leftOut.push_back(kelvinsFrom(text, "--leave-out"));
  choices.temperatureTolerance = command.temperatureTolerance;
  choices.isVertical = command.isVertical;
  choices.series.terms = command.terms;
  choices.series.isLiquid = command.isLiquid;
  if (!command.equilibriumModulus.empty())
    choices.series.equilibriumModulus =
        pascalsFrom(command.equilibriumModulus, "--equilibrium-modulus");
  if (!command.instantaneousModulus.empty())
    choices.instantaneousModulus =
        pascalsFrom(command.instantaneousModulus, "--instantaneous-modulus");
  choices.shift = chosenFrom(kShifts, command.shift, "--shift");
  choices.name = command.name;
  choices.source = command.source;
  choices.options = command.written;
  return choices;
}

/// Returns whether the file is a scene, or the name of a shipped one.
bool isScene(const std::string& file) {
  if (file.ends_with(".json") && !fs::exists(file)) return true;
  const RegularFile opened{fs::path(file)};
  const std::string begin = opened.read(0, 4096);
  const std::size_t first = begin.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != begin.npos && begin[first] == '{';
}

ColumnChoice columnChoice(const MaterialCommand& command) {
  return {command.tableColumns, {"material"}};
}

void refuseSceneOptions(const MaterialCommand& command) {
  if (!command.common.assignments.empty())
    throw InputError("", "--set", "sets keys of a scene, and this file is a table of moduli");
}

int makeFromMeasurements(const MaterialCommand& command, const PictureSettings& style) {
  refuseSceneOptions(command);
  const MaterialChoices choices = materialChoices(command);
  const std::string& file = command.common.scene;
  const Material material = makeMaterial(readRegularFile(file, kLargestFile), file, choices);
  const std::string json = materialJson(material);
  const ColumnChoice columns = columnChoice(command);
  OutputFolder output(command.output, {command.common.scene}, style);
  const auto origin = [&material] {
    nlohmann::ordered_json made = materialOrigin(material);
    addOptions(made);
    return made;
  };
  const auto addTable = [&](const char* name, const std::string& csv) {
    const ProvenanceOptions given(optionsInFolder(command.common.given, name));
    output.addText(name,
                   columns.selectAvailable("# asperity: " + provenanceLine(origin()) + "\n" + csv));
  };
  output.addText("material.json", json);
  addTable("prony.csv", pronyCsv(material));
  if (material.isMeasured()) {
    addTable("isotherms.csv", isothermsCsv(material));
    addTable("shifts.csv", shiftsCsv(material));
  }
  for (NamedSheet& sheet : materialSheets(material))
    output.addSheet(sheet.name, std::move(sheet.sheet));
  output.write(command.common.given, origin);
  std::string text = material.name + "\n";
  for (const Message& line : materialSummary(material)) text += "  " + translated(line) + "\n";
  printSummary(command.common.json, command.common.hidesSummary(), text + output.summary());
  if (command.common.json) fmt::print("{}", json);
  return kDone;
}

int showInScene(const MaterialCommand& command, const PictureSettings& style) {
  const char* option = !command.name.empty()      ? "--name"
                       : !command.source.empty()  ? "--source"
                       : !command.written.empty() ? command.written.front().first.c_str()
                                                  : nullptr;
  if (option) throw InputError("", option, "is of a table of moduli, and this file is a scene");
  const Scene scene = loadScene(command.common);
  return withSceneContext(command.common, [&] {
    const Excitation excitation = computeExcitation(scene);
    OutputFolder output(command.output, inputFiles(command.common, scene), style);
    {
      const ProvenanceOptions given(optionsInFolder(command.common.given, "excitation.csv"));
      output.addText("excitation.csv",
                     columnChoice(command).selectAvailable(provenanceComment("material", scene) +
                                                           excitationCsv(scene, excitation)));
    }
    output.addSheet("excitation", excitationSheet(scene, excitation));
    output.write(command.common.given, [&] { return provenance("material", scene); });
    printSummary(command.common.json, command.common.hidesSummary(),
                 translated(describeExcitation(scene, excitation)) + "\n" + output.summary());
    if (command.common.json) {
      nlohmann::ordered_json answer = provenance("material", scene);
      answer["excitation"] = excitationJson(scene, excitation);
      fmt::print("{}\n", answer.dump(2));
    }
    return kDone;
  });
}

}  // namespace

int runMaterial(const MaterialCommand& command) {
  checkFolderName(command.output);
  const PictureSettings style = pictureSettings(command.picture, kPictures);
  columnChoice(command);
  return command.common.remade || isScene(command.common.scene)
             ? showInScene(command, style)
             : makeFromMeasurements(command, style);
}

}  // namespace asperity
