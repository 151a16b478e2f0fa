// Small draw lists and their pixels, for the tests of the renderer.
#pragma once

#include <array>

#include "ui/draw/pixel_context.h"

namespace asperity {

inline constexpr Rgba kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1}, kRed{1, 0, 0, 1};

inline DrawList blackList(int width, int height) {
  DrawList list;
  list.width = width;
  list.height = height;
  list.background = kBlack;
  return list;
}

inline DrawLine straight(float x0, float y0, float x1, float y1, float width, Rgba colour) {
  return {{{x0, y0, colour}, {x1, y1, colour}}, width};
}

/// Two triangles.
inline std::vector<DrawVertex> rectangle(float x, float y, float width, float height, Rgba colour) {
  const DrawVertex a{x, y, colour}, b{x + width, y, colour}, c{x + width, y + height, colour},
      d{x, y + height, colour};
  return {a, b, c, a, c, d};
}

inline std::array<int, 4> pixel(const Pixels& pixels, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * pixels.width + x) * 4;
  return {pixels.rgba[i], pixels.rgba[i + 1], pixels.rgba[i + 2], pixels.rgba[i + 3]};
}

inline int red(const Pixels& pixels, int x, int y) {
  return pixel(pixels, x, y)[0];
}

/// Sum of the red channel in units of full pixels: the covered area where all is white on black.
inline double coverage(const Pixels& pixels) {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.rgba.size(); i += 4) sum += pixels.rgba[i] / 255.0;
  return sum;
}

}  // namespace asperity
