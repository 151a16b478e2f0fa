// Random phases from a counter-based generator: the phase of a mode depends only on (seed,
// realization, mode). Lines are therefore the same for any number of threads, any order and any
// oversampling, and lines with more elements share their long waves with those that have fewer. The
// widest vectors of the machine compute many phases at a time, with the same bits on every
// instruction set.
// Source: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11 (Philox4x32-10).
// Pure; any thread.
#pragma once

#include <Random123/philox.h>

#include <complex>
#include <cstdint>
#include <numbers>
#include <span>

namespace asperity {

/// Two phases in [0, 2 pi), of modes 2 pair and 2 pair + 1.
struct PhasePair {
  double even, odd;
};

inline PhasePair randomPhases(std::uint64_t seed, std::uint64_t realization, std::uint64_t pair) {
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); };
  const r123::Philox4x32::ctr_type counter{
      {low(pair), high(pair), low(realization), high(realization)}};
  const r123::Philox4x32::key_type key{{low(seed), high(seed)}};
  const auto words = r123::Philox4x32()(counter, key);
  const auto angle = [](std::uint32_t upper, std::uint32_t lower) {
    const std::uint64_t bits = (std::uint64_t{upper} << 32 | lower) >> 11;  // 53 bits
    return static_cast<double>(bits) * 0x1p-53 * 2 * std::numbers::pi;
  };
  return {angle(words[0], words[1]), angle(words[2], words[3])};
}

/// Computes out[j] = amplitudes[j] (cos phase, sin phase) with the phase of mode j + 1; both have
/// the same length.
void randomModes(std::uint64_t seed, std::uint64_t realization, std::span<const double> amplitudes,
                 std::span<std::complex<double>> out);

/// Computes the phases of the modes 2 first, 2 first + 1, ..., two for each of `pairs`.
void randomPhasesInto(std::uint64_t seed, std::uint64_t realization, std::uint64_t first,
                      std::size_t pairs, double* phases);

}  // namespace asperity
