// Pictures as PNG files that are either whole or not there. Any thread.
#pragma once

#include <filesystem>

#include <QImage>

namespace asperity {

/// Writes beside the final name and renames; an existing file is replaced. On failure nothing is
/// left behind, an existing file stays as it was, and std::runtime_error says why in one sentence
/// that names the file.
void writePng(const std::filesystem::path& path, const QImage& image);

}  // namespace asperity
