// One period of a rigid line, as its nodes and the slopes on either side of them. A plain value;
// between two nodes the line is whatever the scheme makes of it (core/contact/line/prepared_profile.h).
#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

struct Line {
  double length = 0;           // m, period
  double spacing = 0;          // m, between neighbouring nodes; node i stands at x = i * spacing
  std::vector<double> height;  // m, n nodes; the rigid body is above, so low nodes touch first
  std::vector<double> slopeAfter;   // dz/dx just right of each node, n
  std::vector<double> slopeBefore;  // dz/dx just left of each node, n; empty: the same (no corners)
  double rmsHeight = 0;  // m, of the whole line, from its exact description (spectrum or formula)
  double rmsSlope = 0;   // likewise (ISO Rdq)

  std::size_t nodes() const { return height.size(); }
  double slopeLeftOf(std::size_t node) const {
    return slopeBefore.empty() ? slopeAfter[node] : slopeBefore[node];
  }
};

}  // namespace asperity
