#include "core/base/fourier.h"

#include <fftw3.h>

namespace asperity {
namespace {

fftw_complex* raw(std::complex<double>* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

/// FFTW does not write to the input of transforms that are told to keep it.
double* writable(std::span<const double> values) {
  return const_cast<double*>(values.data());
}

// The same plan serves arrays of any alignment, so that the same input gives the same bits.
constexpr unsigned kForward = FFTW_ESTIMATE | FFTW_UNALIGNED | FFTW_PRESERVE_INPUT;
constexpr unsigned kBackward = FFTW_ESTIMATE | FFTW_UNALIGNED | FFTW_DESTROY_INPUT;

}  // namespace

std::mutex& fourierPlannerLock() {
  static std::mutex lock;
  return lock;
}

std::size_t fastTransformSize(std::size_t count) {
  for (std::size_t size = count;; ++size) {
    std::size_t rest = size;
    for (const std::size_t factor : {2U, 3U, 5U})
      while (rest > 1 && rest % factor == 0) rest /= factor;
    if (rest <= 1 && size > 0) return size;
  }
}

struct RealTransform::Plans {
  explicit Plans(std::size_t count) : points(count) {
    std::vector<double> values(count);
    std::vector<std::complex<double>> modes(count / 2 + 1);
    const std::lock_guard lock(fourierPlannerLock());
    const int size = static_cast<int>(count);
    forward = fftw_plan_dft_r2c_1d(size, values.data(), raw(modes.data()), kForward);
    backward = fftw_plan_dft_c2r_1d(size, raw(modes.data()), values.data(), kBackward);
  }
  ~Plans() {
    const std::lock_guard lock(fourierPlannerLock());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  std::size_t points;
  fftw_plan forward, backward;
};

RealTransform::RealTransform(std::size_t points) : plans_(std::make_unique<Plans>(points)) {}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;

std::size_t RealTransform::points() const {
  return plans_->points;
}

std::vector<std::complex<double>> RealTransform::forward(std::span<const double> values) const {
  std::vector<std::complex<double>> modes(this->modes());
  fftw_execute_dft_r2c(plans_->forward, writable(values), raw(modes.data()));
  return modes;
}

std::vector<double> RealTransform::backward(std::vector<std::complex<double>> modes) const {
  std::vector<double> values(points());
  fftw_execute_dft_c2r(plans_->backward, raw(modes.data()), values.data());
  return values;
}

std::vector<std::complex<double>> transform2d(std::span<const double> values, std::size_t rows,
                                              std::size_t columns) {
  std::vector<std::complex<double>> modes(rows * (columns / 2 + 1));
  fftw_plan plan = nullptr;
  {
    const std::lock_guard lock(fourierPlannerLock());
    plan = fftw_plan_dft_r2c_2d(static_cast<int>(rows), static_cast<int>(columns), writable(values),
                                raw(modes.data()), FFTW_ESTIMATE | FFTW_UNALIGNED);
  }
  fftw_execute(plan);
  const std::lock_guard lock(fourierPlannerLock());
  fftw_destroy_plan(plan);
  return modes;
}

}  // namespace asperity
