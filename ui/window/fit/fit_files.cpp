#include "ui/window/fit/fit_files.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/png_file.h"
#include "ui/language/translated.h"
#include "ui/window/main/picture_files.h"

namespace asperity {

namespace {

// The size, theme and scale that the command has by default.
constexpr int kWidth = 1200, kHeight = 900;

void checkNoInput(const std::filesystem::path& file, const Scene& scene) {
  std::error_code ignored;  // a missing file counts as an empty one
  for (const std::filesystem::path& input : filesReadBy(scene))
    if (std::filesystem::equivalent(file, input, ignored))
      throw InputError(file.string(), "", "is what is read, and would be replaced");
}

/// The options of the command for a file of this name.
nlohmann::ordered_json optionsOf(const FittedCurve& fitted, const std::string& name,
                                 const nlohmann::ordered_json& language = {}) {
  nlohmann::ordered_json options = fitOptions(fitted.varied, fitted.hasProfiles);
  if (!language.is_null()) options["language"] = language;
  options["file"] = name;
  return options;
}

/// The provenance of a picture, as the command writes it.
std::string originOf(const FittedCurve& fitted, const std::string& name) {
  nlohmann::ordered_json picture = {
      {"size", std::to_string(kWidth) + "x" + std::to_string(kHeight)},
      {"scale", 1.0F},
      {"theme", "print"},
      {"transparent", false}};
  addLanguage(picture);
  const ProvenanceOptions options(
      optionsOf(fitted, name, picture.value("language", nlohmann::ordered_json())));
  nlohmann::ordered_json origin = fitProvenance(fitted.start, fitted.fit);
  origin["picture"] = std::move(picture);
  return provenanceLine(origin);
}

}  // namespace

QStringList writeFitReport(const std::string& folder, const FittedCurve& fitted) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InputError(folder, "", "is not a folder and cannot be made one");
  const FitReport report = [&] {
    const ProvenanceOptions options(optionsOf(fitted, "fit"));
    return fitReport(fitted, folder);
  }();

  // All names are checked before the first file is written.
  const std::filesystem::path within(folder);
  std::vector<std::string> names;
  for (const NamedSheet& sheet : report.sheets)
    for (const char* extension : {".png", ".svg", ".pdf"}) names.push_back(sheet.name + extension);
  for (const auto& [name, bytes] : report.texts) names.push_back(name);
  for (const std::string& name : names) {
    checkWritable(within / name);
    checkNoInput(within / name, fitted.fit.scene);
  }
  DiagramOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.theme = printTheme();
  for (const NamedSheet& sheet : report.sheets) {
    const DrawList picture = composeDiagrams(sheet.sheet, options);
    const std::string origin = originOf(fitted, sheet.name);
    for (const char* extension : {".png", ".svg", ".pdf"})
      writePicture(within / (sheet.name + extension), picture,
                   {translated(sheet.sheet.title), origin, 1});
  }
  // The first text, which describes the others, is written last.
  for (auto text = report.texts.rbegin(); text != report.texts.rend(); ++text)
    writeFileAtomically(within / text->first, text->second);
  QStringList written;
  for (const std::string& name : names) written += QString::fromStdString(name);
  return written;
}

}  // namespace asperity
