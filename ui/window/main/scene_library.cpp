#include "ui/window/main/scene_library.h"

#include <QDir>
#include <QFile>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/scene/scene_file.h"

// This function is outside of the namespace, as the resource compiler's function is.
static void openResources() {
  Q_INIT_RESOURCE(asperity_scenes);
}

namespace asperity {

namespace {

const QString kFolder = QStringLiteral(":/asperity/scenes");

/// Returns the rank of a chapter; unknown ones come last.
std::size_t chapterRank(const std::string& chapter) {
  static const std::string_view order[] = {"The basics",       "The four regions of friction",
                                           "Roughness",        "Materials and temperature",
                                           "Motions",          "Limits and checks",
                                           "Everyday surfaces"};
  return static_cast<std::size_t>(std::ranges::find(order, chapter) - std::begin(order));
}

std::vector<LibraryScene> readLibrary() {
  openResources();
  std::vector<LibraryScene> scenes;
  const QDir folder(kFolder);
  for (const QFileInfo& entry : folder.entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
    QFile file(entry.filePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    try {
      scenes.push_back({entry.completeBaseName(),
                        readScene(file.readAll().toStdString(), entry.fileName().toStdString())});
    } catch (const InputError& error) {
      qWarning("%s", error.what());
    }
  }
  std::ranges::stable_sort(scenes, {}, [](const LibraryScene& entry) {
    return std::pair(chapterRank(entry.scene.chapter), entry.scene.chapter);
  });
  return scenes;
}

/// Returns the file of a shipped scene; none where no scene has this name.
std::optional<std::string> libraryFile(const std::string& name) {
  openResources();
  const std::string extension = name.ends_with(".json") ? "" : ".json";
  QFile file(kFolder + "/" + QString::fromStdString(name + extension));
  if (name.empty() || name.find('/') != std::string::npos || !file.open(QIODevice::ReadOnly))
    return std::nullopt;
  return file.readAll().toStdString();
}

/// Returns the shipped scene whose name a mistyped one is nearest to; empty where none is near.
std::string nearestName(const std::string& name) {
  std::vector<std::string> names;
  for (const LibraryScene& entry : libraryScenes()) names.push_back(entry.name.toStdString());
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view end = name.ends_with(".json") ? ".json" : "";
  return std::string(
      nearestWord(std::string_view(name).substr(0, name.size() - end.size()), known));
}

}  // namespace

Scene readNamedScene(const std::string& name, const std::filesystem::path& folder,
                     const std::vector<std::string>& assignments) {
  const std::filesystem::path file = folder / name;
  std::error_code ignored;
  if (folder == kShippedFolder || !std::filesystem::exists(file, ignored)) {
    if (const auto shipped = libraryFile(name)) return readScene(*shipped, name, {}, assignments);
    if (const std::string nearest = nearestName(name); !nearest.empty())
      throw InputError(file.string(), "",
                       message("there is no such file; the nearest shipped scene is {}", nearest));
  }
  return readSceneFile(file, assignments);
}

const std::vector<LibraryScene>& libraryScenes() {
  static const std::vector<LibraryScene> scenes = readLibrary();
  return scenes;
}

const LibraryScene* findLibraryScene(const QString& name) {
  const std::vector<LibraryScene>& scenes = libraryScenes();
  const auto found = std::ranges::find(scenes, name, &LibraryScene::name);
  return found == scenes.end() ? nullptr : &*found;
}

}  // namespace asperity
