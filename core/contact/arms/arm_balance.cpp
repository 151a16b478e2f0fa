#include "core/contact/arms/arm_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr int kMostArmPasses = 200;
constexpr double kQuasiNewtonBelow =
    1e-3;  // relative residual from which on slopes are only kept up
constexpr double kSlowPeriods =
    1e5;  // memory in periods beyond which a period's change is rounding

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

/// Unknowns: the depth (where the force is given) and each arm's strain.
class ArmSolver::Search {
 public:
  Search(ArmSolver& solver, double load, double depth)
      : line_(solver.line_),
        memory_(solver.memory_),
        pass_(solver.pass_),
        load_(load),
        fixedDepth_(depth),
        first_(load > 0 ? 1 : 0),
        size_(memory_.arms() + first_),
        unknown_(size_),
        low_(load / line_.length),
        high_(load > 0 ? low_ + line_.meanRise : depth),
        tangent_(memory_) {
    for (const double inverse : memory_.inverse) {
      const double periods = line_.length * inverse;  // slid, per memory
      change_.push_back(-std::expm1(-periods));
      slowness_.push_back(periods * std::exp(-periods) / change_.back());
    }
    forget();
  }

  ArmBalance run(const ArmBalance* guess) {
    if (tryComplete()) return best_;
    start(guess);
    Vector residual = evaluate(unknown_, &tangent_);
    bool fresh = true;  // the slope is that of this very pass
    int stalled = 0;
    if (!factor()) return best_;
    while (passes_ < kMostArmPasses && bestWorst_ > kWantedResidual && stalled < kPatience) {
      const Vector from = unknown_, before = residual;
      const double worstBefore = worst_;
      Vector step = stepFor(residual);
      limit(step);
      move(from, step);
      const bool exact = !(worstBefore < kQuasiNewtonBelow);
      residual = evaluate(unknown_, exact ? &tangent_ : nullptr);
      const bool good = worst_ < 0.5 * worstBefore;
      stalled = good || bestWorst_ > kAcceptedResidual ? 0 : stalled + 1;
      if (!good && fresh && bestWorst_ > kAcceptedResidual)
        shorten(from, step, worstBefore, residual);
      fresh = exact || !good;
      if (!exact && !good && bestWorst_ > kWantedResidual) residual = evaluate(unknown_, &tangent_);
      if (fresh)
        factor();
      else
        learn(step, before, residual);
    }
    return best_;
  }

 private:
  /// Complete contact: depth and strains are known, up to what slow arms lose to rounding. A pass
  /// says whether it is.
  bool tryComplete() {
    const double depth = first_ > 0 ? high_ : fixedDepth_;
    if (depth < *std::max_element(line_.rise.begin(), line_.rise.end())) return false;
    if (first_ > 0) unknown_[0] = depth;
    pass_.completeStrains({unknown_.data() + first_, memory_.arms()});
    for (int i = 0; i < 3; ++i) {
      const Vector residual = evaluate(unknown_, nullptr);
      if (!pass_.wasComplete()) break;
      if (bestWorst_ <= kWantedResidual) return best_.isComplete = true;
      for (std::size_t k = first_; k < size_; ++k) unknown_[k] -= residual[k];
    }
    forget();
    return false;
  }

  /// No answer yet: one that is not met, with a strain for every arm, is what a search ends with
  /// that never leaves the numbers that are none.
  void forget() {
    bestWorst_ = std::numeric_limits<double>::infinity();
    best_ = {};
    best_.force.residual = best_.periodicityError = bestWorst_;
    best_.strain.assign(memory_.arms(), 0);
  }

  void move(const Vector& from, const Vector& step) {
    for (std::size_t i = 0; i < size_; ++i) unknown_[i] = from[i] + step[i];
  }

