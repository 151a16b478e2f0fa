// Text as XML holds it. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// With markup characters escaped, and characters that XML cannot hold replaced by U+FFFD.
std::string xmlText(std::string_view utf8);

/// The XMP packet of a file: title and description where they are not empty, no date, no
/// identifier.
std::string xmpPacket(const std::string& title, const std::string& description);

}  // namespace asperity
