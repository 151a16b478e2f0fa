#include "core/contact/steady_solver.h"

#include "core/base/input_error.h"
#include "core/contact/arms/arm_guess.h"
#include "core/contact/force_balance.h"
#include "core/contact/steady_sweep.h"
#include "core/material/temperature_shift.h"
#include "core/scene/plan.h"
#include "core/scene/scene_check.h"

namespace asperity {

SteadySolver::SteadySolver(const Scene& scene)
    : load_(scene.load),
      interface_(scene.interface),
      temperatureShift_(temperatureShift(scene.elastomer)),
      hasInterface_(needsStage(scene, Purpose::Curve, Stage::Interface)),
      hasArms_(needsStage(scene, Purpose::Curve, Stage::Arms)),
      law_(elementLaw(scene.elastomer)) {
  checkEffects(scene);
  requireEquilibrium(scene);
  if (needsStage(scene, Purpose::Curve, Stage::TemperatureShift))
    countStage(Stage::TemperatureShift);
  if (!hasArms_) return;
  modes_ = retardationModes(law_);
  tables_ = std::make_unique<ArmTables>(law_, modes_);
}

SlidingConditions SteadySolver::conditions(double velocity) const {
  return slidingConditions(law_, velocity);
}

/// Returns whether arms matter at this velocity; at rest every arm has relaxed.
bool SteadySolver::hasArmsAt(double velocity) const {
  return hasArms_ && velocity > 0;
}

void SteadySolver::addInterface(const PreparedProfile& line, double velocity,
                                SteadyResult& result) const {
  if (!hasInterface_) return;
  countStage(Stage::Interface);
  result.muInterface = localFriction(interfaceAt(interface_, temperatureShift_, velocity),
                                     result.normalForce, result.contactFraction * line.length);
}

void SteadySolver::countSteady(const Load& load) const {
  countStage(Stage::SteadyPass);
  if (load.kind == LoadKind::Force) countStage(Stage::ForceBalance);
  if (law_.kind() != ElementKind::Elastic) countStage(Stage::FreeSurface);
}

bool SteadySolver::sweepArms(const PreparedProfile& line, const Load& load,
                             std::span<const double> velocities, std::span<SteadyResult> results,
                             const std::stop_token& stop) const {
  ArmGuess guess(law_);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    if (stop.stop_requested()) return false;
    const ArmState found =
        slideWithArms(line, *tables_, load, velocities[i], guess.at(velocities[i]));
    guess.take(velocities[i], found.balance);
    results[i] = found.result;
  }
  return true;
}

bool SteadySolver::sweep(const PreparedProfile& line, const Load& load,
                         std::span<const double> velocities, std::span<SteadyResult> results,
                         const std::stop_token& stop, std::span<const SteadyResult> others) const {
  const Load forceLoad = loadOn(load, line.length);
  countSteady(forceLoad);
  if (velocities.size() > 1) countStage(Stage::Sweep);
  const bool done =
      hasArms_ ? sweepArms(line, forceLoad, velocities, results, stop)
               : slideSweep(line, conditions(0), forceLoad, velocities, results, stop, others);
  if (done)
    for (std::size_t i = 0; i < results.size(); ++i) addInterface(line, velocities[i], results[i]);
  return done;
}

bool SteadySolver::sweepForces(const PreparedProfile& line, std::span<const double> forces,
                               std::span<const double> velocities, std::span<SteadyResult> results,
                               const std::stop_token& stop,
                               std::span<const SteadyResult> others) const {
  countSteady({LoadKind::Force});
  if (velocities.size() > 1) countStage(Stage::Sweep);
  if (!slideAtForces(line, conditions(0), forces, velocities, results, stop, others)) return false;
  for (std::size_t i = 0; i < results.size(); ++i)
    addInterface(line, velocities[i % velocities.size()], results[i]);
  return true;
}

SteadyState SteadySolver::at(const PreparedProfile& line, double velocity) const {
  const Load forceLoad = loadOn(load_, line.length);
  countSteady(forceLoad);
  SteadyState state;
  if (hasArmsAt(velocity)) {
    ArmState found = slideWithArms(line, *tables_, forceLoad, velocity);
    state = {found.result, std::move(found.balance)};
  } else {
    state.result = slideAtLoad(line, conditions(velocity), forceLoad);
  }
  addInterface(line, velocity, state.result);
  return state;
}

bool SteadySolver::isComplete(const PreparedProfile& line, double depth, double velocity) const {
  return hasArmsAt(velocity) ? ArmSolver(line, *tables_, velocity).isContactComplete(depth)
                             : isContactComplete(line, depth, velocity * law_.relaxationTime);
}

double SteadySolver::completeAbove(const PreparedProfile& line, double velocity) const {
  return hasArmsAt(velocity) ? ArmSolver(line, *tables_, velocity).completeAbove()
                             : asperity::completeAbove(line, velocity * law_.relaxationTime);
}

SteadyShape SteadySolver::shape(const PreparedProfile& line, double velocity,
                                const SteadyState& state) const {
  countStage(Stage::Shape);
  SteadyShape shape;
  if (hasArmsAt(velocity)) {
    ArmShape found = armShapeAt(line, *tables_, velocity, state.arms);
    shape = {std::move(found.nodes), std::move(found.modes)};
  } else {
    shape.nodes = shapeAt(line, conditions(velocity), state.result.indentation);
    // In equilibrium with its pressure, every mode has reached its final creep.
    if (hasArms_)
      for (const double pressure : shape.nodes.pressure)
        for (std::size_t j = 0; j < modes_.modes(); ++j)
          shape.modes.push_back(law_.equilibriumModulus * pressure * modes_.fluidity[j] /
                                modes_.rate[j]);
  }
  for (double& pressure : shape.nodes.pressure) pressure *= 4 * law_.equilibriumModulus;
  return shape;
}

}  // namespace asperity
