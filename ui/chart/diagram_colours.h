// Colours of a diagram's series, which the window's chart has, too. Pure; any thread.
#pragma once

#include "ui/draw/theme.h"

namespace asperity {

inline constexpr int kDistinctColours = 9;

/// The palette of Okabe and Ito (2008), which every colour vision tells apart, darkened or
/// lightened where a colour would be too faint on the theme's background. Repeats after
/// kDistinctColours.
Rgba seriesColour(int index, const Theme& theme);

/// "viridis", ordered by lightness for every colour vision, without the end that is lost on the
/// theme's background. t in [0, 1].
Rgba rampColour(double t, const Theme& theme);

}  // namespace asperity
