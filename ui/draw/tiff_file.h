// Pictures as TIFF files that are either complete or absent, for publishers that accept no other
// format. They need libtiff when the program is built. Any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <string>

#include "ui/draw/png_file.h"

namespace asperity {

/// Returns whether this program was built with libtiff.
bool canWriteTiff();

/// Returns the file's bytes: RGB, or RGBA where the picture is not opaque, compressed without loss
/// (LZW); the metadata as "asperity: ..." in the description of the image. The same picture gives
/// the same bytes. Throws std::runtime_error for an empty picture, or where it cannot be written.
std::string tiffBytes(const QImage& image, const PngOptions& options = {});

/// Writes the file as writeFileAtomically.
void writeTiff(const std::filesystem::path& path, const QImage& image,
               const PngOptions& options = {});

}  // namespace asperity
