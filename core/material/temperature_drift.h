// Sweeps during which the temperature drifted, as in a slow ramp that repeats its frequencies: each
// frequency has its own temperature then, and the sweep is no isotherm. Pure functions; any thread;
// equal input gives equal bits.
#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/material/isotherms.h"

namespace asperity {

/// An isotherm as it was measured, with the temperature of each of its points.
struct MeasuredSweep {
  Isotherm isotherm{};
  std::vector<double> temperatures{};  // K
};

/// Finds the sweeps whose temperature rises or falls with frequency by more than the tolerance (K)
/// and enters the drift; scatter without such a trend is none. Where other sweeps have the same
/// frequencies at lower and at higher temperatures, each modulus is interpolated between them, in
/// its logarithm, to one temperature: the mean of the sweep or, in the outermost sweeps, the one
/// closest to it that needs no extrapolation. sweeps: by rising temperature, farther apart than the
/// tolerance, each with rising frequencies.
void removeDrift(std::vector<MeasuredSweep>& sweeps, double tolerance);

/// Says in which isotherms the temperature drifts, and whether this was removed.
std::vector<Message> describeDrift(const std::vector<Isotherm>& isotherms);

}  // namespace asperity
