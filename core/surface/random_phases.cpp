#include "core/surface/random_phases.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

// The instruction sets are those of the contact kernels: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/random_phases.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// This include comes after it, as Highway requires.
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

#if HWY_TARGET == HWY_SCALAR

void phases(std::uint64_t seed, std::uint64_t realization, std::uint64_t first, std::size_t pairs,
            double* out) {
  for (std::size_t k = 0; k < pairs; ++k) {
    const PhasePair two = randomPhases(seed, realization, first + k);
    out[2 * k] = two.even;
    out[2 * k + 1] = two.odd;
  }
}

#else

constexpr hn::ScalableTag<std::uint64_t> kWords;
using Words = hn::Vec<decltype(kWords)>;

/// Philox4x32-10: a word in the lower half of each lane, whatever is in the upper one.
struct Counter {
  Words a, b, c, d;

  static HWY_INLINE Words product(Words x, std::uint32_t factor) {
    const hn::Repartition<std::uint32_t, decltype(kWords)> halves;
    return hn::MulEven(hn::BitCast(halves, x), hn::BitCast(halves, hn::Set(kWords, factor)));
  }
  HWY_INLINE void round(std::uint32_t key0, std::uint32_t key1) {
    const Words first = product(a, 0xD2511F53U), second = product(c, 0xCD9E8D57U);
    a = hn::Xor(hn::Xor(hn::ShiftRight<32>(second), b), hn::Set(kWords, key0));
    c = hn::Xor(hn::Xor(hn::ShiftRight<32>(first), d), hn::Set(kWords, key1));
    b = second;
    d = first;
  }
};

/// The angle of two words, as in randomPhases.
HWY_INLINE auto angle(Words upper, Words lower) {
  const hn::ScalableTag<double> d;
  const Words bits = hn::Or(hn::ShiftLeft<32>(upper), hn::And(lower, hn::Set(kWords, 0xFFFFFFFFU)));
  // Halves of 53 bits as numbers: under the bits of 2^52.
  const Words magic = hn::Set(kWords, 0x4330000000000000ULL);
  const auto number = [&](Words half) {
    return hn::Sub(hn::BitCast(d, hn::Or(half, magic)), hn::Set(d, 0x1p52));
  };
  const Words fine = hn::And(hn::ShiftRight<11>(bits), hn::Set(kWords, 0xFFFFFFFFU));
  const auto whole =
      hn::Add(hn::Mul(number(hn::ShiftRight<43>(bits)), hn::Set(d, 0x1p32)), number(fine));
  return hn::Mul(hn::Mul(whole, hn::Set(d, 0x1p-52)), hn::Set(d, std::numbers::pi));
}

void phases(std::uint64_t seed, std::uint64_t realization, std::uint64_t first, std::size_t pairs,
            double* out) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(kWords);
  for (std::size_t k = 0; k < pairs; k += lanes) {
    const Words pair = hn::Add(hn::Set(kWords, first + k), hn::Iota(kWords, 0));
    Counter counter{pair, hn::ShiftRight<32>(pair), hn::Set(kWords, realization),
                    hn::Set(kWords, realization >> 32)};
    auto key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
    for (int round = 0; round < 10; ++round) {
      counter.round(key0, key1);
      key0 += 0x9E3779B9U;
      key1 += 0xBB67AE85U;
    }
    const auto even = angle(counter.a, counter.b), odd = angle(counter.c, counter.d);
    if (k + lanes <= pairs) {
      hn::StoreInterleaved2(even, odd, d, out + 2 * k);
    } else {  // those left over
      HWY_ALIGN double last[2 * hn::MaxLanes(d)];
      hn::StoreInterleaved2(even, odd, d, last);
      std::copy_n(last, 2 * (pairs - k), out + 2 * k);
    }
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(factors);
HWY_EXPORT(phases);

void randomPhasesInto(std::uint64_t seed, std::uint64_t realization, std::uint64_t first,
                      std::size_t pairs, double* out) {
  HWY_DYNAMIC_DISPATCH(phases)(seed, realization, first, pairs, out);
}

void randomModes(std::uint64_t seed, std::uint64_t realization, std::span<const double> amplitudes,
                 std::span<std::complex<double>> out) {
  constexpr std::size_t kPairs = 256;  // at once
  std::array<double, 2 * kPairs> found;
  // Mode 0 is the mean, which is none.
  for (std::size_t mode = 1, last = amplitudes.size(); mode <= last;) {
    const std::size_t first = mode / 2, pairs = std::min(kPairs, last / 2 - first + 1);
    randomPhasesInto(seed, realization, first, pairs, found.data());
    const std::size_t count = std::min(2 * (first + pairs) - mode, last + 1 - mode);
    HWY_DYNAMIC_DISPATCH(factors)
    (amplitudes.data() + mode - 1, found.data() + (mode - 2 * first),
     reinterpret_cast<double*>(out.data() + mode - 1), count);
    mode += count;
  }
}

}  // namespace asperity
#endif  // HWY_ONCE
