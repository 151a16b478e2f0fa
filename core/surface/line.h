// One period of a rigid line as a plain value: its nodes and the slopes on both sides of them.
// Between two nodes the scheme defines the line (core/contact/line/prepared_profile.h). This file
// also makes the lines that are given by a formula.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// Rms height and rms slope of realization 0. All realizations have the same ones, because the
/// amplitudes of the waves are not random. With a summit correlation the slope varies by some per
/// cent, and Line::rmsSlope is that of each line.
struct LineStatistics {
  double rmsHeight = 0;  // m
  double rmsSlope = 0;
};

// Lines given by a formula. Pure functions; the lowest point of wedge and parabola is the node in
// the middle, or next to it where the number of nodes is odd.

/// z = amplitude cos(2 pi waves x / length).
Line sineLine(double length, std::size_t nodes, double amplitude, std::int64_t waves);

/// z = slope |x|.
Line wedgeLine(double length, std::size_t nodes, double slope);

/// z = x^2 / (2 radius).
Line parabolaLine(double length, std::size_t nodes, double radius);

}  // namespace asperity
