// Pictures as one-page vector PDF that contains the used part of the fonts. The same picture gives
// the same bytes: no date, no random identifier. Needs a QGuiApplication and loadFonts(); one
// thread at a time.
#pragma once

#include <filesystem>
#include <string>

#include "ui/draw/draw_list.h"

class QByteArray;

namespace asperity {

struct PdfOptions {
  std::string title;             // of the document; empty: none
  std::string metadata;          // any UTF-8 text, kept in the XMP packet; empty: none
  double pointsPerPixel = 0.75;  // size of the page: 96 pixels per inch
};

/// Throws std::runtime_error where Qt cannot write a PDF.
std::string pdfBytes(const DrawList& list, const PdfOptions& options = {});

/// Writes blanks over the date of creation in a PDF that Qt made, so that offsets stay valid; the
/// date is the only content that does not depend on what is drawn.
void blankDate(QByteArray& pdf);

/// Writes the file as writeFileAtomically.
void writePdf(const std::filesystem::path& path, const DrawList& list,
              const PdfOptions& options = {});

}  // namespace asperity
