// Other programs that this one starts: ffmpeg for films, Gwyddion for rare formats.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Returns the path of the program in PATH; empty where it is not found.
std::string findProgram(std::string_view name);

}  // namespace asperity
