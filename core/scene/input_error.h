// The one error type for bad input: what a user gave and can mend. The command line prints it as
// one line and exits 2; the window shows it beside the control.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace asperity {

class InputError : public std::runtime_error {
 public:
  /// file and key may be empty. message says what is wrong and what is allowed.
  InputError(std::string file, std::string key, std::string message)
      : std::runtime_error(join(file, key, message)),
        file_(std::move(file)),
        key_(std::move(key)),
        message_(std::move(message)) {}

  const std::string& file() const { return file_; }
  const std::string& key() const { return key_; }
  const std::string& message() const { return message_; }

  /// Whether it is about a word of the command line and not of a file: "--frames".
  bool isOfOption() const { return key_.starts_with("--"); }

  /// The same error, said of this file.
  InputError in(const std::string& file) const { return {file, key_, message_}; }

 private:
  static std::string join(const std::string& file, const std::string& key,
                          const std::string& message) {
    std::string text;
    for (const std::string* part : {&file, &key})
      if (!part->empty()) text += *part + ": ";
    text += message;
    // What a user wrote may hold line breaks; an error is one line.
    for (char& letter : text)
      if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
    return text;
  }

  std::string file_, key_, message_;
};

}  // namespace asperity
