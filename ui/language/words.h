// The texts of pictures, as the language in use has them. Pure once the language is chosen; any
// thread.
#pragma once

#include <initializer_list>
#include <string>

namespace asperity {

class Words {
 public:
  /// UTF-8. Found by Qt's tool for translators like any tr().
  static std::string tr(const char* english);
};

/// Puts the values in the places of %1, %2, ...
std::string filled(const std::string& text, std::initializer_list<std::string> values);

}  // namespace asperity
