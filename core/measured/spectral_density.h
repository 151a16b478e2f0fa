// A power spectral density, given at the points of a table or in the bins of a periodogram, and the
// waves of a line that has this density. Pure functions; any thread. C1 is two-sided per wave
// number, <h^2> = 2 integral C1 dq.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A density over wave numbers; it is 0 outside of them. It is either linear between its points in
/// double logarithm, or constant in bins, of which its values are the means.
struct SpectralDensity {
  std::vector<double> waveNumber;  // 1/m, ascending, above 0
  std::vector<double> density;     // m^3, C1, two-sided, per wave number; not below 0
  std::vector<double> binEdge{};   // 1/m, one more than values; empty: no bins

  bool empty() const { return waveNumber.empty(); }
  /// Returns the integral of C1 from the lowest wave number to q; m^2.
  double integralTo(double q) const;
  double integral() const;  // m^2
};

/// Returns the edges of the bins of a periodogram, half-way between neighbouring wave numbers. A
/// table is a periodogram where its wave numbers are whole multiples of one step (at least 4 of
/// them, 9 of 10 one step apart, within the rounding of a table). With bins, <h^2> is 2 sum C1 dq,
/// however much the values scatter; power laws between the points would lose a part of it. Empty
/// for any other wave numbers. waveNumbers: ascending, 1/m.
std::vector<double> findBinEdges(std::span<const double> waveNumbers);

/// Returns the part of a density between two wave numbers, with points or edges of bins at its
/// ends.
SpectralDensity within(const SpectralDensity& density, double lowest, double highest);

/// Returns the magnitudes |c_k| (m), k = 1 ... modes, of the waves of a line of this length (m), z
/// = 2 Re sum c_k exp(i q_k x). |c_k|^2 is the integral of C1 over the band of wave numbers around
/// q_k, so that the line has the mean square height of the density in the bands that it represents.
std::vector<double> modeMagnitudes(const SpectralDensity& density, double length,
                                   std::size_t modes);

}  // namespace asperity
