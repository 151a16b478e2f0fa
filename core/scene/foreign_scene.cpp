#include "core/scene/foreign_scene.h"

#include <algorithm>
#include <system_error>

namespace asperity {
namespace {

namespace fs = std::filesystem;

// Measured in the window, with a rough line under force; good to a factor of two or so.
constexpr double kBytesPerNode = 150;     // line, its blocks, the march and its frames
constexpr double kSecondsPerNode = 1e-9;  // of one pass over a line, and a velocity takes six
constexpr double kPasses = 6, kPassesOfLine = 40;
constexpr double kBytesPerRow = 8;  // of a profile's file, at least

/// Links are followed. A name with a zero byte means one file to us and another to the system.
bool liesBelow(const fs::path& file, const fs::path& folder) {
  if (file.native().find('\0') != std::string::npos) return false;
  std::error_code noFile, noFolder;
  const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, noFolder);
  const fs::path place = fs::weakly_canonical(file, noFile).lexically_relative(home);
  return !noFile && !noFolder && !place.empty() && *place.begin() != "..";
}

double nodesOf(const Scene& scene, const fs::path& file) {
  double elements = static_cast<double>(scene.surface.elements);
  if (elements == 0) {  // as many as the profile has
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error) elements = static_cast<double>(size) / kBytesPerRow;
  }
  return elements * static_cast<double>(std::max<std::int64_t>(pointsPerElement(scene), 1));
}

}  // namespace

SceneDemands demandsOf(const Scene& scene) {
  SceneDemands demands;
  const fs::path file =
      scene.surface.kind == SurfaceKind::Profile ? scene.folder / scene.surface.file : fs::path();
  if (!file.empty() && !liesBelow(file, scene.folder)) demands.file = file;
  const double nodes = nodesOf(scene, file);
  const double lines = scene.surface.kind == SurfaceKind::SelfAffine
                           ? static_cast<double>(scene.ensemble.realizations)
                           : 1;
  const double passes = kPassesOfLine + kPasses * static_cast<double>(scene.sweep.points);
  const double memory = nodes * kBytesPerNode, seconds = nodes * lines * passes * kSecondsPerNode;
  if (memory > kMemoryUnasked) demands.memory = memory;
  if (seconds > kSecondsUnasked) demands.seconds = seconds;
  return demands;
}

}  // namespace asperity
