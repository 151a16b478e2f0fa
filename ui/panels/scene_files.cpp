#include "ui/panels/scene_files.h"

#include "core/scene/scene_file.h"

namespace asperity {

std::string nameInScene(const Scene& scene, const std::filesystem::path& file) {
  if (scene.folder.empty()) return file.string();
  const auto folder = std::filesystem::absolute(scene.folder).lexically_normal();
  const auto name = std::filesystem::absolute(file).lexically_normal().lexically_relative(folder);
  const bool isBelow = !name.empty() && *name.begin() != "..";
  return isBelow ? name.string() : file.string();
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
