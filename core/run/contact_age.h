// The time since each element was in contact, as far as steady sliding determines it. Pure; any
// thread.
#pragma once

#include <span>
#include <vector>

namespace asperity {

/// Returns the time since contact ended at each of the periodic points, s: 0 in contact. Elements
/// behind a contact were in it a moment ago: the time is the distance to the nearest contact in the
/// direction of sliding over the velocity (m/s, either sign), to within one spacing (m). Infinite
/// where nothing is in contact or nothing slides.
std::vector<double> steadyContactAge(std::span<const double> pressure, double spacing,
                                     double velocity);

}  // namespace asperity
