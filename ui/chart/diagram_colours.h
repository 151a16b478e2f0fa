// Colours of a diagram's series, also used by the window's chart. Pure; any thread.
#pragma once

#include "ui/draw/theme.h"

namespace asperity {

inline constexpr int kDistinctColours = 9;

/// Returns a colour of the palette of Okabe and Ito (2008), whose colours every colour vision can
/// distinguish, darkened or lightened where it would be too faint on the theme's background.
/// Repeats after kDistinctColours.
Rgba seriesColour(int index, const Theme& theme);

/// Returns a colour of "viridis", ordered by lightness for every colour vision, without the end
/// that is invisible on the theme's background. t in [0, 1].
Rgba rampColour(double t, const Theme& theme);

/// Returns a colour of the whole of "viridis", for areas that touch no background.
Rgba fieldColour(double t);

/// A line over a field: a light core within a dark edge, seen on all of the field's colours.
inline constexpr Rgba kLineOnField{1, 1, 1, 1}, kEdgeOnField{0, 0, 0, 0.75F};
inline constexpr float kLineOnFieldWidth = 1.6F, kEdgeOnFieldWidth = 4.2F;  // units

}  // namespace asperity
