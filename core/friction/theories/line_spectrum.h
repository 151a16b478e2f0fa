// The spectrum of a scene's line as theories need it, mean squares of its waves without phases, and
// the friction that it alone determines: that of complete contact, for any linear rheology. There
// the surface of the elastomer is the line itself, each wave of it is a harmonic deformation at the
// angular frequency q v, and the losses of all waves add up:
//   mu F_N = 2 L integral_0^inf q C(q) 4 G''(q v) dq.
// The pressure is p = F_N / L + 4 sum |G*(q v)| times the waves; contact is complete where it is
// above 0 everywhere. Plain values; pure functions; any thread.
#pragma once

#include <vector>

#include "core/material/element_law.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One wave of the line z = sum a_k cos(q_k x + phase_k).
struct SpectralWave {
  double waveNumber = 0;        // 1/m, q_k
  double meanSquareHeight = 0;  // m^2, a_k^2 / 2 = 2 C(q_k) dq
};

struct WaveSpectrum {
  std::vector<SpectralWave> waves;  // rising wave numbers

  double meanSquareHeight() const;  // m^2, <h^2>
  double meanSquareSlope() const;   // <z'^2>
  /// Returns how many waves of one height would have heights as far from Gaussian ones as these
  /// have: the square of the sum of their mean square heights over the sum of the squares.
  double effectiveWaves() const;
};

/// Returns the spectrum of realization 0. Random lines differ only in their phases, unless the
/// scene has a summit correlation. A line given by a formula is analysed at its nodes.
WaveSpectrum waveSpectrum(const LineSource& source);

struct CompleteContactFriction {
  double mu = 0;
  double rmsPressure = 0;  // N/m, of the pressure's variation about its mean F_N / L
};

/// Returns the friction at a velocity (m/s). lineForce: F_N / L in N/m, above 0.
CompleteContactFriction completeContactFriction(const ElementLaw& law, const WaveSpectrum& spectrum,
                                                double lineForce, double velocity);

}  // namespace asperity
