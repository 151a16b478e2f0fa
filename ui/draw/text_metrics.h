// How wide a text in the embedded DejaVu Sans will be, from the font's own advances, so that
// pictures are laid out without Qt and on any thread. Kerning is left out (it is below a pixel).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Pixels, for a font of `size` pixels. Characters outside the table count as wide ones.
float textWidth(std::string_view utf8, float size, bool bold = false);

/// The largest whole font size from `size` down to `least` at which the text fits.
float fittingSize(const std::string& utf8, float size, float least, bool bold, float width);

/// The text, or its beginning and an ellipsis, at most `width` pixels wide; may be empty.
std::string elided(const std::string& utf8, float size, bool bold, float width);

/// Broken at blanks into lines at most `width` pixels wide; a word wider than that is elided.
std::vector<std::string> wrapped(const std::string& utf8, float size, bool bold, float width);

}  // namespace asperity
