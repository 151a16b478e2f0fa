#include "core/friction/theories.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/statistics.h"

namespace asperity {

double WaveSpectrum::meanSquareHeight() const {
  double sum = 0;
  for (const SpectralWave& wave : waves) sum += wave.meanSquareHeight;
  return sum;
}

double WaveSpectrum::effectiveWaves() const {
  double squares = 0;
  for (const SpectralWave& wave : waves) squares += wave.meanSquareHeight * wave.meanSquareHeight;
  return meanSquareHeight() * meanSquareHeight() / squares;
}

double WaveSpectrum::meanSquareSlope() const {
  double sum = 0;
  for (const SpectralWave& wave : waves)
    sum += wave.waveNumber * wave.waveNumber * wave.meanSquareHeight;
  return sum;
}

WaveSpectrum waveSpectrum(const LineSource& source) {
  const FourierLine modes = modesOf(source);
  WaveSpectrum spectrum;
  for (std::size_t i = 0; i < modes.coefficients.size(); ++i)
    spectrum.waves.push_back({2 * std::numbers::pi * static_cast<double>(i + 1) / modes.length,
                              2 * std::norm(modes.coefficients[i])});
  return spectrum;
}

CompleteContactFriction completeContactFriction(const ElementLaw& law, const WaveSpectrum& spectrum,
                                                double lineForce, double velocity) {
  double loss = 0, variance = 0;
  for (const SpectralWave& wave : spectrum.waves) {
    const ComplexModulus modulus = complexModulus(law, wave.waveNumber * velocity);
    loss += wave.waveNumber * wave.meanSquareHeight * 4 * modulus.loss;
    variance += wave.meanSquareHeight * 16 *
                (modulus.storage * modulus.storage + modulus.loss * modulus.loss);
  }
  return {loss / lineForce, std::sqrt(variance)};
}

namespace {

/// Returns Mills's ratio Phi(-x) / phi(x) for x > 0 by its continued fraction (Abramowitz and
/// Stegun 26.2.14), which is exact to rounding for x >= 4 with this many terms.
double millsRatio(double x) {
  double fraction = x;
  for (int k = 60; k >= 1; --k) fraction = x + k / fraction;
  return 1 / fraction;
}

}  // namespace

double gaussianContactFraction(double delta) {
  return normalProbability(delta);
}

double gaussianLoad(double delta) {
  // Both terms nearly cancel far above the surface: there phi (1 - x Mills(x)) with
  // 1 - x M = M (fraction - x), which loses nothing.
  constexpr double kFar = -4;
  if (delta > kFar) return normalDensity(delta) + delta * gaussianContactFraction(delta);
  const double x = -delta;
  return normalDensity(x) * millsRatio(x) * (1 / millsRatio(x) - x);
}

double gaussianDepth(double load) {
  // Newton's method on the logarithm of the load, which is a concave function of the depth; from
  // the left of the root it does not overshoot.
  double delta = load > 1 ? load - 1 : -1;
  if (load <= 1)
    while (gaussianLoad(delta) > load) delta *= 2;
  for (int i = 0; i < 200; ++i) {
    const double now = gaussianLoad(delta);
    const double step = now / gaussianContactFraction(delta) * std::log(load / now);
    delta += step;
    if (std::abs(step) <= 1e-15 * (1 + std::abs(delta))) break;
  }
  return delta;
}

double zeroFrequencyViscosity(const ElementLaw& law) {
  double viscosity = law.viscosity;
  for (const Arm& arm : law.arms) viscosity += arm.modulus * arm.relaxationTime;
  return viscosity;
}

GaussianFoundation gaussianFoundation(const ElementLaw& law, double meanSquareHeight,
                                      double meanSquareSlope, double lineForce) {
  if (!(law.equilibriumModulus > 0) || !(meanSquareHeight > 0) || !(lineForce > 0))
    return {kNaN, kNaN, kNaN};
  const double delta =
      gaussianDepth(lineForce / (4 * law.equilibriumModulus * std::sqrt(meanSquareHeight)));
  GaussianFoundation found;
  found.contactFraction = gaussianContactFraction(delta);
  found.slope =
      4 * zeroFrequencyViscosity(law) * found.contactFraction * meanSquareSlope / lineForce;
  constexpr double kBend = 0.05;
  const double plateau = std::sqrt(std::numbers::pi / 2 * meanSquareSlope);
  found.validBelow = found.slope > 0
                         ? plateau * std::sqrt((1 + kBend) * (1 + kBend) - 1) / found.slope
                         : std::numeric_limits<double>::infinity();
  return found;
}

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
