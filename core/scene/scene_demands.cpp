#include "core/scene/scene_demands.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>

#include "core/material/material_library.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

// These were measured in the window, with a rough line under force; accurate to a factor of about
// two.
constexpr double kBytesPerNode = 150;     // line, its blocks, the march and its frames
constexpr double kSecondsPerNode = 1e-9;  // for one pass over a line; a velocity takes six
constexpr double kPasses = 6, kPassesOfLine = 40;
constexpr double kBytesPerRow = 8;  // minimum for a row of a profile's file

/// Returns whether the file is in or below the folder; links are followed. A name with a zero byte
/// would mean another file to the system.
bool liesBelow(const fs::path& file, const fs::path& folder) {
  if (file.native().find('\0') != std::string::npos) return false;
  std::error_code noFile, noFolder;
  const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, noFolder);
  const fs::path relative = fs::weakly_canonical(file, noFile).lexically_relative(home);
  return !noFile && !noFolder && !relative.empty() && *relative.begin() != "..";
}

double nodesOf(const Scene& scene, const fs::path& file) {
  double elements = static_cast<double>(scene.surface.elements);
  if (elements == 0) {  // the number comes from the profile
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error) elements = static_cast<double>(size) / kBytesPerRow;
  }
  return elements * static_cast<double>(std::max<std::int64_t>(pointsPerElement(scene), 1));
}

}  // namespace

SceneDemands sceneDemands(const Scene& scene) {
  SceneDemands demands;
  const fs::path file =
      hasSurfaceFile(scene.surface) ? scene.folder / scene.surface.file : fs::path();
  if (!file.empty() && !liesBelow(file, scene.folder)) demands.file = file;
  const std::string& material = scene.elastomer.material;
  const fs::path materials = material.empty() ? fs::path() : materialFile(material, scene.folder);
  if (demands.file.empty() && !materials.empty() && !liesBelow(materials, scene.folder))
    demands.file = materials;
  const double nodes = nodesOf(scene, file);
  const double lines =
      mayHaveManyLines(scene.surface)
          ? static_cast<double>(std::max<std::int64_t>(scene.ensemble.realizations, 1))
          : 1;
  const double passes = kPassesOfLine + kPasses * static_cast<double>(scene.sweep.points);
  const double memory = nodes * kBytesPerNode, seconds = nodes * lines * passes * kSecondsPerNode;
  if (memory > kMemoryUnasked) demands.memory = memory;
  if (seconds > kSecondsUnasked) demands.seconds = seconds;
  return demands;
}

}  // namespace asperity
