#include "ui/draw/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {
namespace {

/// Returns how light a colour appears, 0 to 1 (the luma of ITU-R BT.601).
float luma(const Rgba& c) {
  return 0.299F * c.r + 0.587F * c.g + 0.114F * c.b;
}

}  // namespace

const Theme& lightTheme() {
  static const Theme theme{.background = colourFrom(0xFFFFFF),
                           .panel = colourFrom(0xEFF5FA),
                           .text = colourFrom(0x18212B),
                           .faintText = colourFrom(0x5A6876),
                           .grid = colourFrom(0x000000, 0.07F),
                           .axis = colourFrom(0x7D8A97),
                           .rigid = colourFrom(0xB4BFCA),
                           .rigidEdge = colourFrom(0x2A3440),
                           .elastomer = colourFrom(0x355673),
                           .elastomerEdge = colourFrom(0x12263A),
                           .highlight = colourFrom(0xB83A06)};
  return theme;
}

const Theme& darkTheme() {
  static const Theme theme{.background = colourFrom(0x10161D),
                           .panel = colourFrom(0x05080B),
                           .text = colourFrom(0xE8EEF4),
                           .faintText = colourFrom(0x93A3B2),
                           .grid = colourFrom(0xFFFFFF, 0.06F),
                           .axis = colourFrom(0x5F6E7C),
                           .rigid = colourFrom(0x4B5866),
                           .rigidEdge = colourFrom(0xD2DBE4),
                           .elastomer = colourFrom(0x1F415E),
                           .elastomerEdge = colourFrom(0x7FC0F0),
                           .highlight = colourFrom(0xFFB454)};
  return theme;
}

const Theme& printTheme() {
  static const Theme theme = [] {
    Theme print = lightTheme();
    print.text = print.axis = colourFrom(0x000000);
    print.faintText = colourFrom(0x333333);
    print.grid = colourFrom(0x000000, 0.09F);
    print.isForPrint = true;
    return print;
  }();
  return theme;
}

const Theme& paperTheme() {
  static const Theme theme = [] {
    Theme paper = printTheme();
    paper.panel = colourFrom(0xFFFFFF);
    paper.rigid = colourFrom(0xF7F7F7);
    paper.rigidEdge = colourFrom(0x000000);
    paper.elastomer = colourFrom(0xDDE4EA);
    paper.elastomerEdge = colourFrom(0x000000);
    paper.faintText = colourFrom(0x000000);
    paper.axis = colourFrom(0x000000);
    paper.highlight = colourFrom(0x000000);
    paper.isPaper = true;
    return paper;
  }();
  return theme;
}

bool isDark(const Theme& theme) {
  return luma(theme.background) < 0.5F;
}

void removeColours(DrawList& list) {
  const auto toGrey = [](Rgba& c) {
    c.r = c.g = c.b = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
  };
  toGrey(list.background);
  for (DrawLayer& layer : list.layers) {
    for (DrawVertex& vertex : layer.triangles) toGrey(vertex.colour);
    for (DrawField& field : layer.fields)
      for (Rgba& colour : field.colours) toGrey(colour);
    for (DrawLine& line : layer.lines)
      for (DrawVertex& vertex : line.vertices) toGrey(vertex.colour);
  }
  for (DrawText& text : list.texts) toGrey(text.colour);
}

namespace {

// Control colours of "inferno" (matplotlib, CC0) at 0.5, 0.55, ..., 1. Its dark half is left out,
// because it has too little contrast to the elastomer.
constexpr std::array<Rgba, 11> kInferno = {
    colourFrom(0xBC3754), colourFrom(0xCE4447), colourFrom(0xDD513A), colourFrom(0xEA632A),
    colourFrom(0xF37819), colourFrom(0xF98E09), colourFrom(0xFCA50A), colourFrom(0xFBBE23),
    colourFrom(0xF6D746), colourFrom(0xF2EF76), colourFrom(0xFCFFA4)};

// "Viridis" backwards, from 1 to 0.3. The rest is darker than the elastomer.
constexpr std::array<Rgba, 8> kAgeColours = [] {
  std::array<Rgba, 8> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = kViridis[kViridis.size() - 1 - i];
  return colours;
}();

template <std::size_t N>
Rgba alongMap(const std::array<Rgba, N>& map, float t) {
  const float position = std::clamp(std::isfinite(t) ? t : 0.0F, 0.0F, 1.0F) * (N - 1);
  const auto below = std::min(static_cast<std::size_t>(position), N - 2);
  return mix(map[below], map[below + 1], position - static_cast<float>(below));
}

}  // namespace

Rgba mix(const Rgba& a, const Rgba& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t,
          a.a + (b.a - a.a) * t};
}

Rgba withAlpha(Rgba colour, float alpha) {
  colour.a = alpha;
  return colour;
}

Rgba textOn(const Rgba& fill) {
  return luma(fill) > 0.5F ? colourFrom(0x161E28) : colourFrom(0xF0F5FA);
}

Rgba pressureColour(float t) {
  return alongMap(kInferno, t);
}

Rgba ageColour(float t) {
  return alongMap(kAgeColours, t);
}

}  // namespace asperity
