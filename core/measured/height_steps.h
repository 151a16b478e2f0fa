// Whether the heights of a profile have steps that are too coarse for it: an instrument or a file
// rounds each height to a multiple of one step, which makes a stair of a gentle slope. Pure; any
// thread.
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

}  // namespace asperity
