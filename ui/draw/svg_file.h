// Pictures as SVG: shapes as paths, texts as texts with the used part of the font inside. The same
// picture gives the same bytes. No QGuiApplication is needed. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ui/draw/draw_list.h"

namespace asperity {

struct SvgOptions {
  std::string title;       // shown by a viewer; empty: none
  std::string metadata;    // any UTF-8 text, kept in <metadata>; empty: none
  double millimetres = 0;  // of one pixel, where the picture has a size on paper; 0: it has none
};

std::string svgText(const DrawList& list, const SvgOptions& options = {});

/// Writes the file as writeFileAtomically.
void writeSvg(const std::filesystem::path& path, const DrawList& list,
              const SvgOptions& options = {});

/// Returns the text with markup characters escaped, and characters that XML cannot contain replaced
/// by U+FFFD.
std::string xmlText(std::string_view utf8);

/// Returns the XMP packet of a file: title and description where they are not empty, no date, no
/// identifier.
std::string xmpPacket(const std::string& title, const std::string& description);

}  // namespace asperity
