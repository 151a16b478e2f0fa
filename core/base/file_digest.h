// SHA-256 (FIPS 180-4) of files, so that a result can name the very content that it was made from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same of a regular file's content. What was found is kept for as long as size and time of the
/// file stay. Any thread. Throws InputError where the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace asperity
