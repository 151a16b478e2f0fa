// Steady sliding of elements with arms: after a period their strains at the lowest point are the
// same again, and the force is the given one. Repeated passes close only at the rate
// exp(-L / v tau). Here depth and strains move together by Newton's method with the derivatives
// that follow from a pass, kept up by Broyden's update while that is good enough, so an arm of any
// relaxation time takes a few passes. The pass that is expected to end the search gathers all sums.
// Complete contact is tried first where it may be, because there the answer is known and a pass
// only proves it. Without a guess (arm_guess.h), slow arms have yielded the mean depth F_N / 4 G L
// at the start and fast ones follow the line, which is exact for both. Threading: these are
// functions of their arguments; line and tables are shared freely. An ArmSolver keeps its
// workspace, refers to the line, and belongs to one thread. Failure: no exception; the result's
// status says whether balance and period closed.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/contact/arms/arm_kernel.h"
#include "core/contact/arms/arm_pass.h"
#include "core/contact/arms/arm_tables.h"
#include "core/contact/force_balance.h"
#include "core/contact/steady_sliding.h"

namespace asperity {

struct ArmBalance {
  Balance force;                 // depth, all passes, residual of F_N (0 at a given depth)
  bool isComplete = false;       // contact: nothing was sought
  double periodicityError = 0;   // largest change of an arm's strain over a period, as if it had as
                                 // many periods as it takes; relative to strains, heights or depth
  std::vector<double> strain;    // m, at the lowest point
  std::optional<PassSums> sums;  // all, where the pass that met it has gathered them
  bool isMet() const { return force.isMet() && periodicityError <= kAcceptedResidual; }
};

class ArmSolver {
 public:
  /// Of a law with an equilibrium modulus and at least one arm; velocity > 0 (m/s).
  ArmSolver(const PreparedProfile& line, ArmTables& tables, double velocity);

  /// load = F_N / 4G (m^2, > 0), G the equilibrium modulus. guess: an answer nearby, or null.
  ArmBalance atLoad(double load, const ArmBalance* guess = nullptr);
  /// At an indentation (m, > 0).
  ArmBalance atDepth(double depth, const ArmBalance* guess = nullptr);

  /// Whether everything is in contact at this depth (m), and the depth above which it is.
  bool isContactComplete(double depth);
  double completeAbove();

  /// All sums of an answer, and its shape.
  PassSums sums(const ArmBalance& balance, ArmShape* shape = nullptr);

 private:
  class Search;

  const PreparedProfile& line_;
  std::shared_ptr<const ArmTable> table_;
  ArmWorkspace work_;
  ArmJacobian jacobian_;
};

/// A steady state in SI units, and the balance to start the next one from.
struct ArmState {
  SteadyResult result;
  ArmBalance balance;
};

/// Of a law with an equilibrium modulus and at least one arm; velocity > 0 (m/s). `guess`, an
/// answer nearby, may be null.
/// Where a search from the guess and one from nothing both fail, the answer is followed up from a
/// velocity so low that the arms forget, or else down from a higher load.
ArmState slideWithArms(const PreparedProfile& line, ArmTables& tables, const Load& load,
                       double velocity, const ArmBalance* guess = nullptr);

/// Shape and amplitudes at that state; pressure per 4G.
ArmShape armShapeAt(const PreparedProfile& line, ArmTables& tables, double velocity,
                    const ArmBalance& balance);

}  // namespace asperity
