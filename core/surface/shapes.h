// Lines given by a formula: sine, wedge, parabola. Pure functions; the lowest point of wedge and
// parabola is the node in the middle, or next to it where the number of nodes is odd.
#pragma once

#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

/// z = amplitude cos(2 pi waves x / length).
Line sineLine(double length, std::size_t nodes, double amplitude, std::int64_t waves);

/// z = slope |x|.
Line wedgeLine(double length, std::size_t nodes, double slope);

/// z = x^2 / (2 radius).
Line parabolaLine(double length, std::size_t nodes, double radius);

}  // namespace asperity
