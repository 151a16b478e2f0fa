// Digests of files: SHA-256 (FIPS 180-4), so that a result can identify the content from which it
// was made, and MD5, which formats of files state of their own parts.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Return the digest as 64 and as 32 hexadecimal digits.
std::string sha256(std::string_view bytes);
std::string md5(std::string_view bytes);

/// Returns the SHA-256 of a regular file's content. Digests are kept for as long as size and time
/// of the file stay. Any thread. Throws InputError where the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace asperity
