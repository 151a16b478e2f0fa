// The embedded fonts and the part of them that a picture uses. Needs no QGuiApplication. Any
// thread.
#pragma once

#include <set>
#include <string>

#include <QByteArray>

#include "ui/draw/draw_list.h"

namespace asperity {

/// The file of DejaVu Sans from the program's resources.
QByteArray fontFile(bool bold);

/// Characters of the texts in one of the two fonts.
std::set<char32_t> charactersIn(const DrawList& list, bool bold);

/// A TrueType font with the glyphs of these characters alone, without hints, kerning and ligatures;
/// the same characters give the same bytes. Throws std::runtime_error where the font cannot be cut.
QByteArray fontSubset(bool bold, const std::set<char32_t>& characters);

}  // namespace asperity
