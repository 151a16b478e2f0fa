// Whether a profile is part of a circle that a parabola does not follow, as of a tyre or a roller.
// Pure; any thread.
#pragma once

#include <span>

namespace asperity {

/// Returns the radius (m) of a profile that is a circle with roughness on it: a circle leaves at
/// most 0.8 of the rms heights that a parabola leaves, which has as many unknowns. 0: it is none.
/// Long waves of a rough surface may look like a form of any kind, but they are no circle whose
/// slope becomes large, and a flat circle is a parabola. heights: m; NaN where nothing was
/// measured.
double radiusOfRoundForm(std::span<const double> heights, double spacing);

}  // namespace asperity
