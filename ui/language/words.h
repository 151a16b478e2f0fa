// The texts of pictures, as the language in use has them. Pure once the language is chosen; any
// thread.
#pragma once

#include <string>

#include "core/base/message.h"

namespace asperity {

class Words {
 public:
  /// UTF-8. Found by Qt's tool for translators like any tr().
  static std::string tr(const char* english);
};

}  // namespace asperity
