// Lines as sums of Fourier modes: spectra of self-affine lines, and the transforms to nodes and
// back. Pure functions except for the transforms.
// Convention: C(q) is the two-sided one-dimensional power spectral density with h^2 = 2 integral C
// dq and grad^2 = 2 integral C q^2 dq (Li et al. 2013).
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace asperity {

class FourierPlans;

/// A band-limited line z(x) = 2 Re sum_{k>=1} c_k exp(i q_k x), q_k = 2 pi k / length; its mean is
/// 0.
struct FourierLine {
  double length = 0;                               // m
  std::vector<std::complex<double>> coefficients;  // m; entry j is c_{j+1}
};

/// Returns the number of modes that N elements can represent: 1 to below N/2, without the Nyquist
/// mode.
std::size_t modeCount(std::size_t elements);

/// Returns the amplitudes a_k (m) of z = sum a_k cos(q_k x + phase_k), k = 1 ...
/// modeCount(elements), with C(q) ~ q^(-2H-1), constant below mode number `rollOff`, and sum a_k^2
/// / 2 = rmsHeight^2 exactly.
std::vector<double> selfAffineAmplitudes(std::size_t elements, double hurst, double rmsHeight,
                                         double rollOff = 0);

double rmsHeight(const FourierLine& line);  // m
double rmsSlope(const FourierLine& line);

/// Transforms Fourier modes to equally spaced nodes and back, by FFTW with estimated plans, so that
/// equal input gives equal bits in every run. Threading: several threads may use it at once; making
/// one is serialised inside (FFTW's planner is not reentrant).
class FourierTransform {
 public:
  explicit FourierTransform(std::size_t nodes);

  std::size_t nodes() const;

  /// Computes the height (m) of the line at x_i = i length / nodes. Modes above the nodes' Nyquist
  /// limit must be absent. Returns false where `stop` was requested, which is checked before and
  /// after the transform; the heights are then missing.
  bool evaluate(const FourierLine& line, std::vector<double>& height,
                const std::stop_token& stop = {}) const;

  /// Computes the slope of the line there, from the spectrum; otherwise as evaluate().
  bool evaluateSlope(const FourierLine& line, std::vector<double>& slope,
                     const std::stop_token& stop = {}) const;

  /// Returns the band-limited line through the nodes: without the mean and without the Nyquist
  /// mode.
  FourierLine analyse(std::span<const double> height, double length) const;

 private:
  template <class Factor>
  bool transform(const FourierLine& line, std::vector<double>& target, const Factor& factor,
                 const std::stop_token& stop) const;

  std::shared_ptr<const FourierPlans> plans_;
};

/// Returns a line whose short waves are stronger on the summits, or in the valleys, of its long
/// waves, as on worn or filled surfaces, with the same rms height. A line of random phases has no
/// such correlation. It is not a model of any one process: it shows what a spectrum alone does not
/// determine. z = z_long + z_short sqrt(1 + kappa m), m = -z_long / rms(z_long), with |kappa m|
/// limited to below 1; long and short waves are separated at the geometric mean of the lowest and
/// the highest wave number; the result is cut to the modes of `line` and scaled to its rms height.
/// kappa > 0: rougher on the summits, which are the low points of the line and touch first. `fine`
/// evaluates the line at several nodes per shortest wave.
FourierLine withSummitCorrelation(const FourierLine& line, double kappa,
                                  const FourierTransform& fine);

}  // namespace asperity
