// Flaws of measured profiles: heights with steps that are too coarse, because an instrument or a
// file rounds each of them to a multiple of one step, which makes a stair of a gentle slope, and a
// form that a parabola does not follow, as of a tyre or a roller. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>

namespace asperity {

struct HeightSteps {
  double step = 0;          // m, between levels; 0: the heights are fine enough
  std::int64_t levels = 0;  // different heights of the profile
  double spread = 0;        // m, standard deviation of the differences between neighbours
};

/// Returns the steps of a profile whose rounding makes it steeper by about 7 % or more: all heights
/// are multiples of one step, and neighbours differ by less than 1.4 of it. Rounding adds the
/// variance step^2 / 6 to that of the differences. A shape of few straight parts, such as a
/// triangle, is exact, although its heights are multiples of a step. heights: as in the file,
/// before any processing; NaN where nothing was measured.
HeightSteps coarseSteps(std::span<const double> heights);

/// Returns the radius (m) of a profile that is a circle with roughness on it: a circle leaves at
/// most 0.8 of the rms heights that a parabola leaves, which has as many unknowns. 0: it is none.
/// Long waves of a rough surface may look like a form of any kind, but they are no circle whose
/// slope becomes large, and a flat circle is a parabola. heights: m; NaN where nothing was
/// measured.
double radiusOfRoundForm(std::span<const double> heights, double spacing);

}  // namespace asperity
