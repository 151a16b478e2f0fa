#include "core/measured/topography.h"

#include <algorithm>

namespace asperity {

Topography transposed(const Topography& topography) {
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
