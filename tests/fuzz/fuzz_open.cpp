// Whatever file is opened for the scene in it: what is found reads back to the same.
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view bytes) {
    const std::string first = writeScene(findScene(bytes, "file").scene);
    require(writeScene(readScene(first, "scene")) == first);
  });
}
