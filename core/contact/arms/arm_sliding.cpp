#include "core/contact/arms/arm_sliding.h"

#include <algorithm>
#include <cmath>

#include "core/base/flush_denormals.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

class Solving {
 public:
  Solving(const PreparedProfile& line, const ElementLaw& law, const RetardationModes& modes,
          const Load& load)
      : line_(line),
        law_(law),
        modes_(modes),
        byForce_(load.kind == LoadKind::Force),
        value_(byForce_ ? load.normalForce / (4 * law.equilibriumModulus) : load.depth) {}

  ArmBalance solve(double velocity, const ArmBalance* guess) {
    ArmBalance found = attempt(velocity, guess);
    if (!found.isMet() && guess) found = attempt(velocity, nullptr);
    if (!found.isMet()) found = follow(velocity, found);
    found.force.passes = passes_;
    return found;
  }

 private:
  static constexpr int kMostSteps = 60;

  ArmBalance attempt(double velocity, const ArmBalance* guess) {
    ArmSolver solver(line_, law_, modes_, velocity);
    ArmBalance found = byForce_ ? solver.atLoad(value_, guess) : solver.atDepth(value_, guess);
    passes_ += found.force.passes;
    return found;
  }

  /// Up from where the slowest arm forgets within a hundredth of the period, by steps that shrink
  /// where they fail.
  ArmBalance follow(double velocity, ArmBalance failed) {
    double reached =
        std::min(0.01 * line_.length / law_.arms.front().relaxationTime, 0.1 * velocity);
    ArmBalance known = attempt(reached, nullptr);
    if (!known.isMet()) return failed;
    double factor = 4;
    for (int step = 0; step < kMostSteps && reached < velocity; ++step) {
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
  const ElementLaw& law_;
  const RetardationModes& modes_;
  bool byForce_;
  double value_;
  int passes_ = 0;
};

}  // namespace

ArmState slideWithArms(const PreparedProfile& line, const ElementLaw& law,
                       const RetardationModes& modes, const Load& load, double velocity,
                       const ArmState* guess) {
  const FlushDenormals flush;
  countStage(Stage::Arms);
  countStage(Stage::Closure);
  ArmState state;
  state.balance =
      Solving(line, law, modes, load).solve(velocity, guess ? &guess->balance : nullptr);
  if (!state.balance.isComplete) countStage(Stage::ContactSearch);
  const StateSums sums = ArmSolver(line, law, modes, velocity).state(state.balance);
  SteadyResult& result = state.result;
  result =
      steadyResultOf(line, {law.equilibriumModulus, 0, velocity}, state.balance.force.depth, sums);
  result.passes = state.balance.force.passes;
  result.residual = std::max(state.balance.force.residual, state.balance.periodicityError);
  result.periodicityError = state.balance.periodicityError;
  result.status = statusOf(result);
  return state;
}

ArmShape armShapeAt(const PreparedProfile& line, const ElementLaw& law,
                    const RetardationModes& modes, double velocity, const ArmBalance& balance) {
  const FlushDenormals flush;
  ArmShape shape;
  ArmSolver(line, law, modes, velocity).state(balance, &shape);
  return shape;
}

}  // namespace asperity
