#include "core/contact/arms/arm_vectors.h"

#include <algorithm>

namespace asperity {
namespace {

void copy(const std::vector<double>& from, double* to) {
  std::copy(from.begin(), from.end(), to);
}

}  // namespace

ArmVectors::ArmVectors(const ArmCoefficients& from)
    : arms(from.arms()),
      modes(from.modes()),
      slow(from.slow),
      dashpot(from.dashpot),
      glassy(from.glassy),
      own(from.own),
      arm(arms),
      mode(modes),
      decay(from.decay.size(), modes),
      lost(from.lost.size(), modes),
      toStrain(modes, arms),
      toCreep(modes, arms),
      ofCreep(arms, modes) {
  for (std::size_t i = 0; i < arms; ++i) {
    const double g = from.modulus[i];
    arm.value(Inverse, i) = from.inverse[i];
    arm.value(Modulus, i) = g;
    arm.value(LossRate, i) = from.lossRate[i];
    arm.value(Kept, i) = from.kept[i];
    const LossForm& loss = from.loss[i];
    arm.value(LossOfStrain, i) = g * loss.ee;
    for (std::size_t k = 0; k < 3; ++k) {
      arm.value(Driven0 + k, i) = from.driven[k][i];
      arm.value(Moment0 + k, i) = from.moment[k][i];
      arm.value(LossWith0 + k, i) = g * loss.ed[k];
    }
    for (std::size_t k = 0; k < 6; ++k) lossOfSlopes[k] += g * loss.dd[k];
  }
  for (std::size_t i = 0; i < slow; ++i) {
    arm.value(CreepKept, i) = from.creepKept[i];
    for (std::size_t k = 0; k < 3; ++k) arm.value(CreepDriven0 + k, i) = from.creepDriven[k][i];
  }
  for (std::size_t j = 0; j < modes; ++j) {
    mode.value(Rate, j) = from.rate[j];
    mode.value(Stiffness, j) = from.stiffness[j];
    mode.value(Settled, j) = from.settled[j];
  }
  for (std::size_t level = 0; level < from.decay.size(); ++level) {
    copy(from.decay[level], decay.row(level));
    copy(from.lost[level], lost.row(level));
  }
  const RetardationModes& conversion = from.conversion;
  for (std::size_t j = 0; j < modes; ++j)
    for (std::size_t i = 0; i < arms; ++i) {
      toStrain.row(j)[i] = conversion.toStrain[j * arms + i];
      toCreep.row(j)[i] = conversion.toCreep[j * arms + i];
      ofCreep.row(i)[j] = conversion.ofCreep[j * arms + i];
    }
}

ArmWorkspace::ArmWorkspace(const ArmVectors& vectors)
    : creepChange(vectors.arms), rows(Rows, std::max(vectors.arms, vectors.modes)) {}

// Not inline, so that what is compiled for one instruction set has no part in it.
void ArmWorkspace::addLength(double length) {
  lengths.push_back(length);
}

}  // namespace asperity
