#include "app/result_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/atomic_file.h"
#include "core/base/json_text.h"
#include "core/scene/provenance.h"
#include "core/surface/surface_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

using Form = std::function<std::string()>;

constexpr const char* kFolderPictures[]{".png", ".svg", ".pdf"};

/// The chart of a result, drawn for all pictures.
struct DrawnChart {
  Message title;
  DrawList list;
};

/// Draws the chart where an output is a picture.
std::optional<DrawnChart> drawChart(const TableCommand& command, const PictureSettings& settings,
                                    const TableResult& result) {
  if (std::ranges::all_of(command.outputs, isTableFile)) return std::nullopt;
  const DiagramSheet sheet = result.sheet();
  return DrawnChart{sheet.title, drawSheet(sheet, settings, result.minTextSize)};
}

void writePictures(const TableCommand& command, const PictureSettings& settings,
                   const TableResult& result, const DrawnChart& chart) {
  HeadlessPictures pictures(settings.backend);
  for (const std::string& output : command.outputs) {
    if (isTableFile(output)) continue;
    const ProvenanceOptions given(optionsFor(command.common.given, output));
    nlohmann::ordered_json origin = result.origin();
    origin["picture"] = settings.json();
    origin["picture"].update(result.picture);
    pictures.write(output, chart.list,
                   settings.properties(translated(chart.title), provenanceLine(origin)));
  }
  pictures.finish();
}

}  // namespace

std::string withColumns(const std::string& json, const ColumnChoice& columns) {
  if (columns.isAll()) return json;
  auto answer = jsonValue(json);
  answer["points"] = columns.select(answer["points"]);
  return jsonFile(answer);
}

PictureSettings checkTableOutputs(const TableCommand& command, const Scene& scene) {
  checkOutputs(command.outputs, kOutputExtensions, DefaultOutput::PrintsTable);
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputFiles(command.common, scene));
  checkUseful(command.picture, command.outputs);
  return pictureSettings(command.picture);
}

void writeResult(const TableCommand& command, const PictureSettings& settings,
                 const TableResult& result) {
  const CommonOptions& common = command.common;
  const std::vector<std::string>& outputs = command.outputs;
  const auto tableText = [&](const Form& form, const std::string& output) {
    const ProvenanceOptions given(optionsFor(common.given, output));
    return form();
  };
  const auto json = [&] {
    if (result.reading.empty()) return result.json();
    auto answer = jsonValue(result.json());
    addReadingFacts(answer, result.reading);
    return jsonFile(answer);
  };
  // A chart for which the picture has no room is refused before the first file is written.
  const std::optional<DrawnChart> chart = drawChart(command, settings, result);
  for (const OtherFile& other : result.otherFiles) other.write();
  for (const std::string& output : outputs) {
    const std::string extension = fileExtension(output);
    if (extension == ".csv") writeFileAtomically(output, tableText(result.csv, output));
    if (extension == ".json") writeFileAtomically(output, tableText(json, output));
  }
  if (chart) writePictures(command, settings, result, *chart);
  std::vector<std::string> files = outputs;
  for (const OtherFile& other : result.otherFiles) files.push_back(other.name);
  const bool printsTable = outputs.empty() || hasStandardOutput(outputs);
  if (common.json)
    fmt::print("{}", tableText(json, ".json"));
  else if (outputs.empty() && !result.printed.empty())
    fmt::print("{}", result.printed);
  else if (printsTable)
    fmt::print("{}", tableText(result.csv, ".csv"));
  // Without a file the table is all that is printed, beside what was assumed about the surface.
  const std::string reading = translatedLines(result.reading);
  printSummary(common, files.empty() ? reading : result.summary + reading + wroteLines(files),
               printsTable);
}

OutputFolder::OutputFolder(std::string folder, std::vector<std::filesystem::path> inputs,
                           const PictureSettings& settings)
    : folder_(std::move(folder)), inputs_(std::move(inputs)), settings_(settings) {
  checkFolder(folder_);
}

void OutputFolder::addText(const std::string& name, std::string bytes) {
  texts_.push_back({fileIn(folder_, name), std::move(bytes)});
}

void OutputFolder::write(const std::vector<GivenOption>& given,
                         const std::function<nlohmann::ordered_json()>& origin) const {
  makeFolder(folder_);
  for (const Text& text : texts_) checkName(text.file);
  for (const NamedSheet& sheet : sheets_)
    for (const char* extension : kFolderPictures)
      checkName(fileIn(folder_, sheet.name + extension));
  HeadlessPictures pictures(settings_.backend);
  for (const NamedSheet& sheet : sheets_) {
    const ProvenanceOptions options(optionsInFolder(given, sheet.name + kFolderPictures[0]));
    nlohmann::ordered_json made = origin();
    made["picture"] = settings_.json();
    const PictureProperties properties =
        settings_.properties(translated(sheet.sheet.title), provenanceLine(made));
    const DrawList picture = drawSheet(sheet.sheet, settings_);
    for (const char* extension : kFolderPictures)
      pictures.write(fileIn(folder_, sheet.name + extension), picture, properties);
  }
  pictures.finish();
  for (auto text = texts_.rbegin(); text != texts_.rend(); ++text)
    writeFileAtomically(text->file, text->bytes);
}

std::string OutputFolder::summary() const {
  std::string lines;
  for (const Text& text : texts_) lines += wroteLine(text.file);
  for (const NamedSheet& sheet : sheets_)
    lines += wroteLine(fileIn(folder_, sheet.name + ".png") + " (.svg, .pdf)");
  for (const std::string& name : others_)
    if (const std::string file = fileIn(folder_, name + ".png");
        std::ranges::find(sheets_, name, &NamedSheet::name) == sheets_.end() &&
        std::filesystem::exists(file))
      lines += filledLine(Words::tr("not of this run: %1, left by an earlier one"), file);
  return lines;
}

void OutputFolder::checkName(const std::string& name) const {
  checkWritable(name);
  checkNoInput(name, inputs_);
}

}  // namespace asperity
