#include "core/contact/force_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/kernels/resolved_pass.h"

namespace asperity {
namespace {

/// Newton's iteration with the bracket it has found so far.
class Iteration {
 public:
  Iteration(const PreparedProfile& line, double memory, double load)
      // Full contact is the lightest way to carry a load at a depth: the root is not beyond it.
      : line_(line),
        memory_(memory),
        load_(load),
        low_(load / line.length),
        high_(low_ + line.meanRise) {
    best_.residual = std::numeric_limits<double>::infinity();
  }

  Balance run(double guess) {
    double depth = guess > low_ && guess < high_ ? guess : high_;
    int stalled = 0;
    while (best_.passes < kMostPasses && best_.residual > kWantedResidual && stalled < kPatience) {
      const double next = step(depth, stalled);
      if (next == depth) break;
      depth = next;
    }
    return best_;
  }

 private:
  double step(double depth, int& stalled) {
    const ForceSums sums = forceAt(line_, depth, memory_);
    const double excess = sums.depth - load_;
    ++best_.passes;
    const double residual = std::abs(excess) / load_;
    const bool closer = residual < best_.residual;
    stalled = closer ? 0 : stalled + (best_.residual < kAcceptedResidual ? 1 : 0);
    if (closer) {
      best_.residual = residual;
      best_.depth = depth;
    }
    (excess > 0 ? high_ : low_) = depth;
    const double next = depth - excess / sums.stiffness;
    return next >= low_ && next <= high_ ? next : 0.5 * (low_ + high_);
  }

  const PreparedProfile& line_;
  double memory_, load_, low_, high_;
  Balance best_;
};

}  // namespace

Balance balanceResolved(const PreparedProfile& line, double memoryLength, double load,
                        double guess) {
  return Iteration(line, memoryLength, load).run(guess);
}

}  // namespace asperity
