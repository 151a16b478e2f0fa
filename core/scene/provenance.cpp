#include "core/scene/provenance.h"

#include "core/scene/scene_file.h"

namespace asperity {

nlohmann::ordered_json provenance(const std::string& verb, const Scene& scene) {
  using Json = nlohmann::ordered_json;
  Json root;
  root["schema"] = "asperity-" + verb + "/1";
  root["verb"] = verb;
  root["version"] = ASPERITY_VERSION;
  root["seed"] = scene.surface.kind == SurfaceKind::SelfAffine ? Json(scene.surface.seed) : Json();
  root["scene"] = Json::parse(writeScene(scene));
  return root;
}

}  // namespace asperity
