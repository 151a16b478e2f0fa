// Batch files: an entry is a scene that reads back to the same, or has an error in one short line.
#include "app/batch_file.h"
#include "app/picture_composer.h"
#include "core/friction/ensemble.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/stand_ins.h"
#include "ui/window/main/scene_library.h"

// What the reader asks of the program's other parts, which random input must not reach: no file is
// read but the batch itself.
namespace asperity {

PictureLayout layoutFrom(const std::string& name, const char* key) {
  if (name != "contact" && name != "curve") throw InputError("", key, "is not known");
  return PictureLayout::Contact;
}

Scene readNamedScene(const std::string& name, const std::filesystem::path& folder,
                     const std::vector<std::string>& assignments) {
  return anyScene(name, folder, assignments);
}

bool isSheetName(const std::string& file) {
  return file == "contact_sheet.png";
}

}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view text) {
    for (const BatchItem& item : readBatch(text, "batch.json").items) {
      requireShortLine(item.error.english());
      if (!item.error.empty()) continue;
      const std::string first = writeScene(item.scene);
      require(writeScene(readScene(first, "scene")) == first);
    }
  });
}
