#include "core/surface/line.h"

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

Line blankLine(double length, std::size_t nodes) {
  Line line;
  line.length = length;
  line.spacing = length / static_cast<double>(nodes);
  line.height.resize(nodes);
  line.slopeAfter.resize(nodes);
  return line;
}

/// Makes a line that is symmetric about the node in the middle, from height(|x|) and slope(|x|).
/// Where the slope does not vanish, the middle and the end of the period are corners.
template <class Height, class Slope>
Line evenLine(double length, std::size_t nodes, Height height, Slope slope) {
  Line line = blankLine(length, nodes);
  line.slopeBefore.resize(nodes);
  const std::size_t tip = nodes / 2;
  for (std::size_t k = 0; k < nodes; ++k) {  // k nodes right of the tip, once around
    const std::size_t i = (tip + k) % nodes;
    const bool left = 2 * k >= nodes;
    const double distance = line.spacing * static_cast<double>(left ? nodes - k : k);
    line.height[i] = height(distance);
    line.slopeAfter[i] = left ? -slope(distance) : slope(distance);
    line.slopeBefore[i] = line.slopeAfter[i];
    if (k == 0) line.slopeBefore[i] = -slope(0);
    if (2 * k == nodes) line.slopeBefore[i] = slope(distance);
  }
  return line;
}

}  // namespace

Line sineLine(double length, std::size_t nodes, double amplitude, std::int64_t waves) {
  Line line = blankLine(length, nodes);
  const double wave = 2 * std::numbers::pi * static_cast<double>(waves) / length;
  for (std::size_t i = 0; i < nodes; ++i) {
    // The phase is reduced in whole numbers, so every wave is the same to the last bit.
    const auto turn = static_cast<double>(i * static_cast<std::size_t>(waves) % nodes);
    const double phase = 2 * std::numbers::pi * turn / static_cast<double>(nodes);
    line.height[i] = amplitude * std::cos(phase);
    line.slopeAfter[i] = -amplitude * wave * std::sin(phase);
  }
  line.rmsHeight = amplitude / std::numbers::sqrt2;
  line.rmsSlope = amplitude * wave / std::numbers::sqrt2;
  return line;
}

Line wedgeLine(double length, std::size_t nodes, double slope) {
  Line line = evenLine(
      length, nodes, [slope](double x) { return slope * x; }, [slope](double) { return slope; });
  line.rmsHeight = slope * length / (4 * std::sqrt(3.0));
  line.rmsSlope = slope;
  return line;
}

Line parabolaLine(double length, std::size_t nodes, double radius) {
  Line line = evenLine(
      length, nodes, [radius](double x) { return x * x / (2 * radius); },
      [radius](double x) { return x / radius; });
  line.rmsHeight = length * length / (12 * radius * std::sqrt(5.0));
  line.rmsSlope = length / (2 * radius * std::sqrt(3.0));
  return line;
}

}  // namespace asperity
