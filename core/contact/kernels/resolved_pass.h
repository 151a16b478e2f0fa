// One pass over a resolved line (linear or cubic segments) in steady sliding: the running minimum
// with exponential forgetting of the paper's foundation, every contact edge inside a segment found.
// O(n), no iteration, no time stepping. Pure functions; any thread.
//
// Kelvin elements in the rigid line's frame, y = -u, c = v tau: in contact y = w(s) = d - rise and
// p / 4G = w + c w'; free y decays as exp(-s / c). Contact holds while (w e^(s/c))' > 0, so
// y e^(s/c) is the running maximum of w e^(s/c) (Li et al. 2013, Eqs. 1 and 2, without a grid).
#pragma once

#include "core/contact/kernels/pass_sums.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// depth: indentation below the lowest point (m, > 0). memoryLength: c = v tau (m, >= 0).
ForceSums forceAt(const PreparedProfile& line, double depth, double memoryLength);

/// The same with everything a result states, and the shape where `shape` is given.
StateSums stateAt(const PreparedProfile& line, double depth, double memoryLength,
                  NodeShape* shape = nullptr);

}  // namespace asperity