  /// Newton's step, but not so long that it leads away.
  void shorten(const Vector& from, Vector& step, double worstBefore, Vector& residual) {
    for (int i = 0; i < 12 && !(worst_ < worstBefore); ++i) {
      for (double& each : step) each *= 0.35;
      move(from, step);
      residual = evaluate(unknown_, &tangent_);
    }
  }

  double depthOf(const Vector& unknown) const { return first_ > 0 ? unknown[0] : fixedDepth_; }

  void start(const ArmBalance* guess) {
    if (guess && guess->strain.size() == memory_.arms()) {
      if (first_ > 0) unknown_[0] = std::clamp(guess->force.depth, low_, high_);
      std::copy(guess->strain.begin(), guess->strain.end(), unknown_.begin() + first_);
      return;
    }
    if (first_ > 0) unknown_[0] = high_;
    const double aboveMean = first_ > 0 ? line_.meanRise : std::min(fixedDepth_, line_.meanRise);
    for (std::size_t i = 0; i < memory_.arms(); ++i)
      unknown_[i + first_] = slowness_[i] * aboveMean;
  }

  /// Residuals in m: missing mean depth first, then how far each arm is from where it closes.
  Vector evaluate(const Vector& unknown, ArmTangent* tangent) {
    const double depth = depthOf(unknown), length = line_.length;
    const std::span<const double> strain(unknown.data() + first_, memory_.arms());
    pass_.run(depth, strain, tangent);
    ++passes_;
    const StateSums& sums = pass_.sums();
    const double mean = sums.depth / length, wanted = first_ > 0 ? load_ / length : mean;
    Vector residual(size_);
    closure_ = 0;
    const double scale = scaleOf(mean, strain);
    if (first_ > 0) residual[0] = mean - wanted;
    for (std::size_t i = 0; i < memory_.arms(); ++i) {
      const double missing = pass_.yieldChange()[i] / change_[i];
      // What is no number must not pass for closed: a maximum would skip it.
      const double share = std::abs(missing) / scale;
      closure_ = std::max(closure_, share >= 0 ? share : std::numeric_limits<double>::infinity());
      residual[i + first_] = missing;
    }
    forceResidual_ = first_ > 0 ? std::abs(residual[0]) / wanted : 0;
    worst_ = std::max(forceResidual_, closure_);
    if (!(worst_ >= 0)) worst_ = std::numeric_limits<double>::infinity();
    if (worst_ < bestWorst_) remember();
    best_.force.passes = passes_;
    return residual;
  }

  /// What a change of strain is measured by (m): what friction comes from, strains and heights,
  /// but at light loads the depth.
  double scaleOf(double mean, std::span<const double> strain) const {
    double scale = line_.meanRise;
    for (const double each : strain) scale = std::max(scale, std::abs(each));
    return std::max(std::min(scale, std::abs(mean)), std::numeric_limits<double>::min());
  }

  void remember() {
    bestWorst_ = worst_;
    best_.force.depth = depthOf(unknown_);
    best_.force.residual = forceResidual_;
    best_.periodicityError = closure_;
    best_.strain.assign(unknown_.begin() + first_, unknown_.end());
  }

