#include "core/surface/fourier.h"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <numbers>

namespace asperity {
namespace {

std::mutex& plannerLock() {
  static std::mutex lock;
  return lock;
}

/// Aligned as FFTW likes it, so that every call takes the same code path.
template <class Value>
struct Buffer {
  explicit Buffer(std::size_t count)
      : values(static_cast<Value*>(fftw_malloc(sizeof(Value) * count))) {
    if (!values) throw std::bad_alloc();
  }
  ~Buffer() { fftw_free(values); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Value* values;
};

using Complex = std::complex<double>;

fftw_complex* raw(Complex* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

}  // namespace

struct FourierTransform::Plans {
  explicit Plans(std::size_t count) : nodes(count) {
    const Buffer<Complex> modes(count / 2 + 1);
    const Buffer<double> values(count);
    const std::lock_guard lock(plannerLock());
    const int size = static_cast<int>(count);
    toNodes = fftw_plan_dft_c2r_1d(size, raw(modes.values), values.values, FFTW_ESTIMATE);
    toModes = fftw_plan_dft_r2c_1d(size, values.values, raw(modes.values), FFTW_ESTIMATE);
  }
  ~Plans() {
    const std::lock_guard lock(plannerLock());
    fftw_destroy_plan(toNodes);
    fftw_destroy_plan(toModes);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  std::size_t nodes;
  fftw_plan toNodes, toModes;
};

FourierTransform::FourierTransform(std::size_t nodes) : plans_(std::make_unique<Plans>(nodes)) {}
FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;

std::size_t FourierTransform::nodes() const {
  return plans_->nodes;
}

void FourierTransform::evaluate(const FourierLine& line, std::vector<double>& height,
                                std::vector<double>& slope) const {
  const std::size_t count = plans_->nodes;
  const Buffer<Complex> modes(count / 2 + 1);
  const Buffer<double> values(count);
  const auto transform = [&](std::vector<double>& target, auto factor) {
    modes.values[0] = 0;
    for (std::size_t k = 1; k <= count / 2; ++k)
      modes.values[k] =
          k <= line.coefficients.size() ? line.coefficients[k - 1] * factor(k) : Complex(0);
    fftw_execute_dft_c2r(plans_->toNodes, raw(modes.values), values.values);
    target.assign(values.values, values.values + count);
  };
  transform(height, [](std::size_t) { return 1.0; });
  const double lowest = 2 * std::numbers::pi / line.length;
  transform(slope, [lowest](std::size_t k) { return Complex(0, lowest * static_cast<double>(k)); });
}

FourierLine FourierTransform::analyse(std::span<const double> height, double length) const {
  const std::size_t count = plans_->nodes;
  const Buffer<Complex> modes(count / 2 + 1);
  const Buffer<double> values(count);
  std::copy_n(height.begin(), count, values.values);
  fftw_execute_dft_r2c(plans_->toModes, values.values, raw(modes.values));
  FourierLine line{length, {}};
  for (std::size_t k = 1; k <= modesOf(count); ++k)
    line.coefficients.push_back(modes.values[k] / static_cast<double>(count));
  return line;
}

}  // namespace asperity
