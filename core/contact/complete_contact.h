// Contact from the bounds over blocks of a line, without a search for its edges: whether contact is
// complete, depth and friction in complete contact (Li et al. 2013, Eqs. 3 and 8, of the resolved
// line), and the indentation of the line at rest. Complete contact is not guessed: where the bounds
// do not prove it, the segments themselves are examined. Pure functions for elements without arms,
// on linear and cubic segments; any thread; no allocation. relaxationLength: c = v tau (m).
#pragma once

#include <stop_token>

#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Returns whether the pressure is above 0 along the whole line at this depth (m). It is fast in
/// clear cases.
bool isContactComplete(const PreparedProfile& line, double depth, double relaxationLength);

/// Returns the depth (m) above which contact is complete: max(z + c dz/ds).
double completeAbove(const PreparedProfile& line, double relaxationLength);

/// Returns the depth (m) at which complete contact carries a load = F_N / 4G (m^2).
inline double completeContactDepth(const PreparedProfile& line, double load) {
  return load / line.length + line.meanHeight;
}

/// Returns the sums of a pass in complete contact at that depth.
PassSums completeContactSums(const PreparedProfile& line, double depth, double relaxationLength);

/// Returns a depth (m) close to the one that carries the load (m^2, per 4G) at rest. Sliding
/// carries more. Where `stop` is requested, it soon returns any depth.
double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop = {});

}  // namespace asperity
