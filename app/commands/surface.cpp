// asperity surface: the rigid line of a scene, its spectrum and its statistics.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "app/result_files.h"
#include "core/base/atomic_file.h"
#include "core/base/named_choices.h"
#include "core/base/text.h"
#include "core/measured/measured_file.h"
#include "core/run/line_diagrams.h"
#include "core/run/measured_sheet.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

std::string summaryText(const Line& line, const std::vector<std::string>& outputs) {
  const auto meters = [](double value) { return answerQuantity(value, "m", 6); };
  std::string text = filledLine(Words::tr("length %1, %2 points, rms height %3, rms slope %4"),
                                meters(line.length), line.nodes(), meters(line.rmsHeight),
                                answerNumber(line.rmsSlope, 6));
  return text + wroteLines(outputs);
}

std::string valueText(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "\u2013";
  return unit.empty() ? answerNumber(value, 4) : answerQuantity(value, unit);
}

/// Returns the interpretation of the file, and the values before and after processing.
std::string measuredText(const MeasuredSummary& summary) {
  std::string text = translatedLines(factsOf(summary));
  // fmt counts letters, not bytes.
  const auto cell = [](const std::string& word) { return fmt::format("{:<13} ", word); };
  text += cell("") + cell(Words::tr("raw")) + Words::tr("used") + "\n";
  for (const NamedValue& value : namedValues(summary))
    text += cell(value.name) + cell(valueText(value.raw, value.unit)) +
            valueText(value.used, value.unit) + "\n";
  return text;
}

/// What the command writes of: the first line of a scene, and the summary of a measured surface.
struct LineOfScene {
  const Scene& scene;
  LineSource source;
  Line line;
  std::optional<MeasuredSummary> measured{};

  const MeasuredSummary* summary() const { return measured ? &*measured : nullptr; }
};

DiagramSheet lineSheet(const LineOfScene& made) {
  const Scene& scene = made.scene;
  if (!made.measured) return surfaceSheet(scene, made.line);
  const std::string title =
      scene.title.empty() ? printable(std::filesystem::path(scene.surface.file).filename().string())
                          : scene.title;
  return measuredSheet(*made.measured, title);
}

/// Returns the settings of the picture, which is higher for a measured surface: it has one more
/// diagram.
PictureSettings surfaceSettings(const SurfaceCommand& command, bool isMeasured) {
  PictureDefaults defaults = command.picture.defaults;
  if (isMeasured) defaults.height = 1100;
  return pictureSettings(command.picture, defaults);
}

void writePicture(const std::string& output, const SurfaceCommand& command,
                  const LineOfScene& made) {
  const PictureSettings settings = surfaceSettings(command, made.measured.has_value());
  HeadlessPictures pictures(settings.backend);
  pictures.write(
      output, drawSheet(lineSheet(made), settings),
      settings.properties(translated(made.scene.title), pictureOrigin("surface", made.scene)));
  pictures.finish();
}

enum class SurfaceTable { Line, Spectrum, Statistics };
constexpr NamedChoices<SurfaceTable, 3> kSurfaceTables{{{"line", SurfaceTable::Line},
                                                        {"spectrum", SurfaceTable::Spectrum},
                                                        {"statistics", SurfaceTable::Statistics}}};

SurfaceTable chosenTable(const SurfaceCommand& command) {
  return chosen(kSurfaceTables, command.table, "--table");
}

/// Throws InputError for a column that the chosen table does not have.
ColumnChoice columnChoice(const SurfaceCommand& command) {
  const bool isLine = chosenTable(command) == SurfaceTable::Line;
  return {command.columns, {isLine ? "surface" : command.table}};
}

std::string csvText(SurfaceTable table, const LineOfScene& made) {
  if (table == SurfaceTable::Spectrum) return tableCsv(spectrumTable(made.source, made.summary()));
  if (table == SurfaceTable::Statistics)
    return tableCsv(statisticsTable(made.line, made.summary()));
  return lineCsv(made.line);
}

std::string jsonText(const LineOfScene& made) {
  return surfaceJson(made.scene, made.source, made.line, made.summary());
}

void writeSurface(const std::string& output, const SurfaceCommand& command,
                  const LineOfScene& made) {
  const ProvenanceOptions given(optionsFor(command.common.given, output));
  const std::string extension = fileExtension(output);
  if (extension == ".csv" || output == "-")
    writeTable(output, provenanceComment("surface", made.scene) +
                           columnChoice(command).select(csvText(chosenTable(command), made)));
  if (extension == ".json") writeFileAtomically(output, jsonText(made));
  if (isPictureFile(output)) writePicture(output, command, made);
}

/// Returns whether an output shows the spectra of a measured surface.
bool needsSpectra(const SurfaceCommand& command) {
  return command.common.json || std::ranges::any_of(command.outputs, [](const auto& output) {
           return isPictureFile(output) || fileExtension(output) == ".json";
         });
}

/// Throws for unknown options of tables, and for any of them where no output is a table.
void checkTable(const SurfaceCommand& command) {
  columnChoice(command);
  const bool hasTable = std::ranges::any_of(command.outputs, [](const std::string& output) {
    return output == "-" || fileExtension(output) == ".csv";
  });
  if (!hasTable)
    refuseGiven({{"--table", chosenTable(command) != SurfaceTable::Line},
                 {"--columns", !command.columns.empty()}},
                "belongs to .csv tables, and no output is one");
}

}  // namespace

int runSurface(const SurfaceCommand& command) {
  const bool isFile = !command.common.remade && isSurfaceFile(command.common.scene);
  const Scene scene = isFile ? surfaceFileScene(command.common.scene, command.common.assignments)
                             : loadScene(command.common);
  checkTableOutputs(command, scene);
  checkTable(command);
  const auto run = [&] {
    findLinesWithProgress(scene, command.common.quiet);
    LineOfScene made{scene, LineSource(scene, writtenPointsPerElement(scene, isFile)), {}};
    made.line = made.source.make(0);
    if (made.source.measured())
      made.measured = measuredSummary(
          scene, made.source,
          needsSpectra(command) ? SummarySpectra::Computed : SummarySpectra::Omitted);
    const std::string text = (made.measured ? measuredText(*made.measured)
                                            : translatedLines(made.source.spectrumFacts())) +
                             noteLines(lineNotes(made.source)) +
                             summaryText(made.line, command.outputs);
    for (const std::string& output : command.outputs)
      if (output != "-" || !command.common.json) writeSurface(output, command, made);
    printSummary(command.common, text, hasStandardOutput(command.outputs));
    if (command.common.json) {
      const ProvenanceOptions given(optionsFor(command.common.given, ".json"));
      fmt::print("{}", jsonText(made));
    }
  };
  withSceneContext(command.common, [&] {
    if (isFile)
      withSurfaceFile(command.common.scene, run);
    else
      run();
  });
  return kDone;
}

}  // namespace asperity
