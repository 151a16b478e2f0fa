// A measured surface as a plain value: heights on a uniform grid. Each row of the grid is one
// profile along the direction that the file calls x; the rows follow each other along y.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/statistics.h"

namespace asperity {

/// The height where nothing was measured.
inline constexpr double kMissingHeight = kNaN;

struct Topography {
  std::int64_t columns = 0;  // points of one profile along x
  std::int64_t rows = 0;     // profiles; 1: a single profile
  double columnSpacing = 0;  // m, between neighbours along x
  double rowSpacing = 0;     // m, between neighbours along y; 0: a single profile, or not known
  std::vector<double>
      height;  // m, rows x columns, row by row; kMissingHeight where nothing was measured

  bool isProfile() const { return rows == 1; }
  double length() const { return static_cast<double>(columns) * columnSpacing; }  // m, along x
  double width() const { return static_cast<double>(rows) * rowSpacing; }         // m, along y

  /// Returns the heights along x of row `number`, counted from 0; they are `columns` many.
  std::span<const double> row(std::int64_t number) const {
    return std::span(height).subspan(static_cast<std::size_t>(number * columns),
                                     static_cast<std::size_t>(columns));
  }
  /// Returns one height, m. Row and column are counted from 0.
  double at(std::int64_t rowNumber, std::int64_t column) const {
    return height[static_cast<std::size_t>(rowNumber * columns + column)];
  }
};

/// Returns the topography with rows and columns exchanged: its profiles run along y.
inline Topography transposed(const Topography& topography) {
  Topography turned;
  turned.columns = topography.rows;
  turned.rows = topography.columns;
  turned.columnSpacing = topography.rowSpacing;
  turned.rowSpacing = topography.columnSpacing;
  turned.height.resize(topography.height.size());
  const auto columns = static_cast<std::size_t>(topography.columns);
  const auto rows = static_cast<std::size_t>(topography.rows);
  // The work goes block by block, so that both sides stay in the cache.
  constexpr std::size_t kBlock = 32;
  for (std::size_t firstRow = 0; firstRow < rows; firstRow += kBlock)
    for (std::size_t firstColumn = 0; firstColumn < columns; firstColumn += kBlock)
      for (std::size_t row = firstRow; row < std::min(firstRow + kBlock, rows); ++row)
        for (std::size_t column = firstColumn; column < std::min(firstColumn + kBlock, columns);
             ++column)
          turned.height[column * rows + row] = topography.height[row * columns + column];
  return turned;
}

}  // namespace asperity
