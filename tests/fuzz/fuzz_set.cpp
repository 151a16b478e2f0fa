// --set KEY=VALUE, one assignment a line, over an empty scene.
#include "core/scene/scene_file.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view text) {
    std::vector<std::string> assignments;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      assignments.emplace_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    const std::string first = writeScene(readScene("{}", "scene", {}, assignments));
    require(writeScene(readScene(first, "scene")) == first);
  });
}
