// Discrete Fourier transforms of real numbers by FFTW, with estimated plans, so that the same input
// gives the same bits in every run.
// Threading: a transform may be used by several threads at once; making and destroying one is
// serialised inside, because FFTW's planner is not reentrant. The last plans of moderate size are
// kept for the process.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

struct fftw_plan_s;

namespace asperity {

/// FFTW's plans of both directions for transforms of one size. An aligned plan is faster, but takes
/// only arrays from fftw_malloc; the other one takes arrays of any alignment by the same
/// operations, so that equal input gives equal bits there, too.
class FourierPlans {
 public:
  enum class Arrays { Aligned, Any };
  /// Returns the plans for a size. Those that were used last are kept, because planning takes
  /// longer than the transforms of a few lines.
  static std::shared_ptr<const FourierPlans> forSize(std::size_t points, Arrays arrays);
  FourierPlans(std::size_t points, Arrays arrays);
  ~FourierPlans();
  FourierPlans(const FourierPlans&) = delete;
  FourierPlans& operator=(const FourierPlans&) = delete;

  std::size_t points() const { return points_; }
  Arrays arrays() const { return arrays_; }
  /// Computes X_k = sum_j x_j exp(-2 pi i j k / n), k = 0 ... n/2. The values are not changed.
  void forward(const double* values, std::complex<double>* modes) const;
  /// Transforms back, without the factor 1/n. The modes are overwritten.
  void backward(std::complex<double>* modes, double* values) const;

 private:
  std::size_t points_;
  Arrays arrays_;
  // Each plan is made when its direction is used first: most users need only one.
  mutable std::once_flag isForwardMade_, isBackwardMade_;
  mutable fftw_plan_s *forward_ = nullptr, *backward_ = nullptr;
};

/// Returns the next number of points, not below `count`, that has no prime factor above 5:
/// transforms of such sizes are fast.
std::size_t fastTransformSize(std::size_t count);

/// X_k = sum_j x_j exp(-2 pi i j k / n), k = 0 ... n/2, and back (without the factor 1/n).
class RealTransform {
 public:
  explicit RealTransform(std::size_t points)
      : plans_(FourierPlans::forSize(points, FourierPlans::Arrays::Any)) {}

  std::size_t points() const { return plans_->points(); }
  std::size_t modes() const { return points() / 2 + 1; }

  /// values: n numbers.
  std::vector<std::complex<double>> forward(std::span<const double> values) const;
  /// modes: n/2 + 1 numbers, which are overwritten.
  std::vector<double> backward(std::vector<std::complex<double>> modes) const;

 private:
  std::shared_ptr<const FourierPlans> plans_;
};

/// Returns the transform of rows x columns numbers, row by row: rows x (columns/2 + 1) modes.
std::vector<std::complex<double>> transform2d(std::span<const double> values, std::size_t rows,
                                              std::size_t columns);

}  // namespace asperity
