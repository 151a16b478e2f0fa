// Steady sliding of a scene on any of its lines. SteadySolver chooses the computation by the
// elastomer: elements with Maxwell arms go to arms/arm_balance.h, elastic and Kelvin elements to
// steady_sweep.h (many velocities) or steady_sliding.h (one), which choose the kernel by the line's
// scheme. It adds local friction where the scene has some. Threading: const members may be called
// by several threads at once. Failure: the constructor throws InputError where the scene's effects
// exclude each other or it has no steady state; afterwards `status` of a result tells its quality.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/contact/arms/arm_balance.h"
#include "core/contact/arms/retardation.h"
#include "core/contact/steady_sliding.h"
#include "core/material/element_law.h"
#include "core/scene/scene.h"

namespace asperity {

/// A result with the strains of its elements' arms.
struct SteadyState {
  SteadyResult result;
  ArmBalance arms;  // for elements with arms; else empty
};

/// Shape at the line's nodes in order of travel.
struct SteadyShape {
  NodeShape nodes;            // pressure in N/m
  std::vector<double> modes;  // m, [node][mode] for elements with arms; else empty
};

class SteadySolver {
 public:
  explicit SteadySolver(const Scene& scene);
  /// The tables of the arms refer to the law.
  SteadySolver(const SteadySolver&) = delete;
  SteadySolver& operator=(const SteadySolver&) = delete;

  const ElementLaw& law() const { return law_; }
  const RetardationModes& modes() const { return modes_; }

  /// Computes results[i] for velocities[i] (m/s, ascending); others: of another line; as
  /// slideSweep.
  bool sweep(const PreparedProfile& line, const Load& load, std::span<const double> velocities,
             std::span<SteadyResult> results, const std::stop_token& stop = {},
             std::span<const SteadyResult> others = {}) const;

  /// Computes several forces (N, ascending) on elements without arms; as slideAtForces.
  bool sweepForces(const PreparedProfile& line, std::span<const double> forces,
                   std::span<const double> velocities, std::span<SteadyResult> results,
                   const std::stop_token& stop = {},
                   std::span<const SteadyResult> others = {}) const;

  /// Returns the state under the scene's load. velocity: m/s, >= 0.
  SteadyState at(const PreparedProfile& line, double velocity) const;
  /// Return whether contact is complete at this depth (m), and the depth above which it is. Not for
  /// nodal.
  bool isComplete(const PreparedProfile& line, double depth, double velocity) const;
  double completeAbove(const PreparedProfile& line, double velocity) const;
  SteadyShape shape(const PreparedProfile& line, double velocity, const SteadyState& state) const;

 private:
  SlidingConditions conditions(double velocity) const;
  bool hasArmsAt(double velocity) const;
  bool sweepArms(const PreparedProfile& line, const Load& load, std::span<const double> velocities,
                 std::span<SteadyResult> results, const std::stop_token& stop) const;
  void countSteady(const Load& load) const;
  void addInterface(const PreparedProfile& line, double velocity, SteadyResult& result) const;

  Load load_;
  Interface interface_;
  double temperatureShift_;  // a_T
  bool hasInterface_, hasArms_;
  ElementLaw law_;
  RetardationModes modes_;
  std::unique_ptr<ArmTables> tables_;  // of elements with arms
};

}  // namespace asperity
