// File names made of what people call a thing. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Letters and digits of ASCII, '-' and '_' stay, every other byte becomes '_'; 60 at most. Empty
/// for an empty name.
std::string fileNameOf(std::string_view name);

}  // namespace asperity
