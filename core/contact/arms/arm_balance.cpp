#include "core/contact/arms/arm_balance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/flush_denormals.h"
#include "core/scene/plan.h"

namespace asperity {

std::shared_ptr<const ArmTable> ArmTables::at(double velocity, const PreparedProfile& line) {
  constexpr std::size_t kMaxKept = 256;  // velocities of a curve, with room
  const Key key{velocity, line.spacing, line.length, line.blocks.size()};
  {
    const std::scoped_lock lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
  }
  auto made = std::make_shared<const ArmTable>(law_, modes_, velocity, line);
  const std::scoped_lock lock(mutex_);
  if (known_.size() >= kMaxKept) known_.clear();
  return known_.try_emplace(key, std::move(made)).first->second;
}

namespace {

constexpr int kMaxArmPasses = 200;
/// Below this relative residual only Broyden's update changes the Jacobian.
constexpr double kQuasiNewtonBelow = 1e-3;
/// Below this relative residual the next pass is expected to end the search.
constexpr double kNearlyMet = 1e-6;
/// A residual that may be rounding; and the error of the springs' force, relative to that of the
/// equilibrium, that is negligible.
constexpr double kRoundingResidual = 5e-12, kForceError = 1e-11;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

using Eigen::Index;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

}  // namespace

/// One search. The unknowns are the depth (where the force is given) and each arm's strain.
class ArmSolver::Search {
 public:
  Search(ArmSolver& solver, double load, double depth)
      : line_(solver.line_),
        coefficients_(solver.table_->coefficients),
        vectors_(solver.table_->vectors),
        work_(solver.work_),
        jacobian_(solver.jacobian_),
        load_(load),
        fixedDepth_(depth),
        arms_(static_cast<Index>(coefficients_.arms())),
        first_(load > 0 ? 1 : 0),
        unknown_(Vector::Zero(first_ + arms_)),
        low_(load / line_.length),
        high_(load > 0 ? low_ + line_.meanHeight : depth) {
    for (const double inverse : coefficients_.inverse) {
      const double periods = line_.length * inverse;  // slid in one relaxation length
      change_.push_back(-std::expm1(-periods));
      slowness_.push_back(periods * std::exp(-periods) / change_.back());
    }
    forget();
  }

  ArmBalance run(const ArmBalance* guess) {
    if (tryComplete()) return best_;
    start(guess);
    Vector residual = evaluate();
    bool fresh = true;  // the Jacobian is that of this very pass
    if (!factorJacobian()) return best_;
    double contraction = 1;  // of the residual by the last step
    while (passes_ < kMaxArmPasses && bestWorst_ > kTargetResidual) {
      const Vector from = unknown_, before = residual;
      const double worstBefore = worst_;
      Vector step = -applyInverse(residual);
      limit(step);
      unknown_ = from + step;
      residual = evaluate(worstBefore < kNearlyMet ? Output::Everything : Output::Force);
      const bool good = worst_ < 0.5 * worstBefore;
      // Without progress by a fresh Jacobian, or near rounding by any, an accepted residual is
      // taken.
      const double stalledBelow = fresh ? kAcceptedResidual : kRoundingResidual;
      if (isEnough(contraction * worstBefore) || (!good && bestWorst_ <= stalledBelow)) break;
      if (!good && fresh) shorten(from, step, worstBefore, residual);
      contraction = worst_ < worstBefore ? worst_ / worstBefore : 1;
      fresh = !good || !(worstBefore < kQuasiNewtonBelow);
      if (fresh)
        factorJacobian();
      else
        update(step, residual - before);
    }
    return best_;
  }

 private:
  /// Returns whether another step would gain nothing. An error of the strains counts by the
  /// stiffness of the arms. expected: the residual that the last step should have left but for
  /// rounding, because a step near the answer reduces it at least as much as the step before did. A
  /// small residual far above that is rounding.
  bool isEnough(double expected) const {
    const double least = kForceError / coefficients_.glassy;
    return worst_ <= std::max(least, kTargetResidual) ||
           (worst_ <= kRoundingResidual && expected <= least);
  }

