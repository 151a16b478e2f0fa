// Discrete Fourier transforms of real numbers by FFTW, with estimated plans, so that the same input
// gives the same bits in every run.
// Threading: a transform may be used by several threads at once; making and destroying one is
// serialised inside, because FFTW's planner is not reentrant.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace asperity {

/// Held by everyone who makes or destroys a plan of FFTW.
std::mutex& fourierPlannerLock();

/// The next number of points, not below `count`, that has no prime factor above 5: transforms of so
/// many points are fast.
std::size_t fastTransformSize(std::size_t count);

/// X_k = sum_j x_j exp(-2 pi i j k / n), k = 0 ... n/2, and back (without the factor 1/n).
class RealTransform {
 public:
  explicit RealTransform(std::size_t points);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;

  std::size_t points() const;
  std::size_t modes() const { return points() / 2 + 1; }

  /// values: n numbers.
  std::vector<std::complex<double>> forward(std::span<const double> values) const;
  /// modes: n/2 + 1 numbers, which are used up.
  std::vector<double> backward(std::vector<std::complex<double>> modes) const;

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

/// The transform of rows x columns numbers, row by row: rows x (columns/2 + 1) modes.
std::vector<std::complex<double>> transform2d(std::span<const double> values, std::size_t rows,
                                              std::size_t columns);

}  // namespace asperity
