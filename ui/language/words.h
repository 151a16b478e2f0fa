// The texts of pictures in the current language. Pure once the language is chosen; any thread.
#pragma once

#include <string>

#include "core/base/message.h"

namespace asperity {

class Words {
 public:
  /// Returns the translation in UTF-8. Qt's tool for translators finds its calls like any tr().
  static std::string tr(const char* english);
};

}  // namespace asperity
