// The pass of arm_pass.h and its derivatives, compiled for several instruction sets with the arms
// in the lanes of vectors. The best set of the machine is chosen at run time (kernels.h). Results
// agree with the readable ArmPass and ArmTangent to rounding, and differ in the last digits between
// instruction sets. Threading: these are functions of their arguments. A workspace belongs to one
// thread.
#pragma once

#include <span>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Runs one pass at an indentation (m), from these strains (m, one for each arm) at the lowest
/// point. Output::Force: only sums.depth, lengths and creepChange are computed.
void runArmPass(const PreparedProfile& line, const ArmVectors& vectors, double depth,
                std::span<const double> strain, Output output, ArmWorkspace& work);

/// Finds the strains (m) at the lowest point in complete contact, as ArmPass::completeStrains.
void findCompleteStrains(const PreparedProfile& line, const ArmVectors& vectors,
                         std::span<double> strain, ArmWorkspace& work);

/// The derivatives of the result of a pass, and the memory to compute them in.
struct ArmJacobian {
  explicit ArmJacobian(const ArmVectors& vectors);

  /// Return derivatives. Unknown 0 is the indentation, 1 + k the strain of arm k at the lowest
  /// point.
  double ofDepthIntegral(std::size_t unknown) const { return volume.row(0)[unknown]; }
  double ofCreepChange(std::size_t i, std::size_t unknown) const { return change.row(i)[unknown]; }

  AlignedRows volume, change;      // [arm] over unknowns
  AlignedRows strain, mode, lost;  // [arm or mode] over unknowns, at one position of the pass
};

/// Finds the derivatives of the last pass that was run in `work`.
void findArmJacobian(const ArmVectors& vectors, const ArmWorkspace& work, ArmJacobian& jacobian);

}  // namespace asperity
