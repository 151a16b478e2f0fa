#include "core/measured/byte_reader.h"

#include <cmath>

namespace asperity {

void takeHeights(const SurfaceSource& source, const StoredHeights& stored, Topography& grid) {
  requireSize(source, grid.columns, grid.rows, stored.bytes.size(), stored.type.size);
  grid.height.assign(static_cast<std::size_t>(grid.columns * grid.rows), kMissingHeight);
  for (std::size_t i = 0; i < grid.height.size(); ++i) {
    source.reportPoint(i, grid.height.size());
    const double number = stored.type.read(stored.bytes.substr(i * stored.type.size), stored.order);
    if (stored.gaps.contain(number)) continue;
    if (const double height = number * stored.scale; std::isfinite(height)) grid.height[i] = height;
  }
}

}  // namespace asperity
