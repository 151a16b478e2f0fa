// Pictures as PNG files that are either complete or absent. Any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

struct PngOptions {
  std::string title;       // kept as the text chunk "Title"; empty: none
  std::string metadata;    // any UTF-8 text, kept as the text chunk "asperity"; empty: none
  double dotsPerInch = 0;  // 0: not in the file
};

/// Returns the file's bytes: 24-bit where the picture is opaque, otherwise 32-bit. The same picture
/// gives the same bytes. Throws std::runtime_error for an empty picture.
std::string encodePng(const QImage& image, const PngOptions& options = {});

/// Writes beside the final name and renames; an existing file is replaced. After a failure nothing
/// is left behind, an existing file is unchanged, and std::runtime_error gives the reason in one
/// sentence that names the file.
void writePng(const std::filesystem::path& path, const QImage& image,
              const PngOptions& options = {});

/// Returns the text chunk "asperity" of a PNG's bytes; empty where there is none.
std::string pngMetadata(std::string_view bytes);

/// Returns whether no pixel of an image in the format RGBA8888 is transparent.
bool isOpaque(const QImage& image);

}  // namespace asperity
