// Pictures as files: PNG and TIFF of pixels, SVG, PDF and EPS of shapes, with texts as texts and
// the used part of the fonts inside. The same picture gives the same bytes: no date, no random
// identifier. A file is complete or absent. Threading: PDF, EPS and writePicture() need a
// QGuiApplication and loadFonts(), one thread at a time, and no OpenGL context of a window may be
// current on it; all else: any thread.
#pragma once

#include <QImage>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/scene/scene.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/pixel_context.h"

class QByteArray;

namespace asperity {

/// The texts and the size that a file contains besides the picture.
struct PictureProperties {
  std::string title{};     // of the document; empty: none
  std::string metadata{};  // any UTF-8 text; the program writes the provenance; empty: none
  double scale = 1;        // pixels of the picture to one pixel at 96 per inch: its size on paper
  bool isOnPaper = false;  // the size was given as lengths: an SVG has them in millimetres

  double dotsPerInch() const { return 96 * scale; }
  double pointsPerPixel() const { return 0.75 / scale; }
};

inline const std::initializer_list<std::string_view> kPictureExtensions = {".png", ".svg", ".pdf",
                                                                           ".eps", ".tif", ".tiff"};

/// Throws InputError where this machine cannot write files of this kind: EPS and TIFF need tools.
void checkPictureTool(const std::filesystem::path& file);

/// Writes the format of the extension, in small or capital letters. context: draws pixels. Throws
/// InputError for an extension that is not one of kPictureExtensions, and as checkPictureTool and
/// writeFileAtomically.
void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties, PixelContext& context = contextOfThread());

// ---- Pixels

/// Returns the file's bytes: 24-bit where the picture is opaque, otherwise 32-bit. Texts are in the
/// chunks "Title" and "asperity"; a picture of scale 0 has no size on paper. Throws
/// std::runtime_error for an empty picture.
std::string encodePng(const QImage& image, const PictureProperties& properties = {.scale = 0});

/// Writes beside the final name and renames; an existing file is replaced. After a failure nothing
/// is left behind, an existing file is unchanged, and std::runtime_error gives the reason in one
/// sentence that names the file.
void writePng(const std::filesystem::path& path, const QImage& image,
              const PictureProperties& properties);

/// Returns the text chunk "asperity" of a PNG's bytes; empty where there is none.
std::string pngMetadata(std::string_view bytes);

/// Returns whether no pixel of an image in the format RGBA8888 is transparent.
bool isOpaque(const QImage& image);

/// Returns whether this program was built with libtiff.
bool canWriteTiff();

/// Returns RGB, or RGBA where the picture is not opaque, compressed without loss (LZW), as
/// publishers want it that accept no other format; the metadata as "asperity: ..." in the
/// description of the image. Throws std::runtime_error for an empty picture.
std::string tiffBytes(const QImage& image, const PictureProperties& properties);

// ---- Shapes

std::string svgText(const DrawList& list, const PictureProperties& properties = {});

/// Returns the text with markup characters escaped, and characters that XML cannot contain replaced
/// by U+FFFD.
std::string xmlText(std::string_view utf8);

/// Returns the XMP packet of a file: title and description where they are not empty, no date, no
/// identifier.
std::string xmpPacket(const std::string& title, const std::string& description);

/// Returns a page of the size of the picture. Throws std::runtime_error where Qt cannot write a
/// PDF.
std::string pdfBytes(const DrawList& list, const PictureProperties& properties = {});

/// Writes blanks over the date of creation in a PDF that Qt made, so that offsets stay valid; the
/// date is the only content that does not depend on what is drawn.
void blankDate(QByteArray& pdf);

/// Returns whether pdftops, which makes EPS of PDF, is installed.
bool canWriteEps();

/// Writes EPS. Letters and lines stay vectors; translucent colours become opaque ones, and a
/// picture with light that fades out becomes an image. The metadata are in comments "%asperity:
/// ..." after the header. Throws std::runtime_error in one sentence that names the file.
void writeEps(const std::filesystem::path& file, const DrawList& list,
              const PictureProperties& properties);

// ---- Provenance

/// Adds "language" to a picture's provenance, unless it is English.
void addLanguage(nlohmann::ordered_json& picture);

/// Adds the language to the provenance of a picture that has no other options.
void nameLanguage(nlohmann::ordered_json& origin);

/// Returns the provenance of a picture without options except for the language, as one line.
std::string pictureOrigin(const std::string& verb, const Scene& scene);

}  // namespace asperity
