// Colours of pictures: the themes (light, dark, print) and the distinct colours and ramps of
// series. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>

#include "ui/draw/draw_list.h"

namespace asperity {

struct Theme {
  Rgba background, panel, text, faintText, grid, axis;
  Rgba rigid, rigidEdge, elastomer, elastomerEdge, highlight;
  bool isForPrint = false;  // axes are black, and charts have their tick marks inside of the frame
  /// The contact is drawn for print: flat light tints, hatching, and pressures as strokes, which
  /// are legible without colours.
  bool isPaper = false;
};
const Theme& lightTheme();
const Theme& darkTheme();
const Theme& printTheme();  // black on white, for paper
const Theme& paperTheme();  // the same, with a contact in light tints instead of ink

/// Returns whether the background is dark, by its luma (Rec. 601).
bool isDark(const Theme& theme);

/// Returns 0xRRGGBB as a colour.
constexpr Rgba colourFrom(std::uint32_t rgb, float alpha = 1) {
  return {static_cast<float>(rgb >> 16 & 255U) / 255, static_cast<float>(rgb >> 8 & 255U) / 255,
          static_cast<float>(rgb & 255U) / 255, alpha};
}

/// Control colours of "viridis" (matplotlib, CC0) at 0, 0.1, ..., 1: ordered by lightness, and
/// perceptually uniform.
inline constexpr std::array<Rgba, 11> kViridis = {
    colourFrom(0x440154), colourFrom(0x482475), colourFrom(0x414487), colourFrom(0x355F8D),
    colourFrom(0x2A788E), colourFrom(0x21918C), colourFrom(0x22A884), colourFrom(0x44BF70),
    colourFrom(0x7AD151), colourFrom(0xBDDF26), colourFrom(0xFDE725)};

/// Replaces every colour by the grey of its luminance (Rec. 709, of the coded values).
void removeColours(DrawList& list);

/// Returns a at t = 0 and b at t = 1, interpolated channel by channel.
Rgba mix(const Rgba& a, const Rgba& b, float t);
Rgba withAlpha(Rgba colour, float alpha);
/// Returns dark or light, whichever is more legible on `fill`.
Rgba textOn(const Rgba& fill);

/// Returns a colour of the bright part of the published "inferno" map: perceptually uniform, and
/// ordered by lightness, so legible with any colour vision. t in [0, 1] from the least to the
/// greatest pressure.
Rgba pressureColour(float t);

/// Returns a colour from a surface just released (t = 0, yellow) to one long free (t = 1, blue like
/// the elastomer): most of the published "viridis" map, backwards.
Rgba ageColour(float t);

}  // namespace asperity
