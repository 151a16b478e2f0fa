#include "core/contact/arm_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr int kMostArmPasses = 400;
constexpr double kSlowPeriods =
    1e5;  // memory in periods beyond which a period's change is rounding

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

/// Unknowns: the depth (where the force is given) and what each arm has yielded.
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
        high_(load > 0 ? low_ + line_.meanRise : depth) {
    for (const double inverse : memory_.inverse) {
      const double periods = line_.length * inverse;  // slid, per memory
      change_.push_back(-std::expm1(-periods));
      slowness_.push_back(periods * std::exp(-periods) / change_.back());
    }
  }

  ArmBalance run(const ArmBalance* guess) {
    start(guess);
    Vector residual = evaluate(unknown_);
    remember();
    resetSlope();
    int stalled = 0;
    while (passes_ < kMostArmPasses && worst_ > kWantedResidual && stalled < 4) {
      const Vector from = unknown_, before = residual;
      const double worstBefore = worst_;
      Vector step = stepFor(residual);
      limit(step);
      for (std::size_t i = 0; i < size_; ++i) unknown_[i] = from[i] + step[i];
      residual = evaluate(unknown_);
      learn(step, before, residual);
      // Much worse: what was learnt holds no more.
      if (!(worst_ < 10 * worstBefore)) retreat(from, before, worstBefore, residual);
      const bool closer = worst_ < bestWorst_;
      if (closer) remember();
      stalled = closer || bestWorst_ > kAcceptedResidual ? 0 : stalled + 1;
    }
    best_.force.passes = passes_;
    return best_;
  }

 private:
  double depthOf(const Vector& unknown) const { return first_ > 0 ? unknown[0] : fixedDepth_; }

  void start(const ArmBalance* guess) {
    if (guess && guess->yield.size() == memory_.arms()) {
      if (first_ > 0) unknown_[0] = std::clamp(guess->force.depth, low_, high_);
      std::copy(guess->yield.begin(), guess->yield.end(), unknown_.begin() + first_);
      return;
    }
    const double mean = first_ > 0 ? low_ : std::max(fixedDepth_ - line_.meanRise, 0.0);
    if (first_ > 0) unknown_[0] = high_;
    for (std::size_t i = 0; i < memory_.arms(); ++i)
      unknown_[i + first_] =
          slowness_[i] * mean + (1 - slowness_[i]) * (first_ > 0 ? high_ : fixedDepth_);
  }

  /// Residuals in m: missing mean depth first, then how far each arm is from where it closes.
  Vector evaluate(const Vector& unknown) {
    const double depth = depthOf(unknown), length = line_.length;
    const std::span<const double> yield(unknown.data() + first_, memory_.arms());
    pass_.run(depth, yield);
    ++passes_;
    const StateSums& sums = pass_.sums();
    const double mean = sums.depth / length, wanted = first_ > 0 ? load_ / length : mean;
    stiffness_ = sums.stiffness / length;
    Vector residual(size_);
    closure_ = 0;
    const double scale = std::max(std::abs(mean), std::numeric_limits<double>::min());
    if (first_ > 0) residual[0] = mean - wanted;
    for (std::size_t i = 0; i < memory_.arms(); ++i) {
      const double missing = pass_.yieldChange()[i] / change_[i];
      closure_ = std::max(closure_, std::abs(missing) / scale);
      residual[i + first_] = missing - slowness_[i] * (mean - wanted);
    }
    forceResidual_ = first_ > 0 ? std::abs(residual[0]) / wanted : 0;
    worst_ = std::max(forceResidual_, closure_);
    if (!(worst_ >= 0)) worst_ = std::numeric_limits<double>::infinity();
    return residual;
  }

  void remember() {
    bestWorst_ = worst_;
    best_.force.depth = depthOf(unknown_);
    best_.force.residual = forceResidual_;
    best_.closure = closure_;
    best_.yield.assign(unknown_.begin() + first_, unknown_.end());
  }

  /// The inverse Jacobian as if arms and depth did not know of each other, but for fast arms, which
  /// yield with the depth.
  void resetSlope() {
    inverse_.assign(size_ * size_, 0);
    for (std::size_t i = first_; i < size_; ++i) inverse_[i * size_ + i] = -1;
    if (first_ == 0) return;
    const double perDepth = 1 / std::max(stiffness_, 1e-12);
    inverse_[0] = perDepth;
    for (std::size_t i = 0; i < memory_.arms(); ++i)
      inverse_[(i + 1) * size_] = (1 - slowness_[i]) * perDepth;
  }

  Vector stepFor(const Vector& residual) const {
    Vector step(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < size_; ++k) step[i] -= inverse_[i * size_ + k] * residual[k];
    return step;
  }

  /// Depths stay where a force can be carried; yields above nothing and below the depth.
  void limit(Vector& step) const {
    double part = 1;
    if (first_ > 0) {
      const double depth = unknown_[0];
      if (depth + step[0] > high_ && step[0] > 0)
        part = std::min(part, 0.9 * (high_ - depth) / step[0]);
      if (depth + step[0] < low_ && step[0] < 0)
        part = std::min(part, 0.9 * (low_ - depth) / step[0]);
    }
    if (!(part > 0)) part = 0.1;
    for (double& each : step) each *= part;
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

  void retreat(const Vector& from, const Vector& before, double worstBefore, Vector& residual) {
    Vector step(size_);
    resetSlope();
    for (std::size_t i = 0; i < size_; ++i) step[i] = 0.25 * (unknown_[i] - from[i]);
    for (std::size_t i = 0; i < size_; ++i) unknown_[i] = from[i] + step[i];
    residual = evaluate(unknown_);
    if (worst_ < 10 * worstBefore) return;
    unknown_ = from;
    residual = before;
    worst_ = worstBefore;
  }

  const TravelLine& line_;
  const ArmMemory& memory_;
  ArmPass& pass_;
  double load_, fixedDepth_;
  std::size_t first_, size_;
  Vector unknown_, inverse_;
  double low_, high_;  // m, of the depth
  Vector change_;      // 1 - exp(-L / c_i)
  Vector slowness_;    // 1 for an arm that hardly changes in a period, 0 for one that forgets it
  double stiffness_ = 0, forceResidual_ = 0, closure_ = 0, worst_ = 0, bestWorst_ = 0;
  int passes_ = 0;
  ArmBalance best_;
};

ArmSolver::ArmSolver(const TravelLine& line, const ElementLaw& law, const RetardationModes& modes,
                     double velocity)
    : line_(line),
      memory_(law, modes, velocity, line.spacing, line.length, line.blocks.size()),
      pass_(line, memory_) {}

ArmBalance ArmSolver::atLoad(double load, const ArmBalance* guess) {
  return Search(*this, load, 0).run(guess);
}

ArmBalance ArmSolver::atDepth(double depth, const ArmBalance* guess) {
  return Search(*this, 0, depth).run(guess);
}

StateSums ArmSolver::state(const ArmBalance& balance, ArmShape* shape) {
  pass_.runForState(balance.force.depth, balance.yield, shape);
  return pass_.sums();
}

}  // namespace asperity
