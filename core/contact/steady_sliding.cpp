#include "core/contact/steady_sliding.h"

#include <algorithm>
#include <cmath>

#include "core/contact/force_balance.h"
#include "core/contact/kernels/kernels.h"
#include "core/contact/kernels/pass.h"
#include "core/material/element_law.h"
#include "core/material/temperature_shift.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

/// Runs the pass of the line's scheme and returns its sums.
PassSums sumsAt(const PreparedProfile& line, double depth, double relaxationLength,
                NodeShape* shape = nullptr) {
  return line.scheme == Scheme::Nodal
             ? nodalPass(line, depth, relaxationLength, shape).sums
             : resolvedPass(line, depth, relaxationLength, Output::Everything, shape);
}

/// Returns the same. Complete contact has exactly the length of the line, which a sum of a million
/// lengths misses by rounding.
PassSums sumsAt(const PreparedProfile& line, double depth, double relaxationLength,
                bool isComplete) {
  PassSums sums = sumsAt(line, depth, relaxationLength);
  if (isComplete) sums.contactLength = line.length;
  return sums;
}

}  // namespace

Interface interfaceAt(const Interface& interface, double temperatureShift, double velocity) {
  if (!(interface.shearVelocity > 0) || !(interface.shearStress > 0)) return interface;
  Interface at = interface;
  const double shifted = std::abs(velocity) * temperatureShift;
  if (!(shifted > 0)) {
    at.shearStress = 0;
    return at;
  }
  const double decades = std::log10(shifted / interface.shearVelocity);
  at.shearStress *= std::exp(-at.shearWidth * decades * decades);
  return at;
}

Interface interfaceAt(const Scene& scene, double velocity) {
  return interfaceAt(scene.interface, temperatureShift(scene.elastomer), velocity);
}

SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth, const PassSums& sums) {
  const double stiffness = 4 * conditions.shearModulus;
  // The dissipation has only positive terms, so of the two ways to the tangential force it keeps
  // its digits where friction is small. The paper's nodes have only Eqs. (3) and (4).
  const bool isNodal = line.scheme == Scheme::Nodal;
  const double normal = isNodal ? sums.pressure : sums.depth;
  // Elastic elements dissipate nothing; the terms keep the squared rounding of contact edges.
  const double dissipation = conditions.relaxationLength() != 0 ? sums.dissipation : 0;
  const double tangential = isNodal ? sums.work : dissipation;
  SteadyResult result;
  result.indentation = depth;
  result.normalForce = stiffness * normal;
  result.tangentialForce = stiffness * tangential;
  // Without a normal force there is no coefficient.
  result.mu = normal != 0 ? tangential / normal : kNaN;
  result.contactFraction = std::min(sums.contactLength / line.length, 1.0);
  // A closed line has as many contact spots as gaps.
  result.contactSpots = sums.contactLength > 0 ? std::max(sums.gaps, 1.0) : 0;
  result.rmsSlopeContact =
      sums.contactLength > 0 ? std::sqrt(sums.slopeSquared / sums.contactLength) : kNaN;
  result.powerIn = stiffness * sums.work * conditions.velocity;
  result.powerDissipated = stiffness * dissipation * conditions.velocity;
  result.forceFromDepth = stiffness * sums.depth;
  result.forceFromPressure = stiffness * sums.pressure;
  result.passes = 1;
  return result;
}

SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const Balance& balance, const PassSums& sums) {
  SteadyResult result = steadyResult(line, conditions, balance.depth, sums);
  result.passes = balance.passes;
  result.residual = balance.residual;
  result.status = balanceStatus(result);
  return result;
}

/// The status follows from the residual alone, because for separate elements the two ways to the
/// forces differ by nature.
SteadyResult steadyResult(const PreparedProfile& line, const SlidingConditions& conditions,
                          const NodalBalance& nodal) {
  SteadyResult result = steadyResult(line, conditions, nodal.balance.depth, nodal.sums);
  result.passes = nodal.balance.passes;
  result.residual = nodal.balance.residual;
  result.status = nodal.balance.isMet() ? SteadyStatus::Balanced : SteadyStatus::NotBalanced;
  result.marginalShare = nodal.marginalShare;
  return result;
}

SteadyStatus balanceStatus(const SteadyResult& result) {
  const bool isMet = result.residual <= kAcceptedResidual;
  const double apart = std::abs(result.forceFromPressure / result.forceFromDepth - 1);
  return isMet && apart <= kForcesAgree ? SteadyStatus::Balanced : SteadyStatus::NotBalanced;
}

TextError balanceError(const SteadyResult& result, double velocity, const Message& where) {
  const Message state = sentences({message("at velocity {:.4g} m/s", velocity), where});
  if (result.residual <= kAcceptedResidual)
    return TextError(message(
        "contact is too short, or the moduli differ too much, for double precision, {}", state));
  return TextError(
      message("the force balance is not met {}: relative residual {:.2g}", state, result.residual));
}

void requireBalance(const SteadyResult& result, double velocity, const Message& where) {
  if (result.status != SteadyStatus::Balanced) throw balanceError(result, velocity, where);
}

SteadyResult slideAtForce(const PreparedProfile& line, const SlidingConditions& conditions,
                          double normalForce) {
  const double c = conditions.relaxationLength();
  const double load = normalForce / (4 * conditions.shearModulus);
  if (line.scheme == Scheme::Nodal) {
    countStage(Stage::ContactSearch);
    return steadyResult(line, conditions, balanceNodal(line, c, load));
  }
  const double whole = completeContactDepth(line, load);
  const bool isComplete = isContactComplete(line, whole, c);
  Balance balance{whole, 1, 0};
  if (!isComplete) {
    countStage(Stage::ContactSearch);
    balance = balanceResolved(line, c, load);
  }
  const PassSums sums = sumsAt(line, balance.depth, c, isComplete);
  if (isComplete) balance.residual = std::abs(sums.depth / load - 1);
  return steadyResult(line, conditions, balance, sums);
}

SteadyResult slideAtDepth(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth) {
  const double c = conditions.relaxationLength();
  const bool isComplete = line.scheme != Scheme::Nodal && isContactComplete(line, depth, c);
  if (!isComplete) countStage(Stage::ContactSearch);
  return steadyResult(line, conditions, depth, sumsAt(line, depth, c, isComplete));
}

SlidingConditions slidingConditions(const ElementLaw& law, double velocity) {
  return {law.equilibriumModulus, law.relaxationTime, velocity};
}

SteadyResult slideAtLoad(const PreparedProfile& line, const SlidingConditions& conditions,
                         const Load& load) {
  return load.kind == LoadKind::Force ? slideAtForce(line, conditions, load.normalForce)
                                      : slideAtDepth(line, conditions, load.depth);
}

NodeShape shapeAt(const PreparedProfile& line, const SlidingConditions& conditions, double depth) {
  NodeShape shape;
  sumsAt(line, depth, conditions.relaxationLength(), &shape);
  return shape;
}

}  // namespace asperity
