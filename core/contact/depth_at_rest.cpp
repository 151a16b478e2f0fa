#include "core/contact/depth_at_rest.h"

#include <algorithm>
#include <cmath>

#include "core/contact/kernels/pass_sums.h"

namespace asperity {
namespace {

/// Force at rest, looked up in the blocks: those above the depth carry nothing, those below it
/// their mean, and only those that it cuts are opened. Single segments count by their mean.
ForceSums forceAtRest(const PreparedProfile& line, double depth) {
  ForceSums sums;
  const auto carry = [&](const SegmentBounds& block, double length) {
    if (depth * length <= block.riseIntegral) return;
    sums.depth += depth * length - block.riseIntegral;
    sums.stiffness += length;
  };
  const std::size_t top = line.blocks.size() - 1;
  std::size_t level = top;
  for (std::size_t i = 0, end = line.segments() - 2; i < end;) {
    const std::size_t size = std::size_t{1} << (2 * level), block = i >> (2 * level);
    const bool fits = (i & (size - 1)) == 0 && block < line.blockCount(level);
    const SegmentBounds bounds = line.block(level, fits ? block : 0);
    if (fits && (level == 0 || depth <= bounds.lowest || depth >= bounds.highest)) {
      if (depth > bounds.lowest) carry(bounds, line.spacing * static_cast<double>(size));
      i += size;
      level = std::min(level + 1, top);
    } else {
      --level;
    }
  }
  return sums;
}

}  // namespace

double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop) {
  constexpr int kMostSteps = 12;
  constexpr double kCloseEnough = 1e-3;
  double depth = load / line.length + line.meanRise;
  for (int step = 0; step < kMostSteps && !stop.stop_requested(); ++step) {
    const ForceSums sums = forceAtRest(line, depth);
    if (!(sums.depth > 0)) break;
    // Newton's step in the logarithms, in which the force is nearly straight.
    const double next =
        depth * std::exp(std::log(load / sums.depth) * sums.depth / (sums.stiffness * depth));
    const bool close = std::abs(next - depth) <= kCloseEnough * depth;
    depth = next;
    if (close) break;
  }
  return depth;
}

}  // namespace asperity
