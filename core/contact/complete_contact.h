// What the bounds over blocks of a line say about contact without a search for its edges: whether
// everything is in contact, depth and friction where it is (Li et al. 2013, Eqs. 3 and 8, of the
// line as resolved), and the indentation of the line at rest. Complete contact is not guessed:
// where the bounds do not prove it, the segments themselves are looked at.
// Pure functions for elements without arms, on linear and cubic segments; any thread; no
// allocation. relaxationLength: c = v tau (m).
#pragma once

#include <stop_token>

#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Whether pressure is above 0 along the whole line at this depth (m). Cheap where the answer is
/// clear.
bool isContactComplete(const PreparedProfile& line, double depth, double relaxationLength);

/// The depth (m) above which it is: max(z + c dz/ds).
double completeAbove(const PreparedProfile& line, double relaxationLength);

/// The depth (m) at which complete contact carries a load = F_N / 4G (m^2).
inline double completeContactDepth(const PreparedProfile& line, double load) {
  return load / line.length + line.meanHeight;
}

/// What a pass would find in complete contact at that depth.
PassSums completeContactSums(const PreparedProfile& line, double depth, double relaxationLength);

/// A depth (m) close to the one that carries the load (m^2, per 4G) at rest. Sliding carries more.
/// Where `stop` is requested any depth comes back, soon.
double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop = {});

}  // namespace asperity
