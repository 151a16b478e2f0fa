// The random modes of a line, amplitude exp(i phase), many at a time in the widest vectors of the
// machine; the phases are those of random_phase.h, bit for bit on every instruction set.
// Pure; any thread.
#pragma once

#include <complex>
#include <cstdint>
#include <span>

namespace asperity {

/// out[j] = amplitudes[j] (cos phase, sin phase) with the phase of mode j + 1; both of one length.
void randomModes(std::uint64_t seed, std::uint64_t realization, std::span<const double> amplitudes,
                 std::span<std::complex<double>> out);

/// Phases of the modes 2 first, 2 first + 1, ..., two for each of `pairs`.
void randomPhasesInto(std::uint64_t seed, std::uint64_t realization, std::uint64_t first,
                      std::size_t pairs, double* phases);

}  // namespace asperity
