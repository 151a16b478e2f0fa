// Sweeps during which the temperature drifted, as in a slow ramp that repeats its frequencies: each
// frequency has its own temperature then, and the sweep is no isotherm. Ramps without steps have no
// sweeps at all. Pure functions; any thread; equal input gives equal bits.
#pragma once

#include <cstddef>
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

/// Returns isotherms of slow ramps of temperature that repeat a few frequencies, by rising
/// temperature: at each of them the moduli of each frequency are interpolated, in their logarithm,
/// between those measured at neighbouring temperatures. The isotherms are 3 K apart, or as far as
/// the temperatures of one frequency. Values of one frequency at temperatures within the tolerance
/// (K) count as one, their geometric mean. Empty where there are fewer than two frequencies, or one
/// of them has too few temperatures or a gap among them.
std::vector<Isotherm> isothermsOfRamp(const std::vector<MeasuredModulus>& rows, double tolerance);

/// Leaves out the ramps of temperature at one frequency that stand beside sweeps in one file, whose
/// rows are in its order; returns how many rows these are. A ramp is a run of rows of one frequency
/// over more than six tolerances (K). Nothing is left out unless the other rows are at least two
/// isotherms.
std::size_t leaveOutRamps(std::vector<MeasuredModulus>& rows, double tolerance);

/// Says which isotherms were interpolated between ramps, in which ones the temperature drifts, and
/// whether this was removed.
std::vector<Message> describeDrift(const std::vector<Isotherm>& isotherms);

}  // namespace asperity
