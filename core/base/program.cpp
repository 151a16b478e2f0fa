#include "core/base/program.h"

#include <unistd.h>
#include <cstdlib>
#include <filesystem>

namespace asperity {

std::string findProgram(std::string_view name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::filesystem::path program = std::filesystem::path(rest.substr(0, end)) / name;
    if (::access(program.c_str(), X_OK) == 0) return program.string();
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return {};
}

}  // namespace asperity
