#include "core/contact/steady_sliding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/complete_contact.h"
#include "core/contact/force_balance.h"
#include "core/contact/kernels/nodal_pass.h"
#include "core/contact/kernels/resolved_pass.h"
#include "core/material/element_law.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

double memoryOf(const SlidingConditions& conditions) {
  return conditions.velocity * conditions.relaxationTime;
}

void addBalance(SteadyResult& result, const Balance& balance) {
  result.status = balance.isMet() ? SteadyStatus::Balanced : SteadyStatus::NotBalanced;
  result.passes = balance.passes;
  result.residual = balance.residual;
}

StateSums sumsAt(const PreparedProfile& line, double depth, double memory,
                 NodeShape* shape = nullptr) {
  return line.scheme == Scheme::Nodal ? nodalStateAt(line, depth, memory, shape).sums
                                      : stateAt(line, depth, memory, shape);
}

/// Complete contact is the whole line, of which a sum of a million lengths falls short.
StateSums sumsAt(const PreparedProfile& line, double depth, double memory, bool isComplete) {
  StateSums sums = sumsAt(line, depth, memory);
  if (isComplete) sums.contactLength = line.length;
  return sums;
}

}  // namespace

SteadyResult steadyResultOf(const PreparedProfile& line, const SlidingConditions& conditions,
                            double depth, const StateSums& sums) {
  const double stiffness = 4 * conditions.shearModulus;
  const bool nodal = line.scheme == Scheme::Nodal;
  SteadyResult result;
  result.indentation = depth;
  result.normalForce = stiffness * (nodal ? sums.pressure : sums.depth);
  // Of the two ways to the tangential force the dissipation has only positive terms, so it keeps
  // its digits where friction is small. The paper's nodes have Eq. (4) alone.
  result.tangentialForce = stiffness * (nodal ? sums.work : sums.dissipation);
  // Pressed by nothing there is no coefficient.
  result.mu = result.normalForce != 0 ? result.tangentialForce / result.normalForce
                                      : std::numeric_limits<double>::quiet_NaN();
  result.contactFraction = std::min(sums.contactLength / line.length, 1.0);
  result.rmsSlopeContact = sums.contactLength > 0
                               ? std::sqrt(sums.slopeSquared / sums.contactLength)
                               : std::numeric_limits<double>::quiet_NaN();
  result.powerIn = stiffness * sums.work * conditions.velocity;
  result.powerDissipated = stiffness * sums.dissipation * conditions.velocity;
  result.forceFromDepth = stiffness * sums.depth;
  result.forceFromPressure = stiffness * sums.pressure;
  return result;
}

SteadyStatus statusOf(const SteadyResult& result) {
  const bool isMet = result.residual <= kAcceptedResidual;
  const double apart = std::abs(result.forceFromPressure / result.forceFromDepth - 1);
  return isMet && apart <= kForcesAgree ? SteadyStatus::Balanced : SteadyStatus::NotBalanced;
}

SteadyResult resultOfNodal(const PreparedProfile& line, const SlidingConditions& conditions,
                           const NodalBalance& nodal) {
  SteadyResult result = steadyResultOf(line, conditions, nodal.balance.depth, nodal.state.sums);
  addBalance(result, nodal.balance);
  result.marginalShare = nodal.marginalShare;
  return result;
}

SteadyResult slideAtForce(const PreparedProfile& line, const SlidingConditions& conditions,
                          double normalForce, double guess) {
  const double memory = memoryOf(conditions);
  const double load = normalForce / (4 * conditions.shearModulus);
  if (line.scheme == Scheme::Nodal) {
    countStage(Stage::ContactSearch);
    return resultOfNodal(line, conditions, balanceNodal(line, memory, load));
  }
  const double whole = depthOfComplete(line, load);
  const bool isComplete = isContactComplete(line, whole, memory);
  Balance balance{whole, 1, 0};
  if (!isComplete) {
    countStage(Stage::ContactSearch);
    balance = balanceResolved(line, memory, load, guess);
  }
  const StateSums sums = sumsAt(line, balance.depth, memory, isComplete);
  if (isComplete) balance.residual = std::abs(sums.depth / load - 1);
  SteadyResult result = steadyResultOf(line, conditions, balance.depth, sums);
  addBalance(result, balance);
  result.status = statusOf(result);
  return result;
}

SteadyResult slideAtDepth(const PreparedProfile& line, const SlidingConditions& conditions,
                          double depth) {
  const double memory = memoryOf(conditions);
  const bool isComplete = line.scheme != Scheme::Nodal && isContactComplete(line, depth, memory);
  if (!isComplete) countStage(Stage::ContactSearch);
  SteadyResult result =
      steadyResultOf(line, conditions, depth, sumsAt(line, depth, memory, isComplete));
  result.passes = 1;
  return result;
}

SlidingConditions conditionsOf(const Scene& scene, double velocity) {
  const ElementLaw law = lawOf(scene.elastomer);
  return {law.equilibriumModulus, law.relaxationTime, velocity};
}

SteadyResult slideAtLoad(const PreparedProfile& line, const SlidingConditions& conditions,
                         const Load& load, double guess) {
  return load.kind == LoadKind::Force ? slideAtForce(line, conditions, load.normalForce, guess)
                                      : slideAtDepth(line, conditions, load.depth);
}

NodeShape shapeAt(const PreparedProfile& line, const SlidingConditions& conditions, double depth) {
  NodeShape shape;
  sumsAt(line, depth, memoryOf(conditions), &shape);
  return shape;
}

}  // namespace asperity
