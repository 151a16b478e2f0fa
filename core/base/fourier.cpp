#include "core/base/fourier.h"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <new>

#include "core/base/destroyer.h"

namespace asperity {
namespace {

fftw_complex* raw(std::complex<double>* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

/// FFTW does not write to the input of transforms that are told to keep it.
double* writable(const double* values) {
  return const_cast<double*>(values);
}

/// Held while a plan is made or destroyed.
constinit std::mutex plannerLock;

/// The plans that were used last, the latest at the end. A large one is kept only as long as a
/// transform uses it.
struct KeptPlans {
  static constexpr std::size_t kMax = 8, kMaxPoints = 1 << 18;
  std::mutex lock;
  std::vector<std::shared_ptr<const FourierPlans>> plans;
  std::weak_ptr<const FourierPlans> large;
};

template <class Value>
using Aligned = std::unique_ptr<Value, Destroyer<fftw_free>>;

template <class Value>
Aligned<Value> aligned(std::size_t count) {
  auto* values = static_cast<Value*>(fftw_malloc(sizeof(Value) * count));
  if (!values) throw std::bad_alloc();
  return Aligned<Value>(values);
}

}  // namespace

std::size_t fastTransformSize(std::size_t count) {
  for (std::size_t size = count;; ++size) {
    std::size_t rest = size;
    for (const std::size_t factor : {2U, 3U, 5U})
      while (rest > 1 && rest % factor == 0) rest /= factor;
    if (rest <= 1 && size > 0) return size;
  }
}

std::shared_ptr<const FourierPlans> FourierPlans::forSize(std::size_t points, Arrays arrays) {
  static KeptPlans kept;
  const std::lock_guard lock(kept.lock);
  if (points > KeptPlans::kMaxPoints) {
    std::shared_ptr<const FourierPlans> large = kept.large.lock();
    if (!large || large->points() != points || large->arrays() != arrays)
      kept.large = large = std::make_shared<const FourierPlans>(points, arrays);
    return large;
  }
  auto found = std::ranges::find_if(kept.plans, [&](const auto& plans) {
    return plans->points() == points && plans->arrays() == arrays;
  });
  if (found == kept.plans.end()) {
    kept.plans.push_back(std::make_shared<const FourierPlans>(points, arrays));
    if (kept.plans.size() > KeptPlans::kMax) kept.plans.erase(kept.plans.begin());
  } else {
    std::rotate(found, found + 1, kept.plans.end());
  }
  return kept.plans.back();
}

namespace {

/// Returns the plan that `make` makes of arrays for a size and the flags of the planner. Estimated
/// plans look at the alignment of the arrays, not at what is in them.
template <class Make>
fftw_plan estimated(std::size_t points, FourierPlans::Arrays arrays, const Make& make) {
  const auto values = aligned<double>(points);
  const auto modes = aligned<std::complex<double>>(points / 2 + 1);
  const unsigned flags = FFTW_ESTIMATE | (arrays == FourierPlans::Arrays::Any ? FFTW_UNALIGNED : 0);
  const std::lock_guard lock(plannerLock);
  return make(static_cast<int>(points), values.get(), raw(modes.get()), flags);
}

}  // namespace

FourierPlans::FourierPlans(std::size_t points, Arrays arrays) : points_(points), arrays_(arrays) {}

FourierPlans::~FourierPlans() {
  const std::lock_guard lock(plannerLock);
  for (fftw_plan plan : {forward_, backward_})
    if (plan) fftw_destroy_plan(plan);
}

void FourierPlans::forward(const double* values, std::complex<double>* modes) const {
  std::call_once(isForwardMade_, [this] {
    forward_ = estimated(points_, arrays_, [](int size, double* in, auto* out, unsigned flags) {
      return fftw_plan_dft_r2c_1d(size, in, out, flags | FFTW_PRESERVE_INPUT);
    });
  });
  fftw_execute_dft_r2c(forward_, writable(values), raw(modes));
}

void FourierPlans::backward(std::complex<double>* modes, double* values) const {
  std::call_once(isBackwardMade_, [this] {
    backward_ = estimated(points_, arrays_, [](int size, double* out, auto* in, unsigned flags) {
      return fftw_plan_dft_c2r_1d(size, in, out, flags | FFTW_DESTROY_INPUT);
    });
  });
  fftw_execute_dft_c2r(backward_, raw(modes), values);
}

std::vector<std::complex<double>> RealTransform::forward(std::span<const double> values) const {
  std::vector<std::complex<double>> modes(this->modes());
  plans_->forward(values.data(), modes.data());
  return modes;
}

std::vector<double> RealTransform::backward(std::vector<std::complex<double>> modes) const {
  std::vector<double> values(points());
  plans_->backward(modes.data(), values.data());
  return values;
}

std::vector<std::complex<double>> transform2d(std::span<const double> values, std::size_t rows,
                                              std::size_t columns) {
  std::vector<std::complex<double>> modes(rows * (columns / 2 + 1));
  fftw_plan plan = nullptr;
  {
    const std::lock_guard lock(plannerLock);
    plan = fftw_plan_dft_r2c_2d(static_cast<int>(rows), static_cast<int>(columns),
                                writable(values.data()), raw(modes.data()),
                                FFTW_ESTIMATE | FFTW_UNALIGNED);
  }
  fftw_execute(plan);
  const std::lock_guard lock(plannerLock);
  fftw_destroy_plan(plan);
  return modes;
}

}  // namespace asperity
