// Contour lines of a quantity on a rectangular grid, by marching squares: in each cell of the grid
// a line crosses the sides between whose ends the level lies, at the position of linear
// interpolation. In a saddle the mean of the four corners decides which corners are connected.
// Pure; any thread.
#pragma once

#include <span>
#include <vector>

namespace asperity {

struct ContourPoint {
  double x = 0, y = 0;

  bool operator==(const ContourPoint&) const = default;
};

/// The points of a line in order; a closed line ends with its first point.
using ContourLine = std::vector<ContourPoint>;

/// Returns the contour lines of one level. x, y: positions of the grid's columns and rows, strictly
/// rising; values: x fastest, NaN where there is none, which interrupts the lines. A value equal to
/// the level counts as above it.
std::vector<ContourLine> contourLines(std::span<const double> x, std::span<const double> y,
                                      std::span<const double> values, double level);

/// Returns about `count` round levels strictly inside a range, rising: multiples of 1, 2 or 5 times
/// a power of ten; on a logarithmic scale (from > 0) powers of ten, with 2 and 5 or only with 3
/// between them where there is room.
std::vector<double> contourLevels(double from, double to, bool isLogarithmic, int count);

}  // namespace asperity
