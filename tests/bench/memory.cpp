#include "tests/bench/memory.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/friction/ensemble.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"

namespace asperity::bench {
namespace {

/// VmHWM counts this program alone; the usage of a child also counts its parent's before exec.
double largestResidentBytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("VmHWM:")) return 1024 * std::stod(line.substr(6));
  return 0;
}

}  // namespace

int runMemoryChild(const std::string& resolution) {
  for (const Resolution& known : kResolutions) {
    if (known.name != resolution) continue;
    Scene scene = sceneOf({5000, known.scheme, known.oversampling});
    scene.ensemble.realizations = kRealizations;
    CurveOptions options;
    options.threads = 2;
    if (!frictionCurve(scene, options).isComplete) return 1;
    std::printf("%.0f\n", largestResidentBytes());
    return 0;
  }
  return 2;
}

std::optional<double> peakMemoryOf(const std::string& resolution) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "'" + self + "' --memory-child " + resolution;
  std::FILE* child = popen(command.c_str(), "r");
  if (child == nullptr) return std::nullopt;
  double bytes = 0;
  const bool isRead = std::fscanf(child, "%lf", &bytes) == 1;
  return pclose(child) == 0 && isRead ? std::optional(bytes) : std::nullopt;
}

}  // namespace asperity::bench
