// Where to start: the indentation of a line at rest, looked up in its blocks. Pure functions.
#pragma once

#include <stop_token>

#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// A depth (m) close to that which carries the load (m^2, per 4G) at rest, of resolved lines.
/// Sliding carries more. Where `stop` is requested any depth comes back, soon.
double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop = {});

}  // namespace asperity
