// Pictures as PNG files that are either whole or not there. Any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.h"

namespace asperity {

/// What a picture file of any format says about the picture besides the picture itself.
struct PictureProperties {
  std::string title;     // of the document; empty: none
  std::string metadata;  // any UTF-8 text; the program writes the provenance; empty: none
  double scale = 1;      // pixels of the picture to one pixel at 96 per inch: its size on paper
};

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

/// "language" among what is said of a picture, where it is not English.
void addLanguage(nlohmann::ordered_json& picture);

/// The same in the provenance of a picture of which nothing else was chosen.
void nameLanguage(nlohmann::ordered_json& origin);

/// The provenance of a picture of which only the language was chosen, as one line.
std::string pictureOrigin(const std::string& verb, const Scene& scene);

}  // namespace asperity
