#include "core/base/file_name.h"

#include <cctype>

namespace asperity {

std::string fileNameOf(std::string_view name) {
  constexpr std::size_t kMost = 60;
  std::string clean;
  for (const unsigned char letter : name.substr(0, kMost))
    clean +=
        std::isalnum(letter) || letter == '-' || letter == '_' ? static_cast<char>(letter) : '_';
  return clean;
}

}  // namespace asperity
