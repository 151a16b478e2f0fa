// The sequence of Sobol (USSR Comput. Math. Math. Phys. 7(4), 86, 1967) with the direction numbers
// of Joe and Kuo: points that fill a cube of many dimensions evenly. Pure; any thread.
#pragma once

#include <cstdint>

namespace asperity {

inline constexpr int kMaxSobolDimensions = 64;

/// Returns one coordinate of a point, times 2^32. The points are in the order of Gray codes, in
/// which the first 2^m of them are, for every m, the same set as in the original order. 0 <=
/// dimension < kMaxSobolDimensions. No earlier point is needed, so every process makes the same
/// points.
std::uint32_t sobolNumber(std::uint32_t index, int dimension);

}  // namespace asperity
