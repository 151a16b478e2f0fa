// Steady sliding of one line at one velocity, in SI units: Kelvin elements with stiffness 4G and
// damping 4 eta per length (Li et al. 2013, Eqs. 1 to 4). The scheme of the line chooses the pass
// (sumsAt in steady_sliding.cpp): nodalPass for nodal lines, the readable resolvedPass for linear
// and cubic ones. Every way to a steady state, plain, swept or with arms, makes its SteadyResult
// here.
// Threading: functions of their arguments; a PreparedProfile may be shared.
// Failure: no exception except for that of requireBalance; `status` tells whether the balance was
// met, `residual` how well.
#pragma once

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/contact/force_balance.h"
#include "core/contact/kernels/nodal_balance.h"
#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"
#include "core/material/element_law.h"
#include "core/scene/scene.h"

namespace asperity {

/// NotBalanced: the force balance is not met, or the two ways to the normal force differ by more
/// than kForcesAgree. Then the numbers have too few digits, as for a contact of 1e-15 of the line.
enum class SteadyStatus { Balanced, NotBalanced };
inline constexpr double kForcesAgree = 1e-4;

struct SlidingConditions {
  double shearModulus = 0;    // Pa, G
  double relaxationTime = 0;  // s, tau; 0: elastic
  double velocity = 0;        // m/s, >= 0

  double relaxationLength() const { return velocity * relaxationTime; }  // m, c
  /// Returns the same elastomer at another velocity (m/s).
  SlidingConditions at(double other) const { return {shearModulus, relaxationTime, other}; }
};

/// Forces and contact of one line at one time.
struct ContactState {
  double indentation = 0;      // m, d above the line's lowest point
  double normalForce = 0;      // N
  double tangentialForce = 0;  // N, magnitude along the motion
  double contactFraction = 0;  // L_cont / L
  double mu = kNaN;            // NaN where the time steps or elements are too coarse to read it
  double muInterface = 0;      // of local friction, in addition to mu, which is of the deformation
};

/// The state in steady sliding. For resolved lines the tangential force is that of the dissipated
/// power, for nodal ones that of Eq. (4).
struct SteadyResult : ContactState {
  SteadyStatus status = SteadyStatus::Balanced;
  double contactSpots = 0;       // number in one period
  double rmsSlopeContact = 0;    // NaN without contact
  double powerIn = 0;            // W, pressure times the line's slope times v, over contact
  double powerDissipated = 0;    // W, 4 eta v^2 integral u'^2 over all elements
  double forceFromDepth = 0;     // N, -4G integral u over all elements
  double forceFromPressure = 0;  // N, integral of p over contact; equal in steady sliding
  double marginalShare = 1;      // nodal: load share of the element on the edge; 1: no such element
  int passes = 0;
  double residual = 0;          // |F_N - target| / target; with arms also of their periodicity
  double periodicityError = 0;  // elements with arms: relative change over a period
  double depthAtRest = 0;   // m, approximate, under that force; only in sweeps over resolved lines
  double rmsSlopeLine = 0;  // of the whole line; in realizations, whose slopes may differ
};

/// Computes friction of a steady state, in SI units, from the sums of a pass at this depth (m); no
/// other function does. (Motions in time: core/run/transient.h.) The result counts one pass and is
/// balanced.
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth, const PassSums& sums);

/// Returns the same with passes, residual and status of the balance.
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const Balance& balance, const PassSums& sums);
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const NodalBalance& nodal);

/// Returns the status that follows from residual and forces of a resolved line's result.
SteadyStatus balanceStatus(const SteadyResult& result);

/// Describes the fault of an unbalanced result at this velocity (m/s): the balance is not met, or
/// numbers have too few digits for it. where: "on realization 3", or empty.
TextError balanceError(const SteadyResult& result, double velocity, const Message& where = {});

/// Throws that error where the result is not balanced.
void requireBalance(const SteadyResult& result, double velocity, const Message& where = {});

/// Slides at a constant normal force (N, > 0).
SteadyResult slideAtForce(const PreparedProfile& line, const SlidingConditions& conditions,
                          double normalForce);

/// Slides at a constant indentation (m, > 0).
SteadyResult slideAtDepth(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth);

/// Returns the properties of an element at this velocity, without its arms, which only
/// core/contact/steady_solver.h uses.
SlidingConditions slidingConditions(const ElementLaw& law, double velocity);
inline SlidingConditions slidingConditions(const Scene& scene, double velocity) {
  return slidingConditions(elementLaw(scene.elastomer), velocity);
}

/// Slides at the scene's load of either kind.
SteadyResult slideAtLoad(const PreparedProfile& line, const SlidingConditions& conditions,
                         const Load& load);

/// Returns the shape of the elastomer at that indentation, at the line's nodes in order of travel.
NodeShape shapeAt(const PreparedProfile& line, const SlidingConditions& conditions, double depth);

/// Returns the contribution of local friction to the coefficient while sliding: a constant
/// coefficient (Amontons and Coulomb) or a constant tangential load per length in contact (Tabor).
/// It changes no deformation and is reported separately. contactLength: m; 0 without a force.
inline double localFriction(const Interface& interface, double normalForce, double contactLength) {
  if (!(normalForce > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient;
  return interface.shearStress * contactLength / normalForce;
}

/// Returns local friction at a velocity (m/s, of either sign). Its shear stress depends on the
/// velocity where the interface has a shearVelocity v_0: tau = tau_0 exp(-c log10^2(a_T v / v_0))
/// (Lorenz et al. 2015); at rest it is then 0. temperatureShift: a_T.
Interface interfaceAt(const Interface& interface, double temperatureShift, double velocity);
Interface interfaceAt(const Scene& scene, double velocity);

/// Returns the tangential load (N/m) of local friction at a place under the line load p (N/m),
/// while sliding; 0 out of contact.
inline double localFrictionLoad(const Interface& interface, double pressure) {
  if (!(pressure > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient * pressure;
  return interface.shearStress;
}

}  // namespace asperity
