// Steady sliding of elements with arms: their strains at the lowest point are the same after a
// period, and the force is the wanted one. Repeated passes close only at the rate
// exp(-L / v tau); here depth and arms move together by Newton's method with the derivatives that
// a pass gathers beside, kept up by Broyden's update while that is good enough: an arm of any time
// takes a few passes. Complete contact is tried first where it may be, because there the answer is
// known and a pass only proves it. At the start slow arms have yielded the mean depth F_N / 4 G L
// and fast ones follow the line, which is exact for both. Ownership: keeps its workspace; refers to
// the line. Threading: one thread at a time.
#pragma once

#include <vector>

#include "core/contact/arms/arm_pass.h"
#include "core/contact/force_balance.h"

namespace asperity {

struct ArmBalance {
  Balance force;                // depth, all passes, residual of F_N (0 at a given depth)
  bool isComplete = false;      // contact: nothing was sought
  double periodicityError = 0;  // largest change of an arm's strain over a period, as if it had as
                                // many periods as it takes; relative to strains, heights or depth
  std::vector<double> strain;   // m, at the lowest point
  bool isMet() const { return force.isMet() && periodicityError <= kAcceptedResidual; }
};

class ArmSolver {
 public:
  /// law: with an equilibrium modulus and at least one arm; velocity > 0 (m/s).
  ArmSolver(const PreparedProfile& line, const ElementLaw& law, const RetardationModes& modes,
            double velocity);

  /// load = F_N / 4G (m^2, > 0), G the equilibrium modulus. guess: an answer nearby, or null.
  ArmBalance atLoad(double load, const ArmBalance* guess = nullptr);
  /// At an indentation (m, > 0).
  ArmBalance atDepth(double depth, const ArmBalance* guess = nullptr);

  /// Whether everything is in contact at this depth (m), and the depth above which it is.
  bool isContactComplete(double depth);
  double completeAbove();

  /// Everything about an answer.
  StateSums state(const ArmBalance& balance, ArmShape* shape = nullptr);

 private:
  class Search;

  const PreparedProfile& line_;
  ArmCoefficients memory_;
  ArmPass pass_;
};

}  // namespace asperity
