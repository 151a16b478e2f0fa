#include "ui/draw/picture_file.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/text_number.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "ui/draw/fonts.h"
#include "ui/language/language.h"

namespace asperity {

namespace {

bool isTiff(const std::string& extension) {
  return extension == ".tif" || extension == ".tiff";
}

}  // namespace

void checkPictureTool(const std::filesystem::path& file) {
  const std::string extension = lowerCase(file.extension().string());
  if (extension == ".eps" && !canWriteEps())
    throw InputError(file.string(), "",
                     "EPS is made by pdftops, which is not installed (package poppler-utils); .pdf "
                     "needs no other program");
  if (isTiff(extension) && !canWriteTiff())
    throw InputError(file.string(), "",
                     "this program was built without libtiff, which writes TIFF; .png needs no "
                     "other library");
}

void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties, PixelContext& context) {
  const std::string extension = lowerCase(file.extension().string());
  checkPictureTool(file);
  if (extension == ".png") {
    checkWritable(file);
    writePng(file, renderImage(context, picture), properties);
  } else if (isTiff(extension)) {
    writeFileAtomically(file, tiffBytes(renderImage(context, picture), properties));
  } else if (extension == ".svg") {
    writeFileAtomically(file, svgText(picture, properties));
  } else if (extension == ".pdf") {
    writeFileAtomically(file, pdfBytes(picture, properties));
  } else if (extension == ".eps") {
    writeEps(file, picture, properties);
  } else {
    throw unknownExtension(file.string(), file.extension().string(), kPictureExtensions);
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
  nlohmann::ordered_json origin = lineProvenance(verb, scene);
  nameLanguage(origin);
  return provenanceLine(origin);
}

}  // namespace asperity
