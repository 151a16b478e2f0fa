// The family of fonts for the texts of pictures, where the user chooses another one than the
// embedded DejaVu Sans. It is set once, before any picture is composed; it may then be read on any
// thread. Characters that the family lacks are drawn with DejaVu Sans.
#pragma once

#include <QByteArray>
#include <array>
#include <set>
#include <string>

#include "ui/draw/fonts.h"

namespace asperity {

struct FontChoice {
  std::string family;  // empty: DejaVu Sans
  struct Face {
    QByteArray file;
    FontAdvances advances;
  };
  std::array<Face, 2> faces{};  // regular, bold

  const Face& face(bool bold) const { return faces[bold ? 1 : 0]; }
};

/// Chooses an installed family for all later texts of this process; empty: DejaVu Sans. Throws
/// InputError naming --font with the nearest family where none has this name, or where its fonts
/// are no outlines.
void useFontFamily(const std::string& family);

const FontChoice& fontChoice();

/// Returns a subset of the chosen family, as fontSubset() of ui/draw/fonts.h does.
QByteArray chosenFontSubset(bool bold, const std::set<char32_t>& characters);

}  // namespace asperity
