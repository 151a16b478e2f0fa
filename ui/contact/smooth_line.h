// A rigid line as the smooth curve it is: sampled between its nodes where they are sparse, thinned
// where they crowd. Pure; any thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/line.h"
#include "ui/draw/shapes.h"

namespace asperity {

struct LinePoint {
  double x = 0;       // m
  double height = 0;  // m
};

/// One period from x = 0 to x = length, both included: every node, and between two nodes the cubic
/// with the node's heights and slopes (corners stay corners), at equal distances, so that there are
/// at least `atLeast` points. A line without slopes is straight between its nodes.
std::vector<LinePoint> sampledLine(const Line& line, std::size_t atLeast);

/// The lowest and the highest of each pixel column, in their order; both ends are kept. x ascends.
std::vector<Place> thinned(const std::vector<Place>& places);

}  // namespace asperity