  /// Tries complete contact, in which depth and strains are known, up to the digits that slow arms
  /// lose. A pass shows whether contact is complete.
  bool tryComplete() {
    const double depth = first_ > 0 ? high_ : fixedDepth_;
    // Somewhere the line is higher, as a rule soon.
    if (std::ranges::any_of(line_.heightAboveMinimum, [&](double z) { return z > depth; }))
      return false;
    if (first_ > 0) unknown_[0] = depth;
    findCompleteStrains(line_, vectors_, strains(), work_);
    for (int i = 0; i < 3; ++i) {
      const Vector residual = evaluate();
      if (!work_.wasComplete()) break;
      if (bestWorst_ <= kTargetResidual) return best_.isComplete = true;
      unknown_.tail(arms_) -= residual.tail(arms_);
    }
    forget();
    return false;
  }

  /// Resets the result to that before the first pass. A search that never finds finite numbers ends
  /// with it: it is not met and has a strain for every arm.
  void forget() {
    bestWorst_ = kInfinite;
    best_ = {};
    best_.force.residual = best_.periodicityError = bestWorst_;
    best_.strain.assign(coefficients_.arms(), 0);
  }

  void start(const ArmBalance* guess) {
    if (guess && guess->strain.size() == coefficients_.arms()) {
      if (first_ > 0) unknown_[0] = std::clamp(guess->force.depth, low_, high_);
      std::copy(guess->strain.begin(), guess->strain.end(), strains().begin());
      return;
    }
    if (first_ > 0) unknown_[0] = high_;
    const double aboveMean =
        first_ > 0 ? line_.meanHeight : std::min(fixedDepth_, line_.meanHeight);
    for (std::size_t i = 0; i < slowness_.size(); ++i) strains()[i] = slowness_[i] * aboveMean;
  }

  double depth() const { return first_ > 0 ? unknown_[0] : fixedDepth_; }
  std::span<double> strains() { return {unknown_.data() + first_, coefficients_.arms()}; }

  /// Runs a pass at the unknowns and returns the residuals in m: first the missing mean depth, then
  /// the change of each arm's strain over the period.
  Vector evaluate(Output output = Output::Force) {
    runArmPass(line_, vectors_, depth(), strains(), output, work_);
    ++passes_;
    Vector residual(unknown_.size());
    // The force.
    const double mean = work_.sums.depth / line_.length;
    const double target = first_ > 0 ? load_ / line_.length : mean;
    if (first_ > 0) residual[0] = mean - target;
    forceResidual_ = first_ > 0 ? std::abs(residual[0]) / target : 0;
    // The arms' strains after a period.
    const double scale = strainScale(mean);
    periodicityError_ = 0;
    for (std::size_t i = 0; i < change_.size(); ++i) {
      const double missing = work_.creepChange[i] / change_[i];
      // NaN must not count as converged: std::max would skip it.
      const double share = std::abs(missing) / scale;
      periodicityError_ = std::max(periodicityError_, share >= 0 ? share : kInfinite);
      residual[first_ + static_cast<Index>(i)] = missing;
    }
    worst_ = std::max(forceResidual_, periodicityError_);
    if (!(worst_ >= 0)) worst_ = kInfinite;
    if (worst_ < bestWorst_) remember(output);
    best_.force.passes = passes_;
    return residual;
  }

  /// Returns the scale (m) of changes of strain: that of the strains and heights that cause
  /// friction, but at light loads the depth.
  double strainScale(double meanDepth) {
    double scale = line_.meanHeight;
    for (const double strain : strains()) scale = std::max(scale, std::abs(strain));
    return std::max(std::min(scale, std::abs(meanDepth)), std::numeric_limits<double>::min());
  }

  void remember(Output output) {
    bestWorst_ = worst_;
    best_.force.depth = depth();
    best_.force.residual = forceResidual_;
    best_.periodicityError = periodicityError_;
    best_.strain.assign(strains().begin(), strains().end());
    best_.sums.reset();
    if (output == Output::Everything) best_.sums = work_.sums;
  }

