#include "core/friction/theories/complete_contact_friction.h"

#include <cmath>

namespace asperity {

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
