// Pictures as one-page vector PDF with the used part of the fonts inside. The same picture gives
// the same bytes: no date, no random identifier. Needs a QGuiApplication and loadFonts(); one
// thread at a time.
#pragma once

#include <filesystem>
#include <string>

#include "ui/draw/draw_list.h"

namespace asperity {

struct PdfOptions {
  std::string title;             // of the document; empty: none
  std::string metadata;          // any UTF-8 text, kept in the XMP packet; empty: none
  double pointsPerPixel = 0.75;  // of the page's size: 96 pixels an inch
};

/// Throws std::runtime_error where Qt cannot write a PDF.
std::string pdfOf(const DrawList& list, const PdfOptions& options = {});

/// As writeFileAtomically.
void writePdf(const std::filesystem::path& path, const DrawList& list,
              const PdfOptions& options = {});

}  // namespace asperity
