// Pictures as files of any format, with the texts and the size that such a file contains besides
// the picture. Needs a QGuiApplication and loadFonts(). Threading: any thread on which no OpenGL
// context of a window is current, one at a time.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/pdf_file.h"
#include "ui/draw/png_file.h"

namespace asperity {

struct PictureProperties {
  std::string title;       // of the document; empty: none
  std::string metadata;    // any UTF-8 text; the program writes the provenance; empty: none
  double scale = 1;        // pixels of the picture to one pixel at 96 per inch: its size on paper
  bool isOnPaper = false;  // the size was given as lengths: an SVG has them in millimetres
};

/// Return the options of a format for these properties; those of PNG serve for TIFF, those of PDF
/// for EPS.
PngOptions pngOptions(const PictureProperties& properties);
PdfOptions pdfOptions(const PictureProperties& properties);

/// Writes PNG, SVG or PDF, by the extension in small or capital letters. Throws InputError for any
/// other one, and as writeFileAtomically.
void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties);

/// Adds "language" to a picture's provenance, unless it is English.
void addLanguage(nlohmann::ordered_json& picture);

/// Adds the language to the provenance of a picture that has no other options.
void nameLanguage(nlohmann::ordered_json& origin);

/// Returns the provenance of a picture without options except for the language, as one line.
std::string pictureOrigin(const std::string& verb, const Scene& scene);

}  // namespace asperity
