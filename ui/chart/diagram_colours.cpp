#include "ui/chart/diagram_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr Rgba colour(unsigned rgb) {
  return {static_cast<float>(rgb >> 16 & 255U) / 255, static_cast<float>(rgb >> 8 & 255U) / 255,
          static_cast<float>(rgb & 255U) / 255, 1};
}

// Blue, vermilion, green, purple, orange, sky blue, and for Okabe and Ito's yellow an olive on
// white; then two colours far from all of these for every colour vision, on dark with a contrast
// of 3 also with the tint of region IV.
constexpr std::array<Rgba, kDistinctColours> kOnLight = {
    colour(0x0072B2), colour(0xD55E00), colour(0x009E73), colour(0xB85C96), colour(0xD98C00),
    colour(0x3FA0DC), colour(0x6B6100), colour(0x4818E0), colour(0x201060)};
constexpr std::array<Rgba, kDistinctColours> kOnDark = {
    colour(0x56B4E9), colour(0xFF8A3D), colour(0x22C294), colour(0xDD8FBC), colour(0xF0E442),
    colour(0x5C8DF0), colour(0xC9A26B), colour(0x735FFF), colour(0xD65030)};

// Control colours of "viridis" (matplotlib, CC0) at 0, 0.1, ..., 1.
constexpr std::array<Rgba, 11> kViridis = {colour(0x440154), colour(0x482475), colour(0x414487),
                                           colour(0x355F8D), colour(0x2A788E), colour(0x21918C),
                                           colour(0x22A884), colour(0x44BF70), colour(0x7AD151),
                                           colour(0xBDDF26), colour(0xFDE725)};
constexpr double kDarkEnd = 0.18, kLightEnd = 0.82;  // part that is visible on dark and on white

}  // namespace

Rgba seriesColour(int index, const Theme& theme) {
  const auto place = static_cast<std::size_t>(std::max(index, 0) % kDistinctColours);
  return isDark(theme) ? kOnDark[place] : kOnLight[place];
}

Rgba rampColour(double t, const Theme& theme) {
  const bool dark = isDark(theme);
  const double from = dark ? kDarkEnd : 0, to = dark ? 1 : kLightEnd;
  const double held = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  return fieldColour(from + held * (to - from));
}

Rgba fieldColour(double t) {
  const double held = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  const double place = held * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  return mix(kViridis[below], kViridis[below + 1],
             static_cast<float>(place - static_cast<double>(below)));
}

}  // namespace asperity
