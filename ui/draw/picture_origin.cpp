#include "ui/draw/picture_origin.h"

#include "core/scene/provenance.h"
#include "ui/language/language.h"

namespace asperity {

void addLanguage(nlohmann::ordered_json& picture) {
  if (presentLanguage() != "en") picture["language"] = presentLanguage();
}

void nameLanguage(nlohmann::ordered_json& origin) {
  nlohmann::ordered_json picture;
  addLanguage(picture);
  if (!picture.is_null()) origin["picture"] = picture;
}

std::string pictureOrigin(const std::string& verb, const Scene& scene) {
  nlohmann::ordered_json origin = provenance(verb, scene);
  nameLanguage(origin);
  return provenanceLine(origin);
}

}  // namespace asperity
