// Every reader of a file or text from outside, under any input: the text is either read or refused
// with an InputError of one short line, and what is read keeps the reader's promises. Anything
// else, as another exception, a finding of a sanitizer or an endless run, is a fault.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

namespace asperity {

/// A promise that a reader did not keep.
class BrokenPromise : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ReaderUnderTest {
  std::string_view name;  // also that of its folder in corpus/
  /// Reads the bytes. Throws BrokenPromise, or whatever a faulty reader throws.
  void (*read)(std::string_view bytes);
};

std::span<const ReaderUnderTest> readersUnderTest();

/// Returns the reader of this name, or null.
const ReaderUnderTest* findReader(std::string_view name);

}  // namespace asperity
