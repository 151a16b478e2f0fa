// The spectrum of a scene's line, as theories need it: mean squares of its waves, without phases.
// Plain values; pure functions; any thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/line_source.h"

namespace asperity {

/// One wave of the line z = sum a_k cos(q_k x + phase_k).
struct SpectralWave {
  double waveNumber = 0;        // 1/m, q_k
  double meanSquareHeight = 0;  // m^2, a_k^2 / 2 = 2 C1(q_k) dq
};

struct WaveSpectrum {
  std::vector<SpectralWave> waves;  // rising wave numbers

  double meanSquareHeight() const;  // m^2, <h^2>
  double meanSquareSlope() const;   // <z'^2>
};

/// Returns the spectrum of realization 0. Random lines differ only in their phases, unless the
/// scene has a summit correlation. A line given by a formula is analysed at its nodes.
WaveSpectrum waveSpectrum(const LineSource& source);

}  // namespace asperity
