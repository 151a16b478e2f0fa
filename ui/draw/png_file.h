// Pictures as PNG files that are either complete or absent. Any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.h"
#include "ui/draw/draw_list.h"

namespace asperity {

/// Texts and size that a picture file of any format contains besides the picture.
struct PictureProperties {
  std::string title;       // of the document; empty: none
  std::string metadata;    // any UTF-8 text; the program writes the provenance; empty: none
  double scale = 1;        // pixels of the picture to one pixel at 96 per inch: its size on paper
  bool isOnPaper = false;  // the size was given as lengths: an SVG has them in millimetres
};

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

/// Adds "language" to a picture's provenance, unless it is English.
void addLanguage(nlohmann::ordered_json& picture);

/// Adds the language to the provenance of a picture that has no other options.
void nameLanguage(nlohmann::ordered_json& origin);

/// Returns the provenance of a picture without options except for the language, as one line.
std::string pictureOrigin(const std::string& verb, const Scene& scene);

}  // namespace asperity