  /// Takes the Jacobian of the last pass; returns false where it is singular.
  bool factorJacobian() {
    findArmJacobian(vectors_, work_, jacobian_);
    const Index size = unknown_.size();
    matrix_.resize(size, size);
    for (Index k = 0; k < size; ++k) {
      const auto unknown = static_cast<std::size_t>(k + 1 - first_);
      if (first_ > 0) matrix_(0, k) = jacobian_.ofDepthIntegral(unknown) / line_.length;
      for (std::size_t i = 0; i < change_.size(); ++i)
        matrix_(first_ + static_cast<Index>(i), k) =
            jacobian_.ofCreepChange(i, unknown) / change_[i];
    }
    updates_.clear();
    factors_.compute(matrix_);
    return (factors_.matrixLU().diagonal().array().abs() > 0).all();
  }

  /// Returns the product of the inverse Jacobian, as factored and since updated, with a vector.
  Vector applyInverse(const Vector& vector) const {
    Vector result = factors_.solve(vector);
    for (const Update& update : updates_) result += update.correction * update.step.dot(result);
    return result;
  }

  /// Applies Broyden's update to the inverse Jacobian for a step and the change of the residual in
  /// it.
  void update(const Vector& step, const Vector& change) {
    const Vector predicted = applyInverse(change);
    const double scale = step.dot(predicted);
    if (!(std::abs(scale) > 1e-6 * step.squaredNorm())) return;
    updates_.push_back({step, (step - predicted) / scale});
  }

  /// Limits the depth to the range in which the force can be met, to rounding.
  void limit(Vector& step) const {
    if (first_ == 0) return;
    const double from = unknown_[0], slack = 1e-9 * high_;
    const double next = from + step[0];
    if (next > high_ + slack) step[0] = high_ - from;
    if (next < low_ - slack) step[0] = 0.9 * (low_ - from);
  }

  /// Shortens Newton's step until the worst residual is below the one before it.
  void shorten(const Vector& from, Vector& step, double worstBefore, Vector& residual) {
    for (int i = 0; i < 12 && !(worst_ < worstBefore); ++i) {
      step *= 0.35;
      unknown_ = from + step;
      residual = evaluate();
    }
  }

  const PreparedProfile& line_;
  const ArmCoefficients& coefficients_;
  const ArmVectors& vectors_;
  ArmWorkspace& work_;
  ArmJacobian& jacobian_;
  double load_, fixedDepth_;
  Index arms_, first_;  // first_: of the strains among the unknowns
  Vector unknown_;
  double low_, high_;  // m, of the depth
  Matrix matrix_;
  Eigen::PartialPivLU<Matrix> factors_;  // of the Jacobian
  /// The corrections of the inverse Jacobian: each adds correction step^T times the inverse itself.
  struct Update {
    Vector step, correction;
  };
  std::vector<Update> updates_;
  std::vector<double> change_;  // 1 - exp(-L / c_i)
  std::vector<double>
      slowness_;  // 1: the strain hardly changes in a period; 0: it does not depend on the last one
  double forceResidual_ = 0, periodicityError_ = 0;
  double worst_ = 0, bestWorst_ = 0;  // the larger of the two
  int passes_ = 0;
  ArmBalance best_;
};

ArmSolver::ArmSolver(const PreparedProfile& line, ArmTables& tables, double velocity)
    : line_(line),
      table_(tables.at(velocity, line)),
      work_(table_->vectors),
      jacobian_(table_->vectors) {}

ArmBalance ArmSolver::atLoad(double load, const ArmBalance* guess) {
  return Search(*this, load, 0).run(guess);
}

ArmBalance ArmSolver::atDepth(double depth, const ArmBalance* guess) {
  return Search(*this, 0, depth).run(guess);
}

bool ArmSolver::isContactComplete(double depth) {
  std::vector<double> strain(table_->vectors.arms);
  findCompleteStrains(line_, table_->vectors, strain, work_);
  runArmPass(line_, table_->vectors, depth, strain, Output::Force, work_);
  return work_.wasComplete();
}

double ArmSolver::completeAbove() {
  double low = 0, high = 2 * line_.meanHeight;
  while (high > 0 && !isContactComplete(high)) high *= 2;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (isContactComplete(middle) ? high : low) = middle;
  }
  return high;
}

