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
      arm(ArmRows, arms),
      mode(ModeRows, modes),
      decay(from.decay.size(), modes),
      lost(from.lost.size(), modes),
      toStrain(modes, arms),
      toYield(modes, arms),
      ofYield(arms, modes) {
  copy(from.inverse, arm.row(Inverse));
  copy(from.modulus, arm.row(Modulus));
  copy(from.lossRate, arm.row(LossRate));
  copy(from.kept, arm.row(Kept));
  copy(from.yieldKept, arm.row(YieldKept));
  for (std::size_t k = 0; k < 3; ++k) {
    copy(from.driven[k], arm.row(Driven0 + k));
    copy(from.yieldDriven[k], arm.row(YieldDriven0 + k));
    copy(from.moment[k], arm.row(Moment0 + k));
  }
  for (std::size_t i = 0; i < arms; ++i) {
    const LossForm& loss = from.loss[i];
    const double g = from.modulus[i];
    arm.row(LossOfStrain)[i] = g * loss.ee;
    for (std::size_t k = 0; k < 3; ++k) arm.row(LossWith0 + k)[i] = g * loss.ed[k];
    for (std::size_t k = 0; k < 6; ++k) lossOfSlopes[k] += g * loss.dd[k];
  }
  copy(from.rate, mode.row(Rate));
  copy(from.stiffness, mode.row(Stiffness));
  copy(from.settled, mode.row(Settled));
  for (std::size_t level = 0; level < from.decay.size(); ++level) {
    copy(from.decay[level], decay.row(level));
    copy(from.lost[level], lost.row(level));
  }
  const RetardationModes& conversion = from.conversion;
  for (std::size_t j = 0; j < modes; ++j)
    for (std::size_t i = 0; i < arms; ++i) {
      toStrain.row(j)[i] = conversion.toStrain[j * arms + i];
      toYield.row(j)[i] = conversion.toYield[j * arms + i];
      ofYield.row(i)[j] = conversion.ofYield[j * arms + i];
    }
}

ArmWorkspace::ArmWorkspace(const ArmVectors& vectors)
    : yieldChange(vectors.arms), rows(Rows, std::max(vectors.arms, vectors.modes)) {}

// Not inline, so that what is compiled for one instruction set has no part in it.
void ArmWorkspace::addLength(double length) {
  lengths.push_back(length);
}

}  // namespace asperity
