// What libFuzzer calls: the reader that ASPERITY_READER names, with its input. The program contains
// the readers without what computes, in place of which two lists stand here.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include "core/friction/curve_file.h"
#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"
#include "tests/fuzz/readers.h"

namespace asperity {

std::vector<std::string_view> curveColumns() {
  return {"velocity", "mu", "contact_fraction", "indentation"};
}

std::span<const ShippedFile> shippedLessons() {
  return {};
}

}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const asperity::ReaderUnderTest* const reader = [] {
    const char* name = std::getenv("ASPERITY_READER");
    const asperity::ReaderUnderTest* found = asperity::findReader(name ? name : "");
    if (!found) {
      std::fprintf(stderr, "ASPERITY_READER names no reader of tests/fuzz/readers.cpp\n");
      std::exit(2);
    }
    return found;
  }();
  reader->read({reinterpret_cast<const char*>(data), size});
  return 0;
}