PassSums ArmSolver::sums(const ArmBalance& balance, ArmShape* shape) {
  if (shape) {
    ArmPass pass(line_, table_->coefficients);
    pass.runForState(balance.force.depth, balance.strain, shape);
    return pass.sums();
  }
  runArmPass(line_, table_->vectors, balance.force.depth, balance.strain, Output::Everything,
             work_);
  return work_.sums;
}

namespace {

/// Solves balances at one load by continuation where a plain search fails.
class Continuation {
 public:
  Continuation(const PreparedProfile& line, ArmTables& tables, const Load& load)
      : line_(line),
        tables_(tables),
        byForce_(load.kind == LoadKind::Force),
        value_(byForce_ ? load.normalForce / (4 * tables.law().equilibriumModulus) : load.depth) {}

  ArmBalance solve(double velocity, const ArmBalance* guess) {
    ArmBalance found = attempt(velocity, guess);
    if (!found.isMet() && guess) found = attempt(velocity, nullptr);
    if (!found.isMet() && byForce_) found = solveByBracketing(velocity, found);
    if (!found.isMet()) found = continueFromLowerVelocity(velocity, found);
    if (!found.isMet()) found = continueFromHigherLoad(velocity, found);
    found.force.passes = passes_;
    return found;
  }

 private:
  static constexpr int kMaxSteps = 60;

  ArmBalance attempt(double velocity, const ArmBalance* guess) {
    return attempt(velocity, value_, guess);
  }

  ArmBalance attempt(double velocity, double value, const ArmBalance* guess) {
    ArmSolver solver(line_, tables_, velocity);
    ArmBalance found = byForce_ ? solver.atLoad(value, guess) : solver.atDepth(value, guess);
    passes_ += found.force.passes;
    return found;
  }

  /// The depth alone is sought between what carries too little and too much, and the strains are
  /// made periodic at each depth. A search of depth and strains together begins many orders of
  /// magnitude above the depth of a contact that is much smaller than an element: there each step
  /// changes the contact so much that the strains are no longer those of its period, and shorter
  /// steps get nowhere. At a given depth the strains take a few passes, and the force only rises
  /// with the depth, nearly as a power of it. Close to the answer depth and strains move together
  /// again.
  ArmBalance solveByBracketing(double velocity, ArmBalance failed) {
    constexpr double kClose = 1e-2, kCloser = 1e-3;  // of ln F_N, for another common search
    constexpr double kNothing = -700;                // ln of a force that is 0
    struct End {
      double depth, excess = 0;  // ln of both, the force over the wanted one
      bool isKnown = false;
    };
    ArmSolver solver(line_, tables_, velocity);
    const double mean = value_ / line_.length;
    End low{std::log(mean)}, high{std::log(mean + line_.meanHeight)};
    double close = kClose, at = high.depth;
    ArmBalance known;
    bool wasAbove = false;
    for (int step = 0; step < kMaxSteps; ++step) {
      ArmBalance found = solver.atDepth(std::exp(at));
      if (!found.isMet() && !known.strain.empty()) found = solver.atDepth(std::exp(at), &known);
      passes_ += found.force.passes + 1;
      if (!(found.periodicityError < kClose)) return failed;
      const double over = solver.sums(found).depth / value_;
      const double excess = over > 0 ? std::log(over) : kNothing;
      known = std::move(found);
      known.sums.reset();
      if (std::abs(excess) < close) {
        ArmBalance both = attempt(velocity, &known);
        if (both.isMet()) return both;
        close *= kCloser;
      }
      // An end that stays counts half as much each time (Illinois), so that both come closer.
      const bool isAbove = excess > 0;
      if (step > 0 && isAbove == wasAbove) (isAbove ? low : high).excess *= 0.5;
      wasAbove = isAbove;
      (isAbove ? high : low) = {at, excess, true};
      const double share = low.isKnown && high.isKnown && high.excess > low.excess
                               ? -low.excess / (high.excess - low.excess)
                               : 0.5;
      const double next = low.depth + share * (high.depth - low.depth);
      if (next == at || !(next >= low.depth && next <= high.depth)) return failed;
      at = next;
    }
    return failed;
  }

