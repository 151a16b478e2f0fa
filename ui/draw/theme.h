// Colours of pictures: the themes (light, dark, print) and the distinct colours and ramps of
// series. Pure; any thread.
#pragma once

#include "ui/draw/draw_list.h"

namespace asperity {

struct Theme {
  Rgba background, panel, text, faintText, grid, axis;
  Rgba rigid, rigidEdge, elastomer, elastomerEdge, highlight;
};
const Theme& lightTheme();
const Theme& darkTheme();
const Theme& printTheme();  // black on white, for paper

/// a at t = 0, b at t = 1, channel by channel.
Rgba mix(const Rgba& a, const Rgba& b, float t);
Rgba withAlpha(Rgba colour, float alpha);
/// Dark or light, whichever reads better on `fill`.
Rgba textOn(const Rgba& fill);

/// The bright part of the published "inferno" map: perceptually uniform, ordered by lightness and
/// so readable with any colour vision. t in [0, 1] from the least to the greatest pressure.
Rgba pressureColour(float t);

/// From a surface just released (t = 0, yellow) to one long free (t = 1, blue like the elastomer):
/// most of the published "viridis" map, backwards.
Rgba ageColour(float t);

}  // namespace asperity
