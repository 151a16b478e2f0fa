#include "ui/chart/diagram_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/draw/theme.h"

namespace asperity {
namespace {

// Blue, vermilion, green, purple, orange, sky blue, and for Okabe and Ito's yellow an olive on
// white; then two colours far from all of these for every colour vision, on dark with a contrast
// of 3 also with the tint of region IV.
constexpr std::array<Rgba, kDistinctColours> kOnLight = {
    colourFrom(0x0072B2), colourFrom(0xD55E00), colourFrom(0x009E73),
    colourFrom(0xB85C96), colourFrom(0xD98C00), colourFrom(0x3FA0DC),
    colourFrom(0x6B6100), colourFrom(0x4818E0), colourFrom(0x201060)};
constexpr std::array<Rgba, kDistinctColours> kOnDark = {
    colourFrom(0x56B4E9), colourFrom(0xFF8A3D), colourFrom(0x22C294),
    colourFrom(0xDD8FBC), colourFrom(0xF0E442), colourFrom(0x5C8DF0),
    colourFrom(0xC9A26B), colourFrom(0x735FFF), colourFrom(0xD65030)};

constexpr double kDarkEnd = 0.18, kLightEnd = 0.82;  // part that is visible on dark and on white

}  // namespace

Rgba seriesColour(int index, const Theme& theme) {
  const auto position = static_cast<std::size_t>(std::max(index, 0) % kDistinctColours);
  return isDark(theme) ? kOnDark[position] : kOnLight[position];
}

Rgba rampColour(double t, const Theme& theme) {
  const bool dark = isDark(theme);
  const double from = dark ? kDarkEnd : 0, to = dark ? 1 : kLightEnd;
  const double held = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  return fieldColour(from + held * (to - from));
}

Rgba fieldColour(double t) {
  const double held = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  const double position = held * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), kViridis.size() - 2);
  return mix(kViridis[below], kViridis[below + 1],
             static_cast<float>(position - static_cast<double>(below)));
}

}  // namespace asperity
