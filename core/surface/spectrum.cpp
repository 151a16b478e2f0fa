#include "core/surface/spectrum.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/fourier.h"

namespace asperity {
namespace {

/// Memory aligned for FFTW, so that every call takes the same code path. It grows and is kept.
template <class Value>
class Buffer {
 public:
  Buffer() = default;
  ~Buffer() { fftw_free(values); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  Value* values = nullptr;

  void reserve(std::size_t count) {
    if (count <= size_) return;
    fftw_free(values);
    size_ = 0;
    values = static_cast<Value*>(fftw_malloc(sizeof(Value) * count));
    if (!values) throw std::bad_alloc();
    size_ = count;
  }

 private:
  std::size_t size_ = 0;
};

using Complex = std::complex<double>;

/// Memory of each thread, which many lines of one ensemble share: allocating fresh pages costs more
/// than a transform.
struct Buffers {
  Buffer<Complex> modes;
  Buffer<double> values;
};

/// Returns the memory of the thread; for very long lines `own`, because a process makes few of them
/// and their memory is better free than kept.
Buffers& buffersFor(std::size_t nodes, Buffers& own) {
  constexpr std::size_t kMostKept = std::size_t{1} << 22;
  thread_local Buffers kept;
  Buffers& buffers = nodes > kMostKept ? own : kept;
  buffers.modes.reserve(nodes / 2 + 1);
  buffers.values.reserve(nodes);
  return buffers;
}

constexpr double kLargest = 0.99;  // of |kappa m|

/// Returns the modes from `first` to below `end`, counted from 1; the others are 0.
FourierLine partOf(const FourierLine& line, std::size_t first, std::size_t end) {
  FourierLine part{line.length, std::vector<std::complex<double>>(line.coefficients.size())};
  for (std::size_t k = first; k < end; ++k) part.coefficients[k - 1] = line.coefficients[k - 1];
  return part;
}

}  // namespace

std::size_t modeCount(std::size_t elements) {
  return (elements - 1) / 2;
}

std::vector<double> selfAffineAmplitudes(std::size_t elements, double hurst, double rmsHeight,
                                         double rollOff) {
  std::vector<double> amplitudes(modeCount(elements));
  double sum = 0;
  for (std::size_t j = amplitudes.size(); j-- > 0;) {  // small terms first
    const double density = std::pow(std::max(static_cast<double>(j + 1), rollOff), -2 * hurst - 1);
    amplitudes[j] = std::sqrt(density);
    sum += density;
  }
  const double factor = rmsHeight * std::sqrt(2 / sum);
  for (double& amplitude : amplitudes) amplitude *= factor;
  return amplitudes;
}

double rmsHeight(const FourierLine& line) {
  double sum = 0;
  for (std::size_t j = line.coefficients.size(); j-- > 0;) sum += std::norm(line.coefficients[j]);
  return std::sqrt(2 * sum);
}

double rmsSlope(const FourierLine& line) {
  double sum = 0;
  for (std::size_t j = line.coefficients.size(); j-- > 0;) {
    const double mode = static_cast<double>(j + 1);
    sum += std::norm(line.coefficients[j]) * mode * mode;
  }
  return 2 * std::numbers::pi / line.length * std::sqrt(2 * sum);
}

FourierTransform::FourierTransform(std::size_t nodes)
    : plans_(FourierPlans::forSize(nodes, FourierPlans::Arrays::Aligned)) {}

std::size_t FourierTransform::nodes() const {
  return plans_->points();
}

bool FourierTransform::evaluate(const FourierLine& line, std::vector<double>& height,
                                const std::stop_token& stop) const {
  return transform(
      line, height, [](std::size_t) { return 1.0; }, stop);
}

bool FourierTransform::evaluateSlope(const FourierLine& line, std::vector<double>& slope,
                                     const std::stop_token& stop) const {
  const double lowest = 2 * std::numbers::pi / line.length;
  return transform(
      line, slope, [lowest](std::size_t k) { return Complex(0, lowest * static_cast<double>(k)); },
      stop);
}

template <class Factor>
bool FourierTransform::transform(const FourierLine& line, std::vector<double>& target,
                                 const Factor& factor, const std::stop_token& stop) const {
  const std::size_t count = plans_->points(), filled = line.coefficients.size();
  Buffers own;
  const Buffers& buffers = buffersFor(count, own);
  Complex* modes = buffers.modes.values;
  modes[0] = 0;
  for (std::size_t k = 1; k <= filled; ++k) modes[k] = line.coefficients[k - 1] * factor(k);
  std::fill(modes + filled + 1, modes + count / 2 + 1, Complex(0));
  if (stop.stop_requested()) return false;
  plans_->backward(modes, buffers.values.values);
  if (stop.stop_requested()) return false;
  target.assign(buffers.values.values, buffers.values.values + count);
  return true;
}

FourierLine FourierTransform::analyse(std::span<const double> height, double length) const {
  const std::size_t count = plans_->points();
  Buffers own;
  const Buffers& buffers = buffersFor(count, own);
  const Complex* modes = buffers.modes.values;
  std::copy_n(height.begin(), count, buffers.values.values);
  plans_->forward(buffers.values.values, buffers.modes.values);
  FourierLine line{length, {}};
  line.coefficients.reserve(modeCount(count));
  for (std::size_t k = 1; k <= modeCount(count); ++k)
    line.coefficients.push_back(modes[k] / static_cast<double>(count));
  return line;
}

FourierLine withSummitCorrelation(const FourierLine& line, double kappa,
                                  const FourierTransform& fine) {
  const std::size_t modes = line.coefficients.size();
  const auto split = static_cast<std::size_t>(std::sqrt(static_cast<double>(modes)));
  const FourierLine longWaves = partOf(line, 1, split + 1);
  const double height = rmsHeight(line), longHeight = rmsHeight(longWaves);
  if (!(longHeight > 0) || modes < 2) return line;
  std::vector<double> far, near;
  fine.evaluate(longWaves, far);
  fine.evaluate(partOf(line, split + 1, modes + 1), near);
  for (std::size_t i = 0; i < far.size(); ++i)
    far[i] +=
        near[i] * std::sqrt(1 + std::clamp(-kappa * far[i] / longHeight, -kLargest, kLargest));
  FourierLine whole = fine.analyse(far, line.length);
  whole.coefficients.resize(modes);
  const double factor = height / rmsHeight(whole);
  for (std::complex<double>& coefficient : whole.coefficients) coefficient *= factor;
  return whole;
}

}  // namespace asperity
