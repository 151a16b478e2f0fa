// Where to start: the indentation of a line at rest, looked up in its blocks. Pure functions.
#pragma once

#include "core/contact/travel_line.h"

namespace asperity {

/// A depth (m) close to that which carries the load (m^2, per 4G) at rest, of resolved lines.
/// Sliding carries more.
double depthAtRest(const TravelLine& line, double load);

}  // namespace asperity
