// Steady sliding of one line at one velocity, by the readable plain pass: the answer in SI units.
// Kelvin elements with stiffness 4G and damping 4 eta per length (Li et al. 2013, Eqs. 1 to 4).
// Here every path to a steady state, plain, swept or with arms, makes its SteadyResult.
// Threading: functions of their arguments; a PreparedProfile is shared freely.
// Failure: no exception but that of requireBalance; `status` says whether the balance was met,
// `residual` how far.
#pragma once

#include <string>

#include "core/base/input_error.h"
#include "core/contact/force_balance.h"
#include "core/contact/kernels/nodal_balance.h"
#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"
#include "core/scene/scene.h"

namespace asperity {

/// NotBalanced: the force balance is not met, or the two ways to the normal force differ by more
/// than kForcesAgree, which says that the numbers have run out of digits (a contact of 1e-15 of the
/// line).
enum class SteadyStatus { Balanced, NotBalanced };
inline constexpr double kForcesAgree = 1e-4;

struct SlidingConditions {
  double shearModulus = 0;    // Pa, G
  double relaxationTime = 0;  // s, tau; 0: elastic
  double velocity = 0;        // m/s, >= 0; the direction is the PreparedProfile's

  double relaxationLength() const { return velocity * relaxationTime; }  // m, c
};

struct SteadyResult {
  SteadyStatus status = SteadyStatus::Balanced;
  double indentation = 0;        // m, from the lowest point of the line
  double normalForce = 0;        // N
  double tangentialForce = 0;    // N; resolved lines: from the power dissipated; nodal: Eq. (4)
  double mu = 0;                 // tangential over normal force
  double contactFraction = 0;    // L_cont / L
  double rmsSlopeContact = 0;    // NaN without contact
  double powerIn = 0;            // W, pressure times the line's slope times v, over contact
  double powerDissipated = 0;    // W, 4 eta v^2 integral u'^2 over all elements
  double forceFromDepth = 0;     // N, -4G integral u over all elements
  double forceFromPressure = 0;  // N, integral of p over contact; equal in steady sliding
  double marginalShare = 1;      // nodal: load share of the element on the edge; 1: none
  int passes = 0;
  double residual = 0;          // |F_N - target| / target; with arms also of their period
  double periodicityError = 0;  // elements with arms: change over a period, relative
  double depthAtRest = 0;   // m, to some digits, under that force; of sweeps over resolved lines
  double muInterface = 0;   // of local friction, beside mu, which is that of the deformation
  double rmsSlopeLine = 0;  // of the whole line; of realizations, which may differ in it

  double muTotal() const { return mu + muInterface; }
};

/// Computes friction of a steady state, in SI units, from the sums of a pass at this depth (m): the
/// only place that does. (Motions in time: core/run/transient.h.) Counts as one pass, balanced.
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth, const PassSums& sums);

/// The same with passes, residual and status of the balance that led to it.
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const Balance& balance, const PassSums& sums);
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const NodalBalance& nodal);

/// The status that residual and forces of a resolved line's result call for.
SteadyStatus balanceStatus(const SteadyResult& result);

/// Describes what is wrong with an unbalanced result at this velocity (m/s): the balance is not
/// met, or numbers have too few digits for it. where: "on realization 3", or empty.
TextError balanceError(const SteadyResult& result, double velocity, const Message& where = {});

/// Throws it where the result is not balanced.
void requireBalance(const SteadyResult& result, double velocity, const Message& where = {});

/// At a constant normal force (N, > 0). guess: indentation nearby (m), or 0; it changes the cost,
/// not the answer beyond the residual.
SteadyResult slideAtForce(const PreparedProfile& line, const SlidingConditions& conditions,
                          double normalForce, double guess = 0);

/// At a constant indentation (m, > 0).
SteadyResult slideAtDepth(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth);

/// What the scene says of the elastomer, at this velocity; without its arms, which only
/// core/contact/steady_solver.h knows.
SlidingConditions slidingConditions(const Scene& scene, double velocity);

/// At the scene's load, whichever it is.
SteadyResult slideAtLoad(const PreparedProfile& line, const SlidingConditions& conditions,
                         const Load& load, double guess = 0);

/// Shape of the elastomer at that indentation, at the line's nodes in travel order.
NodeShape shapeAt(const PreparedProfile& line, const SlidingConditions& conditions, double depth);

/// Local friction in contact, beside what the deformation costs: a constant coefficient (Amontons
/// and Coulomb) or a constant tangential load on each length in contact (Tabor). It changes no
/// deformation and is reported apart. This is its part of the coefficient of friction while
/// sliding. contactLength: m; 0 without a force.
inline double localFriction(const Interface& interface, double normalForce, double contactLength) {
  if (!(normalForce > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient;
  return interface.shearStress * contactLength / normalForce;
}

/// The tangential load (N/m) of local friction on a place under the line load p (N/m), while
/// sliding; 0 where nothing touches.
inline double localFrictionLoad(const Interface& interface, double pressure) {
  if (!(pressure > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient * pressure;
  return interface.shearStress;
}

}  // namespace asperity
