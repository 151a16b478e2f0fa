// Steady sliding of elements with arms: after a period their strains at the lowest point are the
// same again, and the force is the given one. Repeated passes would converge only at the rate
// exp(-L / v tau). Newton's method therefore moves depth and strains together, with the derivatives
// that follow from a pass; Broyden's update maintains the Jacobian while it is good enough. An arm
// of any relaxation time then takes a few passes. The pass that is expected to end the search
// computes all sums.
//
// Complete contact is tried first where it is possible, because its solution is known and one pass
// proves it. Without a guess (arm_guess.h), slow arms begin with the creep that belongs to the mean
// depth F_N / 4 G L, and fast arms follow the line, which is exact for both.
// Threading: these are functions of their arguments; line and tables are shared freely. An
// ArmSolver keeps its workspace, refers to the line, and belongs to one thread. Failure: no
// exception; the status of the result tells whether force and period are met.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/arms/arm_kernel.h"
#include "core/contact/arms/arm_pass.h"
#include "core/contact/force_balance.h"
#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "core/material/element_law.h"

namespace asperity {

/// The coefficients at one velocity for lines of one length, spacing and number of block levels.
struct ArmTable {
  ArmTable(const ElementLaw& law, const RetardationModes& modes, double velocity,
           const PreparedProfile& line)
      : coefficients(law, modes, velocity, line.spacing, line.length, line.blocks.size()),
        vectors(coefficients) {}

  ArmCoefficients coefficients;
  ArmVectors vectors;
};

class ArmTables {
 public:
  /// The object refers to both arguments.
  ArmTables(const ElementLaw& law, const RetardationModes& modes) : law_(law), modes_(modes) {}

  /// velocity: m/s, > 0.
  std::shared_ptr<const ArmTable> at(double velocity, const PreparedProfile& line);

  const ElementLaw& law() const { return law_; }

 private:
  using Key = std::tuple<double, double, double, std::size_t>;

  const ElementLaw& law_;
  const RetardationModes& modes_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const ArmTable>> known_;
};

struct ArmBalance {
  Balance force;                 // depth, all passes, residual of F_N (0 at a given depth)
  bool isComplete = false;       // complete contact, whose solution is known
  double periodicityError = 0;   // largest error of an arm's strain: its change over a period over
                                 // the share of an error that decays in one; relative to strains,
                                 // heights or depth
  std::vector<double> strain;    // m, at the lowest point
  std::optional<PassSums> sums;  // all, where the pass that met it has gathered them
  bool isMet() const { return force.isMet() && periodicityError <= kAcceptedResidual; }
};

class ArmSolver {
 public:
  /// The law has an equilibrium modulus and at least one arm. velocity: m/s, > 0.
  ArmSolver(const PreparedProfile& line, ArmTables& tables, double velocity);

  /// Solves at a load = F_N / 4G (m^2, > 0), where G is the equilibrium modulus. guess: a solution
  /// nearby, or null.
  ArmBalance atLoad(double load, const ArmBalance* guess = nullptr);
  /// Solves at an indentation (m, > 0).
  ArmBalance atDepth(double depth, const ArmBalance* guess = nullptr);

  /// Return whether contact is complete at this depth (m), and the depth (m) above which it is.
  bool isContactComplete(double depth);
  double completeAbove();

  /// Returns all sums of a solution, and its shape.
  PassSums sums(const ArmBalance& balance, ArmShape* shape = nullptr);

 private:
  class Search;

  const PreparedProfile& line_;
  std::shared_ptr<const ArmTable> table_;
  ArmWorkspace work_;
  ArmJacobian jacobian_;
};

/// A steady state in SI units, and the balance from which the next one may start.
struct ArmState {
  SteadyResult result;
  ArmBalance balance;
};

/// Computes the steady state for a law with an equilibrium modulus and at least one arm. velocity:
/// m/s, > 0; guess: a solution nearby, or null.
/// Where the searches from the guess and without one both fail, the solution is continued from a
/// velocity so low that the arms forget, or else from a higher load.
ArmState slideWithArms(const PreparedProfile& line, ArmTables& tables, const Load& load,
                       double velocity, const ArmBalance* guess = nullptr);

/// Returns shape and amplitudes at that state; pressure per 4G.
ArmShape armShapeAt(const PreparedProfile& line, ArmTables& tables, double velocity,
                    const ArmBalance& balance);

}  // namespace asperity
