// The force balance of one line at one velocity, found pass by pass from outside: whoever runs the
// passes asks for a depth and brings back the sums. A plain value.
#pragma once

#include <cmath>
#include <limits>

#include "core/contact/force_balance.h"
#include "core/contact/kernels/cubic_kernel.h"

namespace asperity {

/// The balance of one line at one velocity and force: the bracket found so far and the best pass.
class StreamBalance {
 public:
  void start(double lowest, double highest, double guess) {
    low_ = lowest;
    high_ = full_ = highest;
    depth_ = guess > lowest && guess < highest ? guess : highest;
    triedFull_ = depth_ == highest;
    best_ = std::numeric_limits<double>::infinity();
    passes_ = stalled_ = 0;
    done_ = false;
  }

  bool isDone() const { return done_; }
  double depth() const { return depth_; }
  double bestDepth() const { return bestDepth_; }
  const PassSums& bestSums() const { return bestSums_; }
  double residual() const { return best_; }
  int passes() const { return passes_; }

  /// Takes what a pass at depth() found; load: m^2, per 4G.
  void take(const PassSums& sums, double load) {
    const double force = sums.depth;
    ++passes_;
    const double residual = std::abs(force - load) / load;
    const bool closer = residual < best_;
    stalled_ = closer ? 0 : stalled_ + (best_ < kAcceptedResidual ? 1 : 0);
    if (closer) {
      best_ = residual;
      bestDepth_ = depth_;
      bestSums_ = sums;
    }
    (force > load ? high_ : low_) = depth_;
    done_ = best_ <= kWantedResidual || stalled_ >= kPatience || passes_ >= kMostPasses;
    if (!done_) move(force, sums.stiffness, load);
  }

 private:
  /// In the logarithms F_N(d) is nearly straight: Newton's step first, then the cubic through the
  /// last two passes and their slopes, read at the wanted force.
  void move(double force, double stiffness, double load) {
    constexpr double kRoundedStep = 1e-9;
    const Pass pass{std::log1p((force - load) / load), force / (stiffness * depth_), depth_};
    double step = -pass.excess * pass.slope;
    if (passes_ > 1) {
      const double gap = last_.excess - pass.excess, t = -pass.excess / gap;
      const double climb = std::log1p((last_.depth - pass.depth) / pass.depth);
      const double cubic = t * t * (3 - 2 * t) * climb +
                           gap * t * (1 - t) * ((1 - t) * pass.slope - t * last_.slope);
      if (std::isfinite(cubic) && std::abs(t) < 1) step = cubic;
    }
    last_ = pass;
    double next = depth_ * (1 + std::expm1(step));
    // Near the end rounding of the force may have put the bracket beside the answer.
    const bool isLast = std::abs(step) < kRoundedStep;
    if (!isLast && !(next >= low_ && next <= high_)) next = 0.5 * (low_ + high_);
    // In full contact the force is linear.
    const double newton = depth_ - (force - load) / stiffness;
    if (!triedFull_ && std::abs(newton / full_ - 1) < kRoundedStep) next = full_;
    triedFull_ |= next == full_;
    done_ = next == depth_;
    depth_ = next;
  }

  struct Pass {
    double excess;  // ln(F / wanted)
    double slope;   // d ln depth / d ln F
    double depth;   // m
  };

  Pass last_{};
  PassSums bestSums_;
  double low_ = 0, high_ = 0, full_ = 0;  // m; full_: the answer in full contact
  double depth_ = 0, bestDepth_ = 0, best_ = 0;
  int passes_ = 0, stalled_ = 0;
  bool done_ = false, triedFull_ = false;
};

}  // namespace asperity
