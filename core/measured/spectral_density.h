// A power spectral density between the points of a table or in the bins of a periodogram, and the
// waves of a line that have it. Pure functions; any thread. C1 is two-sided per wave number, <h^2>
// = 2 integral C1 dq.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A density over wave numbers, nothing outside: either linear between its points in double
/// logarithm, or constant in bins, of which its values are the means.
struct SpectralDensity {
  std::vector<double> waveNumber;  // 1/m, ascending, above 0
  std::vector<double> density;     // m^3, C1, two-sided, per wave number; not below 0
  std::vector<double> binEdge{};   // 1/m, one more than values; empty: no bins

  bool empty() const { return waveNumber.empty(); }
  /// Integral of C1 from the lowest wave number to q; m^2.
  double integralTo(double q) const;
  double integral() const;  // m^2
};

/// Edges of the bins for which the waves of a periodogram stand, half-way between neighbours: where
/// the wave numbers are whole multiples of one step (at least 4 of them, 9 of 10 one step apart
/// within the rounding of a table). Then <h^2> is 2 sum C1 dq, whatever the values scatter; power
/// laws between them would lose a part of it. Empty for any other wave numbers, which ascend.
std::vector<double> findBinEdges(std::span<const double> waveNumbers);

/// The part of a density between two wave numbers, with points or edges of bins at its ends.
SpectralDensity within(const SpectralDensity& density, double lowest, double highest);

/// Magnitudes |c_k| (m), k = 1 ... modes, of waves of a line of this length, z = 2 Re sum c_k
/// exp(i q_k x): |c_k|^2 is the integral of C1 over the band of wave numbers about q_k, so that
/// the line has the height of the density in the band that it carries.
std::vector<double> modeMagnitudes(const SpectralDensity& density, double length,
                                   std::size_t modes);

}  // namespace asperity
