// Where the search for a balance begins, from the balances at the last velocities of the same line.
// An arm's strain at the lowest point is what the shape of the elastomer there and before gives for
// its relaxation length c = v tau. The shape changes little from one velocity to the next, so
// strains are looked up by c, and then go on as they went from the velocity before. It changes what
// a balance costs, not its answer beyond the residual. One sweep along velocities owns it.
#pragma once

#include <vector>

#include "core/contact/arms/arm_balance.h"
#include "core/material/element_law.h"

namespace asperity {

class ArmGuess {
 public:
  explicit ArmGuess(const ElementLaw& law);

  /// The balance found at a velocity (m/s, > 0); one that is not met makes all before forgotten.
  void take(double velocity, const ArmBalance& balance);
  /// A balance near that at this velocity, or null where nothing is known.
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
