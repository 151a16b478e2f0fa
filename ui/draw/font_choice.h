// The family of fonts for the texts of pictures, where a user asks for another one than the
// embedded DejaVu Sans. It is chosen once, before any picture is composed; reading is then free on
// any thread. Characters that the family does not have are DejaVu Sans.
#pragma once

#include <QByteArray>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>

namespace asperity {

struct FontChoice {
  std::string family;  // empty: DejaVu Sans
  struct Face {
    QByteArray file;
    std::unordered_map<std::uint32_t, std::int16_t> advances;  // in 1/kAdvancesPerSize of the size
  };
  std::array<Face, 2> faces{};  // regular, bold

  const Face& face(bool bold) const { return faces[bold ? 1 : 0]; }
};

/// Chooses an installed family for all later texts of this process; empty: DejaVu Sans. Throws
/// InputError naming --font with the nearest family where none has this name, or where its fonts
/// are no outlines.
void useFontFamily(const std::string& family);

const FontChoice& fontChoice();

/// The same as fontSubset() of ui/draw/fonts.h, of the chosen family.
QByteArray chosenFontSubset(bool bold, const std::set<char32_t>& characters);

}  // namespace asperity
