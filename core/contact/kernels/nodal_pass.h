// One pass over a line as the paper has it: N separate elements at the nodes, Eq. (2), steady
// sliding. The contact set only grows with the indentation, so F_N(d) rises, but it jumps wherever
// an element enters. Pure functions; any thread.
#pragma once

#include "core/contact/kernels/pass_sums.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

struct NodalState {
  StateSums sums;        // stiffness is that of loaded elements; pressure Eq. (3), work Eq. (4)
  double loaded = 0;     // elements that carry load
  double threshold = 0;  // m, largest indentation below which a loaded element is not loaded
};

/// depth: indentation below the lowest node (m, >= 0; below 0 nothing touches).
/// memoryLength: c = v tau (m, >= 0).
NodalState nodalStateAt(const PreparedProfile& line, double depth, double memoryLength,
                        NodeShape* shape = nullptr);

}  // namespace asperity
