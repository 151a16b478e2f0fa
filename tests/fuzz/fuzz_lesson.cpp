// Lessons: what is read is written as a text that reads back to the same lesson.
#include <span>

#include "core/lesson/lesson_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/stand_ins.h"

namespace asperity {

std::span<const ShippedLesson> shippedLessons() {
  return {};
}

}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [&](std::string_view text) {
    const Lesson lesson = readLesson(text, "lesson.json", "/nowhere", anyScene);
    require(!lesson.steps.empty());
    const std::string first = writeLesson(lesson);
    require(writeLesson(readLesson(first, "lesson.json", "/nowhere", anyScene)) == first);
  });
}
