// Lines whose short waves are stronger on the summits, or in the valleys, of their long ones, as
// of worn or of filled surfaces. Same rms height; a line of random phases has no such correlation.
// Not a model of any one process: it shows what a spectrum alone does not say.
#pragma once

#include "core/surface/fourier.h"
#include "core/surface/spectrum.h"

namespace asperity {

/// z = z_long + z_short sqrt(1 + kappa m), m = -z_long / rms(z_long), |kappa m| kept below 1; long
/// and short part at the geometric mean of the lowest and the highest wave number; then cut to the
/// modes of `line` and scaled to its rms height. kappa > 0: rougher on the summits, which are the
/// low places and touch first. `fine` evaluates it at several nodes per shortest wave.
FourierLine withSummitCorrelation(const FourierLine& line, double kappa,
                                  const FourierTransform& fine);

}  // namespace asperity
