#include "ui/panels/scene_files.h"

#include "core/material/material_library.h"
#include "core/scene/scene_file.h"

namespace asperity {

namespace {

/// Gives every file that the scene reads another name; shipped materials are no files.
template <class Rename>
void renameFiles(Scene& scene, const Rename& rename) {
  const auto renameOne = [&rename](std::string& name) {
    if (!name.empty()) name = rename(name);
  };
  renameOne(scene.surface.file);
  std::string& material = scene.elastomer.material;
  if (!material.empty() && !materialFile(material, scene.folder).empty()) renameOne(material);
  for (DataFile& table : scene.comparison.data) renameOne(table.file);
}

/// Returns the name of the file relative to the folder if it lies there or below; else empty.
std::string nameBelow(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const auto name = std::filesystem::absolute(file).lexically_normal().lexically_relative(
      std::filesystem::absolute(folder).lexically_normal());
  return name.empty() || *name.begin() == ".." ? std::string() : name.string();
}

}  // namespace

Scene withAbsoluteFiles(Scene scene) {
  renameFiles(scene, [folder = scene.folder](const std::string& name) {
    return std::filesystem::absolute(folder / name).lexically_normal().string();
  });
  return scene;
}

Scene withFilesRelativeTo(const std::filesystem::path& folder, Scene scene) {
  const std::filesystem::path target = std::filesystem::absolute(folder).lexically_normal();
  renameFiles(scene, [&target, folder = scene.folder](const std::string& name) {
    if (std::filesystem::path(name).is_absolute()) {
      const std::string below = nameBelow(target, name);
      return below.empty() ? name : below;
    }
    return std::filesystem::absolute(folder / name)
        .lexically_normal()
        .lexically_proximate(target)
        .string();
  });
  return scene;
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
