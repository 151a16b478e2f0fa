#include "ui/draw/picture_file.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/text_number.h"
#include "core/scene/provenance.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/language.h"

namespace asperity {

void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties) {
  const std::string extension = lowerCase(file.extension().string());
  if (extension == ".png") {
    checkWritable(file);
    writePng(file, renderImage(contextOfThread(), picture), properties);
  } else if (extension == ".svg") {
    writeSvg(file, picture, properties);
  } else if (extension == ".pdf") {
    writePdf(file, picture, properties);
  } else {
    throw unknownExtension(file.string(), file.extension().string(), {".png", ".svg", ".pdf"});
  }
}

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
