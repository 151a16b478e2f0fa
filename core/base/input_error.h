// The one error type for bad input: what a user gave and can mend. The command line prints it as
// one line and exits 2; the window shows it beside the control.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/printable_text.h"

namespace asperity {

class InputError : public std::runtime_error {
 public:
  /// file and key may be empty. message says what is wrong and what is allowed. Each may hold what
  /// a user wrote as it is: it is quoted in printable characters, and the error is one line.
  InputError(const std::string& file, const std::string& key, const std::string& message)
      : InputError(Quoted{printable(file), printable(key), printable(message)}) {}

  const std::string& file() const { return file_; }
  const std::string& key() const { return key_; }
  const std::string& message() const { return message_; }

  /// Whether it is about a word of the command line and not of a file: "--frames".
  bool isOfOption() const { return key_.starts_with("--"); }

  /// The same error, said of this file.
  InputError in(const std::string& file) const { return {file, key_, message_}; }

 private:
  struct Quoted {
    std::string file, key, message;
  };

  explicit InputError(Quoted quoted)
      : std::runtime_error(join(quoted)),
        file_(std::move(quoted.file)),
        key_(std::move(quoted.key)),
        message_(std::move(quoted.message)) {}

  static std::string join(const Quoted& quoted) {
    std::string text;
    for (const std::string* part : {&quoted.file, &quoted.key})
      if (!part->empty()) text += *part + ": ";
    return text + quoted.message;
  }

  std::string file_, key_, message_;
};

}  // namespace asperity
