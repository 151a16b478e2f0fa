// Lessons: what is read is written as a text that reads back to the same lesson.
#include <vector>

#include "core/friction/curve_file.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {

// The columns of a friction curve, without what computes it.
std::vector<std::string_view> curveColumns() {
  return {"velocity", "mu", "contact_fraction", "indentation"};
}

std::span<const ShippedLesson> shippedLessons() {
  return {};
}

}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  // No file is read but the lesson itself.
  const auto anyScene = [](const std::string&, const std::filesystem::path& folder,
                           const std::vector<std::string>& assignments) {
    return readScene("{}", "scene", folder, assignments);
  };
  return readOrRefuse(data, size, [&](std::string_view text) {
    const Lesson lesson = readLesson(text, "lesson.json", "/nowhere", anyScene);
    require(!lesson.steps.empty());
    const std::string first = writeLesson(lesson);
    require(writeLesson(readLesson(first, "lesson.json", "/nowhere", anyScene)) == first);
  });
}
