// In place of parts of the program that random input must not reach: the reader of a batch asks for
// the layout of a picture, for scenes by name and for names of contact sheets; no file is read.
#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/batch_file.h"
#include "app/pictures/picture_composer.h"
#include "core/base/input_error.h"
#include "core/scene/scene_file.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

PictureLayout layoutFrom(const std::string& name, const char* key) {
  if (name != "contact" && name != "curve") throw InputError("", key, "is not known");
  return PictureLayout::Contact;
}

Scene readNamedScene(const std::string&, const std::filesystem::path& folder,
                     const std::vector<std::string>& assignments) {
  return readScene("{}", "scene", folder, assignments);
}

bool isSheetName(const std::string& file) {
  return file == "contact_sheet.png";
}

}  // namespace asperity
