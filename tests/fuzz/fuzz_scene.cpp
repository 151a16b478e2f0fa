// The scene reader: what it takes, it writes as text that reads back to the same.
#include "core/scene/scene_file.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view text) {
    const std::string first = writeScene(readScene(text, "scene"));
    require(writeScene(readScene(first, "scene")) == first);
  });
}
