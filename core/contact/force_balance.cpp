#include "core/contact/force_balance.h"

#include <cmath>
#include <limits>

#include "core/contact/kernels/resolved_pass.h"

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

}  // namespace asperity
