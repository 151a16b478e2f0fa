// Pictures as PNG files that are either whole or not there. Any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <string>

namespace asperity {

struct PngOptions {
  std::string title;       // kept as the text chunk "Title"; empty: none
  std::string metadata;    // any UTF-8 text, kept as the text chunk "asperity"; empty: none
  double dotsPerInch = 0;  // 0: the file does not say
};

/// The file's bytes: 24-bit where the picture is opaque, else 32-bit. The same picture gives the
/// same bytes. Throws std::runtime_error for a picture that is empty.
std::string pngOf(const QImage& image, const PngOptions& options = {});

/// Writes beside the final name and renames; an existing file is replaced. On failure nothing is
/// left behind, an existing file stays as it was, and std::runtime_error says why in one sentence
/// that names the file.
void writePng(const std::filesystem::path& path, const QImage& image,
              const PngOptions& options = {});

/// The text chunk "asperity" of a PNG's bytes; empty where there is none.
std::string pngMetadata(std::string_view bytes);

}  // namespace asperity
