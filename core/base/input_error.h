// Errors that people read. InputError is the one type for bad input, which a user gave and can
// mend: the command line prints it as one line and exits 2, the window shows it beside the control.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/base/text.h"

namespace asperity {

/// An error that people read: what it says is a message, and before it stands what it is about.
/// what() is all of it in English.
class TextError : public std::runtime_error {
 public:
  explicit TextError(Message message, std::vector<std::string> about = {})
      : std::runtime_error(withNames(about, message).english()),
        message_(std::move(message)),
        about_(std::move(about)) {}

  const Message& message() const { return message_; }
  /// The names in front of it, such as file and key; each may be empty.
  const std::vector<std::string>& about() const { return about_; }

  /// "file: key: message"; an empty name is left out.
  static Message withNames(const std::vector<std::string>& names, Message message);

 private:
  Message message_;
  std::vector<std::string> about_;
};

/// What an error says, with what it is about in front; of an error that is not a TextError what().
Message messageOf(const std::exception& error);

/// What a user gave and can mend.
class InputError : public TextError {
 public:
  /// file and key may be empty. message says what is wrong and what is allowed. Each may hold what
  /// a user wrote as it is: it is quoted in printable characters, and the error is one line.
  InputError(const std::string& file, const std::string& key, const Message& message)
      : TextError(message.quoted(), {printable(file), printable(key)}) {}

  const std::string& file() const { return about()[0]; }
  const std::string& key() const { return about()[1]; }

  /// Whether it is about a word of the command line and not of a file: "--frames".
  bool isOfOption() const { return key().starts_with("--"); }

  /// The same error, said of this file.
  InputError in(const std::string& file) const { return {file, key(), message()}; }
};

/// The error of a file whose extension (with its dot) is none of the known ones.
InputError unknownExtension(const std::string& file, const std::string& extension,
                            std::initializer_list<std::string_view> known);

}  // namespace asperity
