// One pass over a resolved line (linear or cubic segments) in steady sliding: the running maximum
// with exponential decay of the paper's foundation, with every contact edge inside a segment. O(n),
// no iteration, no time stepping. This is the readable form with which the vector kernels of
// kernels.h are compared. Pure functions; any thread.
//
// Kelvin elements in the rigid line's frame, y = -u, c = v tau: in contact y = w(s) = d - z and
// p / 4G = w + c w', z the height above the line's lowest point; free y decays as exp(-s / c).
// Contact holds while (w e^(s/c))' > 0, so y e^(s/c) is the running maximum of w e^(s/c)
// (Li et al. 2013, Eqs. 1 and 2, without a grid).
#pragma once

#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Runs one pass. depth: indentation below the lowest point (m, > 0). relaxationLength: c = v tau
/// (m, >= 0). shape: filled if not null.
PassSums resolvedPass(const PreparedProfile& line, double depth, double relaxationLength,
                      Output output = Output::Everything, NodeShape* shape = nullptr);

}  // namespace asperity
