// The initial guess of a balance, from the balances at the previous velocities of the same line.
// The strain of an arm at the lowest point depends on the shape of the elastomer and on its
// relaxation length c = v tau. The shape changes little from one velocity to the next, so strains
// are interpolated in c and then extrapolated with their previous trend. The guess changes the cost
// of a balance, but not its result beyond the residual. One sweep along velocities owns the object.
#pragma once

#include <vector>

#include "core/contact/arms/arm_balance.h"
#include "core/material/element_law.h"

namespace asperity {

class ArmGuess {
 public:
  explicit ArmGuess(const ElementLaw& law);

  /// Stores the balance at a velocity (m/s, > 0); one that is not met clears all earlier ones.
  void take(double velocity, const ArmBalance& balance);
  /// Returns an approximation of the balance at this velocity, or null where nothing is known.
  const ArmBalance* at(double velocity);

 private:
  struct Known {
    double velocity = 0, depth = 0;  // m/s, m; velocity 0: nothing
    std::vector<double> strain;      // m
  };

  double strainAt(const Known& known, double relaxationLength) const;

  const ElementLaw& law_;
  std::vector<double> logTime_;  // of the arms' relaxation times
  Known last_, before_;
  ArmBalance guess_;
};

}  // namespace asperity