  /// Continues from a load at which a search without a guess succeeds down to the given one, by
  /// steps that shrink where they fail: for a contact much smaller than an element, complete
  /// contact is no useful guess.
  ArmBalance continueFromHigherLoad(double velocity, ArmBalance failed) {
    constexpr double kHighest = 1e40;  // over the wanted load
    double over = 10;
    ArmBalance known = attempt(velocity, over * value_, nullptr);
    while (!known.isMet() && (over *= over) < kHighest)
      known = attempt(velocity, over * value_, nullptr);
    if (!known.isMet()) return failed;
    double factor = 8;
    for (int step = 0; step < kMaxSteps && over > 1; ++step) {
      const double next = std::max(over / factor, 1.0);
      ArmBalance found = attempt(velocity, next * value_, &known);
      if (found.isMet()) {
        known = std::move(found);
        over = next;
        factor = std::min(factor * factor, 64.0);
      } else {
        factor = std::sqrt(factor);
      }
    }
    return over > 1 ? failed : known;
  }

  /// Continues from a velocity at which the slowest arm forgets within a hundredth of the period up
  /// to the given one, by steps that shrink where they fail.
  ArmBalance continueFromLowerVelocity(double velocity, ArmBalance failed) {
    double reached =
        std::min(0.01 * line_.length / tables_.law().arms.front().relaxationTime, 0.1 * velocity);
    ArmBalance known = attempt(reached, nullptr);
    if (!known.isMet()) return failed;
    double factor = 4;
    for (int step = 0; step < kMaxSteps && reached < velocity; ++step) {
      const double next = std::min(reached * factor, velocity);
      ArmBalance found = attempt(next, &known);
      if (found.isMet()) {
        known = std::move(found);
        reached = next;
        factor = std::min(factor * factor, 4.0);
      } else {
        factor = std::sqrt(factor);
      }
    }
    return reached < velocity ? failed : known;
  }

  const PreparedProfile& line_;
  ArmTables& tables_;
  bool byForce_;
  double value_;  // m^2, load per 4G, or m, depth
  int passes_ = 0;
};

}  // namespace

ArmState slideWithArms(const PreparedProfile& line, ArmTables& tables, const Load& load,
                       double velocity, const ArmBalance* guess) {
  const FlushDenormals flush;
  countStage(Stage::Arms);
  countStage(Stage::Periodicity);
  ArmState state;
  state.balance = Continuation(line, tables, load).solve(velocity, guess);
  if (!state.balance.isComplete) countStage(Stage::ContactSearch);
  const Balance& force = state.balance.force;
  const double periodicityError = state.balance.periodicityError;
  const PassSums sums = state.balance.sums ? *state.balance.sums
                                           : ArmSolver(line, tables, velocity).sums(state.balance);
  const ElementLaw& law = tables.law();
  // The slowest arm stands for all: they are not elastic.
  state.result = steadyResult(
      line, {law.equilibriumModulus, law.arms.front().relaxationTime, velocity},
      Balance{force.depth, force.passes, std::max(force.residual, periodicityError)}, sums);
  state.result.periodicityError = periodicityError;
  return state;
}

ArmShape armShapeAt(const PreparedProfile& line, ArmTables& tables, double velocity,
                    const ArmBalance& balance) {
  const FlushDenormals flush;
  ArmShape shape;
  ArmSolver(line, tables, velocity).sums(balance, &shape);
  return shape;
}

}  // namespace asperity
