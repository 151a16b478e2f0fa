#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr Rgba colour(unsigned rgb, float alpha = 1) {
  return {static_cast<float>(rgb >> 16 & 255U) / 255, static_cast<float>(rgb >> 8 & 255U) / 255,
          static_cast<float>(rgb & 255U) / 255, alpha};
}

}  // namespace

const Theme& lightTheme() {
  static const Theme theme{.background = colour(0xFFFFFF),
                           .panel = colour(0xEFF5FA),
                           .text = colour(0x18212B),
                           .faintText = colour(0x5A6876),
                           .grid = colour(0x000000, 0.07F),
                           .axis = colour(0x7D8A97),
                           .rigid = colour(0xB4BFCA),
                           .rigidEdge = colour(0x2A3440),
                           .elastomer = colour(0x355673),
                           .elastomerEdge = colour(0x12263A),
                           .highlight = colour(0xB83A06)};
  return theme;
}

const Theme& darkTheme() {
  static const Theme theme{.background = colour(0x10161D),
                           .panel = colour(0x05080B),
                           .text = colour(0xE8EEF4),
                           .faintText = colour(0x93A3B2),
                           .grid = colour(0xFFFFFF, 0.06F),
                           .axis = colour(0x5F6E7C),
                           .rigid = colour(0x4B5866),
                           .rigidEdge = colour(0xD2DBE4),
                           .elastomer = colour(0x1F415E),
                           .elastomerEdge = colour(0x7FC0F0),
                           .highlight = colour(0xFFB454)};
  return theme;
}

const Theme& printTheme() {
  static const Theme theme = [] {
    Theme print = lightTheme();
    print.text = print.axis = colour(0x000000);
    print.faintText = colour(0x333333);
    print.grid = colour(0x000000, 0.09F);
    return print;
  }();
  return theme;
}

}  // namespace asperity
