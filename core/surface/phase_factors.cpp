#include "core/surface/phase_factors.h"

#include <cstddef>

// As for the contact kernels: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/phase_factors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After it, as Highway wants.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void factors(const double* amplitudes, const double* phases, double* out, std::size_t count) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto amplitude = hn::LoadU(d, amplitudes + i), phase = hn::LoadU(d, phases + i);
    hn::StoreInterleaved2(hn::Mul(amplitude, hn::Cos(d, phase)),
                          hn::Mul(amplitude, hn::Sin(d, phase)), d, out + 2 * i);
  }
  const hn::CappedTag<double, 1> one;
  for (; i < count; ++i) {  // the same functions, so that a mode does not depend on its place
    const auto amplitude = hn::LoadU(one, amplitudes + i), phase = hn::LoadU(one, phases + i);
    hn::StoreU(hn::Mul(amplitude, hn::Cos(one, phase)), one, out + 2 * i);
    hn::StoreU(hn::Mul(amplitude, hn::Sin(one, phase)), one, out + 2 * i + 1);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(factors);

void phaseFactors(std::span<const double> amplitudes, std::span<const double> phases,
                  std::span<std::complex<double>> out) {
  HWY_DYNAMIC_DISPATCH(factors)
  (amplitudes.data(), phases.data(), reinterpret_cast<double*>(out.data()), out.size());
}

}  // namespace asperity
#endif  // HWY_ONCE
