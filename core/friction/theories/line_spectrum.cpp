#include "core/friction/theories/line_spectrum.h"

#include <cmath>
#include <numbers>

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

}  // namespace asperity
