#include "core/friction/theories/persson_half_space.h"

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// Returns 1 - 1/sqrt(1 + a^2), also for small a.
double lostPart(double a) {
  const double root = std::hypot(1, a);
  return a / root * (a / (1 + root));
}

}  // namespace

PerssonHalfSpace::PerssonHalfSpace(const ElementLaw& law, const WaveSpectrum& spectrum,
                                   double nominalPressure)
    : law_(law), spectrum_(spectrum), pressure_(nominalPressure), glassy_(law.springModulus()) {
  for (const Arm& one : law.arms) {
    double sum = -2 * glassy_;
    for (const Arm& other : law.arms)
      sum += 2 * other.modulus * one.relaxationTime / (one.relaxationTime + other.relaxationTime);
    coupled_.push_back(one.modulus * sum);
  }
}

DirectionIntegrals PerssonHalfSpace::directionIntegrals(double frequency) const {
  // G* = glassy + i eta w c - sum G_i / (1 + i a_i c), c = cos phi, a_i = w tau_i. The integral of
  // 1 / (1 + a^2 c^2) over the circle is 2 pi / sqrt(1 + a^2); products of two arms fall into
  // partial fractions, a_i / (a_i + a_j) of the one and a_j / (a_i + a_j) of the other.
  const double viscous = law_.viscosity * frequency;
  double loss = viscous / 2, squared = glassy_ * glassy_ + viscous * viscous / 2;
  for (std::size_t i = 0; i < law_.arms.size(); ++i) {
    const double a = frequency * law_.arms[i].relaxationTime;
    const double lossOfArm = a > 0 ? law_.arms[i].modulus * lostPart(a) / a : 0;
    loss += lossOfArm;
    squared += coupled_[i] / std::hypot(1, a) + 2 * viscous * lossOfArm;
  }
  return {2 * std::numbers::pi * loss, 2 * std::numbers::pi * squared};
}

PerssonHalfSpace::Result PerssonHalfSpace::at(double velocity) const {
  constexpr double kGamma = 0.5;
  const double perPressure = 4 / pressure_;  // E / ((1 - nu^2) sigma_0) = perPressure G*
  double before = 0, mu = 0, contact = 1;
  for (const SpectralWave& wave : spectrum_.waves) {
    const DirectionIntegrals around = directionIntegrals(wave.waveNumber * velocity);
    // q^3 C2 dq = q^2 C_line dq / pi, and C_line dq is half of the wave's mean square.
    const double weight =
        wave.waveNumber * wave.waveNumber * wave.meanSquareHeight / (2 * std::numbers::pi);
    const double step = weight * perPressure * perPressure * around.squared / 8;
    const double middle = before + step / 2;  // g in the middle of the wave's share of q
    before += step;
    const double part = std::erf(1 / (2 * std::sqrt(middle)));
    mu += weight * (kGamma + (1 - kGamma) * part * part) * part * perPressure * around.loss / 2;
    contact = std::erf(1 / (2 * std::sqrt(before)));
  }
  return {mu, contact};
}

}  // namespace asperity
