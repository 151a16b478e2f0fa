#include "core/contact/force_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/kernels/pass.h"

namespace asperity {

namespace {

constexpr int kMaxPasses = 200;       // over the line in one balance
constexpr int kMaxStalledPasses = 2;  // without a smaller residual, until the best one is taken

}  // namespace

void ForceBalance::start(const PreparedProfile& line, double load, double guess) {
  load_ = load;
  // At a given depth complete contact carries the smallest load, so the root is not beyond its
  // depth.
  low_ = load / line.length;
  high_ = complete_ = low_ + line.meanHeight;
  depth_ = guess > low_ && guess < high_ ? guess : high_;
  triedComplete_ = depth_ == high_;
  residual_ = std::numeric_limits<double>::infinity();
  passes_ = stalled_ = 0;
  done_ = false;
}

void ForceBalance::take(const PassSums& sums) {
  ++passes_;
  const double residual = std::abs(sums.depth - load_) / load_;
  const bool closer = residual < residual_;
  stalled_ = closer ? 0 : stalled_ + (residual_ < kAcceptedResidual ? 1 : 0);
  if (closer) {
    residual_ = residual;
    bestDepth_ = depth_;
    bestSums_ = sums;
  }
  (sums.depth > load_ ? high_ : low_) = depth_;
  done_ = residual_ <= kTargetResidual || stalled_ >= kMaxStalledPasses || passes_ >= kMaxPasses;
  if (!done_) move(sums);
}

/// Chooses the next depth.
void ForceBalance::move(const PassSums& sums) {
  constexpr double kRoundedStep = 1e-9;
  const Pass pass{std::log1p((sums.depth - load_) / load_), sums.depth / (sums.stiffness * depth_),
                  depth_};
  // The first step is Newton's in logarithms; later ones use the cubic of ln d over ln F_N through
  // the last two passes and their slopes, evaluated at the target force.
  double step = -pass.excess * pass.slope;
  const double gap = last_.excess - pass.excess;
  if (passes_ > 1 && gap != 0) {
    const double t = -pass.excess / gap;
    const double climb = std::log1p((last_.depth - pass.depth) / pass.depth);
    const bool isBetween = std::abs(t) < 1;
    const double cubic = isBetween ? hermiteRise(t, climb, gap, pass.slope, last_.slope) : step;
    if (std::isfinite(cubic)) step = cubic;
  }
  last_ = pass;
  double next = depth_ * (1 + std::expm1(step));
  // Near the end, rounding of the force may have moved the bracket away from the solution.
  const bool isLast = std::abs(step) < kRoundedStep;
  if (!isLast && !(next >= low_ && next <= high_)) next = 0.5 * (low_ + high_);
  // In complete contact the force is linear.
  const double newton = depth_ - (sums.depth - load_) / sums.stiffness;
  if (!triedComplete_ && std::abs(newton / complete_ - 1) < kRoundedStep) next = complete_;
  triedComplete_ |= next == complete_;
  done_ = next == depth_;
  depth_ = next;
}

Balance balanceResolved(const PreparedProfile& line, double relaxationLength, double load) {
  ForceBalance balance;
  balance.start(line, load, 0);
  while (!balance.isDone())
    balance.take(resolvedPass(line, balance.depth(), relaxationLength, Output::Force));
  return balance.balance();
}

namespace {

/// Searches for the indentation that complete contact of the line needs: p / 4G = d - z - c dz/ds >
/// 0.
class CompleteContactDepth {
 public:
  CompleteContactDepth(const PreparedProfile& line, double relaxationLength, double known)
      : line_(line), relaxationLength_(relaxationLength), maximum_(known) {}

  double maximum() const { return maximum_; }

  /// Returns whether the depth suffices; ends at the first place that needs more.
  bool isEnough() const {
    return requiredDepth(0) < maximum_ && requiredDepth(line_.segments() - 1) < maximum_ &&
           line_.forLargestBlocks(
               [this](std::size_t level, std::size_t block) { return isEnoughFor(level, block); });
  }

  /// Continues to the largest necessary depth.
  void findMaximum() {
    maximum_ = std::max({maximum_, requiredDepth(0), requiredDepth(line_.segments() - 1)});
    line_.forLargestBlocks([this](std::size_t level, std::size_t block) {
      findMaximum(level, block);
      return true;
    });
  }

 private:
  bool isBounded(std::size_t level, std::size_t block) const {
    const SegmentBounds bounds = line_.block(level, block);
    return bounds.highest + relaxationLength_ * bounds.steepest < maximum_;
  }

  bool isEnoughFor(std::size_t level, std::size_t block) const {
    if (isBounded(level, block)) return true;
    if (level == 0) return requiredDepth(block + 1) < maximum_;
    for (std::size_t i = 0; i < 4; ++i)
      if (!isEnoughFor(level - 1, 4 * block + i)) return false;
    return true;
  }

  void findMaximum(std::size_t level, std::size_t block) {
    if (isBounded(level, block)) return;
    if (level == 0) {
      maximum_ = std::max(maximum_, requiredDepth(block + 1));
      return;
    }
    for (std::size_t i = 0; i < 4; ++i) findMaximum(level - 1, 4 * block + i);
  }

  double requiredDepth(std::size_t i) const {
    const Cubic z = line_.segment(i);
    const double k = relaxationLength_ / line_.segmentLength(i);
    const Cubic need{z.c0 + k * z.c1, z.c1 + 2 * k * z.c2, z.c2 + 3 * k * z.c3, z.c3};
    double most = std::max(need(0), need(1));
    for (const double t : stationaryPoints(need)) most = std::max(most, need(t));
    return most;
  }

  const PreparedProfile& line_;
  double relaxationLength_, maximum_;
};

/// Returns the force at rest from the blocks: blocks above the depth carry nothing, blocks below it
/// their mean, and only those that it cuts are divided. Single segments count with their mean.
PassSums forceAtRest(const PreparedProfile& line, double depth) {
  PassSums sums;
  const auto carry = [&](const SegmentBounds& block, double length) {
    if (depth * length <= block.heightIntegral) return;
    sums.depth += depth * length - block.heightIntegral;
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

bool isContactComplete(const PreparedProfile& line, double depth, double relaxationLength) {
  return CompleteContactDepth(line, relaxationLength, depth).isEnough();
}

double completeAbove(const PreparedProfile& line, double relaxationLength) {
  CompleteContactDepth needed(line, relaxationLength, 0);
  needed.findMaximum();
  return needed.maximum();
}

PassSums completeContactSums(const PreparedProfile& line, double depth, double relaxationLength) {
  PassSums sums;
  // Over the period the dashpots add as much negative as positive pressure.
  sums.depth = sums.pressure = (depth - line.meanHeight) * line.length;
  sums.work = sums.dissipation = relaxationLength * line.slopeSquaredIntegral;
  sums.stiffness = sums.contactLength = line.length;
  sums.slopeSquared = line.slopeSquaredIntegral;
  return sums;
}

double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop) {
  constexpr int kMaxSteps = 12;
  constexpr double kCloseEnough = 1e-3;
  double depth = completeContactDepth(line, load);
  for (int step = 0; step < kMaxSteps && !stop.stop_requested(); ++step) {
    const PassSums sums = forceAtRest(line, depth);
    if (!(sums.depth > 0)) break;
    // This is Newton's step in logarithms, in which the force is nearly straight.
    const double next =
        depth * std::exp(std::log(load / sums.depth) * sums.depth / (sums.stiffness * depth));
    const bool close = std::abs(next - depth) <= kCloseEnough * depth;
    depth = next;
    if (close) break;
  }
  return depth;
}

}  // namespace asperity
