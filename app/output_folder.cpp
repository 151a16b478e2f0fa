#include "app/output_folder.h"

#include <utility>

#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/atomic_file.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

constexpr const char* kExtensions[]{".png", ".svg", ".pdf"};

}  // namespace

OutputFolder::OutputFolder(std::string folder, std::vector<std::filesystem::path> inputs,
                           const PictureSettings& settings)
    : folder_(std::move(folder)), inputs_(std::move(inputs)), settings_(settings) {}

void OutputFolder::addText(const std::string& name, std::string bytes) {
  texts_.push_back({filePath(name), std::move(bytes)});
}

void OutputFolder::addSheet(const std::string& name, DiagramSheet sheet) {
  sheets_.push_back({name, std::move(sheet)});
}

void OutputFolder::write(const std::vector<GivenOption>& given,
                         const std::function<nlohmann::ordered_json()>& origin) const {
  makeFolder(folder_);
  for (const Text& text : texts_) checkName(text.file);
  for (const Sheet& sheet : sheets_)
    for (const char* extension : kExtensions) checkName(filePath(sheet.name + extension));
  HeadlessPictures pictures(settings_.backend);
  for (const Sheet& sheet : sheets_) {
    const ProvenanceOptions options(optionsInFolder(given, sheet.name + kExtensions[0]));
    nlohmann::ordered_json made = origin();
    made["picture"] = settings_.json();
    const PictureProperties properties =
        settings_.properties(translated(sheet.sheet.title), provenanceLine(made));
    const DrawList picture = drawSheet(sheet.sheet, settings_);
    for (const char* extension : kExtensions)
      pictures.write(filePath(sheet.name + extension), picture, properties);
  }
  pictures.finish();
  for (auto text = texts_.rbegin(); text != texts_.rend(); ++text)
    writeFileAtomically(text->file, text->bytes);
}

std::string OutputFolder::summary() const {
  std::string lines;
  for (const Text& text : texts_) lines += wroteLine(text.file);
  for (const Sheet& sheet : sheets_)
    lines += wroteLine(filePath(sheet.name + ".png") + " (.svg, .pdf)");
  return lines;
}

std::string OutputFolder::filePath(const std::string& name) const {
  return (std::filesystem::path(folder_) / name).string();
}

void OutputFolder::checkName(const std::string& name) const {
  checkWritable(name);
  checkNoInput(name, inputs_);
}

}  // namespace asperity
