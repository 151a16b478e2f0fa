// The embedded font: the widths of its texts, drawing them as pixels, and making a font of only the
// characters that a vector file needs. Any thread, each text by itself.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QFont>
#include <QImage>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ui/draw/draw_list.h"

class QPainter;

namespace asperity {

inline constexpr float kAdvancesPerSize = 2048;

/// Height of the middle of capitals and digits above their baseline, in sizes of the font.
inline constexpr float kMiddleOfText = 0.36F;

inline constexpr float kSmallestFont = 7;  // pixels; smaller letters are illegible

/// Returns the factor of fonts and lines in a picture that is this many times as large as a usual
/// one. Small pictures shrink their texts a little; large ones enlarge them less than the picture.
float textScale(float pictureScale);

/// The advances of a font's characters, in units of 1/kAdvancesPerSize of its size.
using FontAdvances = std::unordered_map<std::uint32_t, std::int16_t>;

/// Measures every character of a font file, or of one font of a collection.
FontAdvances measuredAdvances(const QByteArray& file, unsigned index = 0);

/// Returns the advance of a character; one that no font has counts as a wide one.
std::int16_t fontAdvance(std::uint32_t character, bool bold);

/// Returns the file of DejaVu Sans from the program's resources.
QByteArray fontFile(bool bold);

/// Returns the characters of the texts in one of the two fonts.
std::set<char32_t> charactersIn(const DrawList& list, bool bold);

/// Returns a TrueType font with the glyphs of these characters only, without hints, kerning and
/// ligatures; the same characters give the same bytes. Throws std::runtime_error where the font
/// cannot be reduced.
QByteArray fontSubset(bool bold, const std::set<char32_t>& characters);

/// Returns the width in pixels for a font of `size` pixels. Characters that no font has
/// count as wide ones.
float textWidth(std::string_view utf8, float size, bool bold = false);

/// Returns the width of the widest of some lines.
float widestLine(const std::vector<std::string>& lines, float size);

/// Returns the largest integer font size from `size` down to `least` at which the text fits.
float fittingSize(const std::string& utf8, float size, float least, bool bold, float width);

/// Returns the text, or its beginning and an ellipsis, at most `width` pixels wide; may be empty.
std::string elided(const std::string& utf8, float size, bool bold, float width);

/// Breaks the text at blanks into lines at most `width` pixels wide; a wider word is shortened.
std::vector<std::string> wrapped(const std::string& utf8, float size, bool bold, float width);

class PixelContext;

/// Adds the embedded fonts (resources/fonts) to the application; repeated calls do nothing. Throws
/// std::runtime_error if Qt refuses them.
void loadFonts();

QColor toQColor(const Rgba& colour);
/// Returns a at share 0 and b at 1, interpolated channel by channel.
QColor mixed(const QColor& a, const QColor& b, double share);

/// Returns the font of this text.
QFont toQFont(const DrawText& text);

/// Paints list.texts; the painter's coordinates are the list's pixels.
void paintTexts(QPainter& painter, const DrawList& list);

/// Draws shapes and texts as one picture. Throws std::runtime_error where the context cannot draw.
QImage renderImage(PixelContext& context, const DrawList& list);

}  // namespace asperity
