#include "tests/bench/line_store.h"

#include <map>
#include <utility>

#include "core/scene/scene_file.h"
#include "core/surface/line_source.h"

namespace asperity::bench {
namespace {

std::map<LineKey, PreparedProfile> preparedProfiles;
std::map<std::pair<std::int64_t, std::int64_t>, Line> nodeLines;

const Scene& figure2() {
  static const Scene scene = readSceneFile(ASPERITY_RESOURCES_DIR "/scenes/figure_2.json");
  return scene;
}

}  // namespace

Scene sceneOf(const LineKey& key) {
  Scene scene = figure2();
  scene.surface.elements = key.elements;
  scene.accuracy.scheme = key.scheme;
  scene.accuracy.oversampling = key.oversampling;
  return scene;
}

const PreparedProfile& preparedProfile(const LineKey& key) {
  auto found = preparedProfiles.find(key);
  if (found == preparedProfiles.end()) {
    const Line line = LineSource(sceneOf(key), key.oversampling).make(key.realization);
    found = preparedProfiles.emplace(key, prepareProfile(line, key.scheme)).first;
  }
  return found->second;
}

const Line& nodeLine(std::int64_t elements, std::int64_t realization) {
  const std::pair<std::int64_t, std::int64_t> key{elements, realization};
  auto found = nodeLines.find(key);
  if (found == nodeLines.end()) {
    const LineKey nodes{elements, Scheme::Nodal, 1, realization};
    found = nodeLines.emplace(key, LineSource(sceneOf(nodes), 1).make(realization)).first;
  }
  return found->second;
}

void clearLines() {
  preparedProfiles.clear();
  nodeLines.clear();
}

}  // namespace asperity::bench
