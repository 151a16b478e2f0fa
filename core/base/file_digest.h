// SHA-256 (FIPS 180-4) of files, so that a result can identify the content from which it was made.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Returns the digest as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// Returns the digest of a regular file's content. Digests are kept for as long as size and time of
/// the file stay. Any thread. Throws InputError where the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace asperity
