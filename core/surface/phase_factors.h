// amplitude exp(i phase) for many modes at once, in the widest vectors of the machine.
// Pure; any thread.
#pragma once

#include <complex>
#include <span>

namespace asperity {

/// out[j] = amplitudes[j] (cos phases[j], sin phases[j]); all of one length; |phase| below 1e4.
void phaseFactors(std::span<const double> amplitudes, std::span<const double> phases,
                  std::span<std::complex<double>> out);

}  // namespace asperity
