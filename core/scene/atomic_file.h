// Files that are either whole or not there: written beside their final name, flushed to the disk
// and renamed. A failed or killed write leaves whatever stood under the name before.
#pragma once

#include <filesystem>
#include <string_view>

namespace asperity {

/// Throws InputError (file, "", why) where nothing can ever be written under this name: a folder
/// that is missing, or something there that is not a plain file. Call before long work.
void checkWritable(const std::filesystem::path& file);

/// Throws what checkWritable throws, and std::runtime_error in one sentence with the file's name
/// where writing fails.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

/// The whole of a file of at most `limit` bytes. Throws InputError.
std::string readWholeFile(const std::filesystem::path& file, std::size_t limit);

}  // namespace asperity
