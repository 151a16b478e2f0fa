#include "core/contact/arms/arm_coefficients.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kSlowFrom = 10;  // periods of memory
/// Elements of memory below which everything is forgotten to the last digit, and numbers may end.
constexpr double kLeastMemory = 1e-150;

}  // namespace

ArmCoefficients::ArmCoefficients(const ElementLaw& law, const RetardationModes& modes,
                                 double velocity, double spacing, double period, std::size_t levels)
    : dashpot(velocity * law.viscosity / law.equilibriumModulus), conversion(modes) {
  const double shortest = kLeastMemory * spacing;
  for (const Arm& arm : law.arms) {
    const double g = arm.modulus / law.equilibriumModulus;
    const double inverseLength = 1 / std::max(velocity * arm.relaxationTime, shortest);
    const double z = spacing * inverseLength;
    modulus.push_back(g);
    inverse.push_back(inverseLength);
    lossRate.push_back(g * inverseLength);
    glassy += g;
    const DrivenDecay decayed = drivenDecay(z);
    const auto moments = decayMoments(z);
    const auto drivenBy = drivenMoments(z);
    kept.push_back(decayed.kept);
    loss.push_back(lossForm(z));
    if (period * inverseLength * kSlowFrom < 1) {
      ++slow;
      yieldKept.push_back(z * moments[0]);
      for (std::size_t k = 0; k < 3; ++k) yieldDriven[k].push_back(z * drivenBy[0][k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      driven[k].push_back(decayed.driven[k]);
      moment[k].push_back(g * moments[k]);
      for (std::size_t l = 0; l < 3; ++l) own[k][l] += g * drivenBy[k][l];
    }
  }
  for (std::size_t j = 0; j < modes.modes(); ++j) {
    rate.push_back(std::min(modes.rate[j] / velocity, 1 / shortest));
    stiffness.push_back(modes.rate[j] / (modes.fluidity[j] * law.equilibriumModulus));
    settled.push_back(1 / stiffness.back());
  }
  double blockLength = spacing;
  for (std::size_t level = 0; level < levels; ++level, blockLength *= 4) {
    std::vector<double> left, gone;
    for (const double perMetre : rate) {
      left.push_back(std::exp(-perMetre * blockLength));
      gone.push_back(-std::expm1(-perMetre * blockLength));
    }
    decay.push_back(std::move(left));
    lost.push_back(std::move(gone));
  }
}

}  // namespace asperity