  /// The inverse Jacobian from the derivatives of the last pass, by elimination with row pivots;
  /// false where it has none.
  bool factor() {
    const std::size_t n = size_, skipped = 1 - first_;
    Vector slope(n * n);
    for (std::size_t k = 0; k < n; ++k) {
      if (first_ > 0) slope[k] = tangent_.ofDepthIntegral(k) / line_.length;
      for (std::size_t i = 0; i < memory_.arms(); ++i)
        slope[(i + first_) * n + k] = tangent_.ofYieldChange(i, k + skipped) / change_[i];
    }
    inverse_.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) inverse_[i * n + i] = 1;
    for (std::size_t c = 0; c < n; ++c) {
      std::size_t pivot = c;
      for (std::size_t i = c + 1; i < n; ++i)
        if (std::abs(slope[i * n + c]) > std::abs(slope[pivot * n + c])) pivot = i;
      if (!(std::abs(slope[pivot * n + c]) > 0)) return false;
      for (std::size_t k = 0; k < n; ++k) {
        if (pivot == c) break;
        std::swap(slope[c * n + k], slope[pivot * n + k]);
        std::swap(inverse_[c * n + k], inverse_[pivot * n + k]);
      }
      const double scale = 1 / slope[c * n + c];
      for (std::size_t k = 0; k < n; ++k) {
        slope[c * n + k] *= scale;
        inverse_[c * n + k] *= scale;
      }
      for (std::size_t i = 0; i < n; ++i) {
        const double part = slope[i * n + c];
        if (i == c || part == 0) continue;
        for (std::size_t k = 0; k < n; ++k) {
          slope[i * n + k] -= part * slope[c * n + k];
          inverse_[i * n + k] -= part * inverse_[c * n + k];
        }
      }
    }
    return true;
  }

  Vector stepFor(const Vector& residual) const {
    Vector step(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < size_; ++k) step[i] -= inverse_[i * size_ + k] * residual[k];
    return step;
  }

  /// Depths stay where a force can be carried, to rounding.
  void limit(Vector& step) const {
    if (first_ == 0) return;
    const double depth = unknown_[0], slack = 1e-9 * high_;
    const double next = depth + step[0];
    if (next > high_ + slack) step[0] = high_ - depth;
    if (next < low_ - slack) step[0] = 0.9 * (low_ - depth);
  }

  /// Broyden's update of the inverse.
  void learn(const Vector& step, const Vector& before, const Vector& after) {
    Vector change(size_), predicted(size_), row(size_);
    for (std::size_t i = 0; i < size_; ++i) change[i] = after[i] - before[i];
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < size_; ++k) {
        predicted[i] += inverse_[i * size_ + k] * change[k];
        row[k] += step[i] * inverse_[i * size_ + k];
      }
    const double scale = dot(step, predicted);
    if (!(std::abs(scale) > 1e-6 * dot(step, step))) return;
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < size_; ++k)
        inverse_[i * size_ + k] += (step[i] - predicted[i]) * row[k] / scale;
  }

  const PreparedProfile& line_;
  const ArmCoefficients& memory_;
  ArmPass& pass_;
  double load_, fixedDepth_;
  std::size_t first_, size_;
  Vector unknown_, inverse_;
  double low_, high_;  // m, of the depth
  Vector change_;      // 1 - exp(-L / c_i)
  Vector slowness_;    // 1 for an arm that hardly changes in a period, 0 for one that forgets it
  ArmTangent tangent_;
  double forceResidual_ = 0, closure_ = 0, worst_ = 0;
  double bestWorst_ = 0;
  int passes_ = 0;
  ArmBalance best_;
};

ArmSolver::ArmSolver(const PreparedProfile& line, const ElementLaw& law,
                     const RetardationModes& modes, double velocity)
    : line_(line),
      memory_(law, modes, velocity, line.spacing, line.length, line.blocks.size()),
      pass_(line, memory_) {}

ArmBalance ArmSolver::atLoad(double load, const ArmBalance* guess) {
  return Search(*this, load, 0).run(guess);
}

ArmBalance ArmSolver::atDepth(double depth, const ArmBalance* guess) {
  return Search(*this, 0, depth).run(guess);
}

bool ArmSolver::isContactComplete(double depth) {
  Vector strain(memory_.arms());
  pass_.completeStrains(strain);
  pass_.run(depth, strain);
  return pass_.wasComplete();
}

double ArmSolver::completeAbove() {
  double low = 0, high = 2 * line_.meanRise;
  while (high > 0 && !isContactComplete(high)) high *= 2;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (isContactComplete(middle) ? high : low) = middle;
  }
  return high;
}

StateSums ArmSolver::state(const ArmBalance& balance, ArmShape* shape) {
  pass_.runForState(balance.force.depth, balance.strain, shape);
  return pass_.sums();
}

}  // namespace asperity
