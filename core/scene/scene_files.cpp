#include "core/scene/scene_files.h"

#include <system_error>
#include <utility>

#include "core/material/material_library.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

/// Calls use(key, name) for the name of every file in the scene; an empty name is no file. A new
/// key that names a file belongs here: provenance, the protection of what is read, and moving a
/// scene to another folder follow from it.
template <class SceneType, class Use>
void forEachFile(SceneType& scene, const Use& use) {
  const auto useOne = [&use](const char* key, auto& name) {
    if (!name.empty()) use(key, name);
  };
  useOne("surface.file", scene.surface.file);
  useOne(kMaterialKey, scene.elastomer.material);
  for (auto& table : scene.comparison.data) useOne("comparison.data", table.file);
}

/// Returns the path of a file that the scene names; empty for a shipped material, which is no file.
std::filesystem::path pathOf(std::string_view key, const std::string& name,
                             const std::filesystem::path& folder) {
  return key == kMaterialKey ? materialFile(name, folder) : folder / name;
}

/// Gives every file that the scene reads another name.
template <class Rename>
Scene withRenamedFiles(Scene scene, const Rename& rename) {
  forEachFile(scene, [&](std::string_view key, std::string& name) {
    if (!pathOf(key, name, scene.folder).empty()) name = rename(name);
  });
  return scene;
}

/// Returns the absolute path with the links of its folders followed, so that ".." in a name leads
/// where the system goes. The file itself may be a link; nothing of the path need exist.
std::filesystem::path canonicalFolder(const std::filesystem::path& folder) {
  std::filesystem::path path = std::filesystem::current_path() / folder;  // empty: this one itself
  if (!path.has_filename()) path = path.parent_path();
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : canonical;
}

/// Returns the name of a file as seen from a folder.
std::filesystem::path nameFrom(const std::filesystem::path& folder,
                               const std::filesystem::path& file) {
  return (canonicalFolder(file.parent_path()) / file.filename())
      .lexically_proximate(canonicalFolder(folder));
}

/// Returns the name of the file relative to the folder if it lies there or below; else empty.
std::string nameBelow(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::filesystem::path name = nameFrom(folder, file);
  return name.is_absolute() || *name.begin() == ".." ? std::string() : name.string();
}

}  // namespace

std::vector<InputFile> namedFiles(const Scene& scene) {
  std::vector<InputFile> files;
  forEachFile(scene, [&](const char* key, const std::string& name) {
    files.push_back({key, name, {}});
  });
  return files;
}

std::vector<std::filesystem::path> filesReadBy(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  forEachFile(scene, [&](std::string_view key, const std::string& name) {
    std::filesystem::path path = pathOf(key, name, scene.folder);
    if (!path.empty()) files.push_back(std::move(path));
  });
  return files;
}

Scene withAbsoluteFiles(Scene scene) {
  return withRenamedFiles(scene, [&](const std::string& name) {
    return std::filesystem::absolute(scene.folder / name).lexically_normal().string();
  });
}

Scene withFilesRelativeTo(const std::filesystem::path& folder, Scene scene) {
  return withRenamedFiles(scene, [&](const std::string& name) {
    if (std::filesystem::path(name).is_absolute()) {
      const std::string below = nameBelow(folder, name);
      return below.empty() ? name : below;
    }
    return nameFrom(folder, scene.folder / name).string();
  });
}

std::string nameInScene(const Scene& scene, const std::filesystem::path& file) {
  if (scene.folder.empty()) return file.string();
  const std::string below = nameBelow(scene.folder, file);
  return below.empty() ? file.string() : below;
}

void useMaterial(Scene& scene, const std::string& name) {
  if (name.empty()) {
    scene.elastomer.material.clear();
    return;
  }
  // The scene reader sets the values in a new scene, so that no other value of the scene causes an
  // error.
  Scene carrier;
  carrier.elastomer.temperature = scene.elastomer.temperature;
  Elastomer next =
      readScene(writeScene(carrier), "", scene.folder, {"elastomer.material=" + name}).elastomer;
  next.temperature = scene.elastomer.temperature;
  // Values of other rheologies are kept, because the user may return to them.
  next.shearModulus = scene.elastomer.shearModulus;
  next.relaxationTime = scene.elastomer.relaxationTime;
  scene.elastomer = next;
}

void useSurface(Scene& scene, const std::filesystem::path& file) {
  const std::string name = nameInScene(scene, file);
  if (scene.surface.kind == SurfaceKind::Measured && scene.surface.file == name) return;
  const std::int64_t seed = scene.surface.seed;
  scene.surface = {};
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = name;
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.surface.seed = seed;
  scene.ensemble.realizations = 0;
}

}  // namespace asperity
