// Errors shown to users. InputError is the only type for invalid input, which the user can correct:
// the command line prints it as one line and exits with 2, the window shows it beside the control.
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

/// An error for users: a message, and before it the names of its subject. what() is the full
/// English text.
class TextError : public std::runtime_error {
 public:
  explicit TextError(Message message, std::vector<std::string> about = {})
      : std::runtime_error(withNames(about, message).english()),
        message_(std::move(message)),
        about_(std::move(about)) {}

  const Message& message() const { return message_; }
  /// The names before the message, such as file and key; each may be empty.
  const std::vector<std::string>& about() const { return about_; }

  /// Returns "file: key: message"; an empty name is left out.
  static Message withNames(const std::vector<std::string>& names, Message message);

 private:
  Message message_;
  std::vector<std::string> about_;
};

/// Returns the message of an error with the names before it; for an error that is not a TextError,
/// what().
Message errorMessage(const std::exception& error);

/// An error in the user's input.
class InputError : public TextError {
 public:
  /// file and key may be empty. message tells what is wrong and what is allowed. Each may contain
  /// unchecked text of a user: it is quoted in printable characters, and the error is one line.
  InputError(const std::string& file, const std::string& key, const Message& message)
      : TextError(message.quoted(), {printable(file), printable(key)}) {}

  const std::string& file() const { return about()[0]; }
  const std::string& key() const { return about()[1]; }

  /// Returns whether the error is about an option of the command line such as "--frames", not a
  /// file.
  bool isOfOption() const { return key().starts_with("--"); }

  /// Returns the same error with the name of this file.
  InputError in(const std::string& file) const { return {file, key(), message()}; }

  /// Returns the error with the name of this file, unless it names one already.
  InputError withFile(const std::string& name) const { return file().empty() ? in(name) : *this; }
};

/// Returns the error for a file whose extension (with its dot) is not one of the known ones.
InputError unknownExtension(const std::string& file, const std::string& extension,
                            std::initializer_list<std::string_view> known);

}  // namespace asperity
