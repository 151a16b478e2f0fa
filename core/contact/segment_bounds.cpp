#include "core/contact/segment_bounds.h"

#include <algorithm>

// As for the contact kernels: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/segment_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After it, as Highway wants.
#include "core/contact/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// The arrays of a BlockLevel.
struct Bounded {
  double *lowest, *highest, *steepest, *riseIntegral, *slopeSquared;
};

// No fused operations: they would round otherwise where there are none.
HWY_INLINE void bound(const double* rise, const double* slopeIn, const double* slopeOut,
                      double length, std::size_t k, const Bounded& to) {
  const auto all = [](double value) { return One::all(value); };
  const One begin = One::load(rise + k), end = One::load(rise + k + 1);
  const One in = One::load(slopeIn + k), out = One::load(slopeOut + k);
  const One span = all(length), third = all(length * (1.0 / 3)), perLength = all(1 / length);
  const One first = begin + in * third, second = end - out * third;
  const One middle = all(3) * (second - first) * perLength;  // the slope's own control point
  const One step = end - begin, m0 = in * span, m1 = out * span;
  // Integral of (m0 + b t + c t^2)^2.
  const One b = all(2) * (all(3) * step - all(2) * m0 - m1), c = all(3) * (m0 + m1 - all(2) * step);
  const One high = b * c * all(0.5) + c * c * all(0.2);
  const One squares = m0 * m0 + (m0 * b + ((b * b + all(2) * m0 * c) * all(1.0 / 3) + high));
  min(min(begin, end), min(first, second)).store(to.lowest + k);
  max(max(begin, end), max(first, second)).store(to.highest + k);
  max(max(in, out), middle).store(to.steepest + k);
  (span * (all(0.5) * (begin + end) + span * (in - out) * all(1.0 / 12)))
      .store(to.riseIntegral + k);
  (squares * perLength).store(to.slopeSquared + k);
}

void boundAll(const double* rise, const double* slopeIn, const double* slopeOut, std::size_t count,
              double length, double* lowest, double* highest, double* steepest,
              double* riseIntegral, double* slopeSquared) {
  constexpr std::size_t kLanes = One::kLanes;
  const Bounded to{lowest, highest, steepest, riseIntegral, slopeSquared};
  std::size_t k = 0;
  for (; k + kLanes <= count; k += kLanes) bound(rise, slopeIn, slopeOut, length, k, to);
  if (k == count) return;
  // Those left over, padded.
  double rises[kLanes + 1] = {}, in[kLanes] = {}, out[kLanes] = {};
  std::copy(rise + k, rise + count + 1, rises);
  std::copy(slopeIn + k, slopeIn + count, in);
  std::copy(slopeOut + k, slopeOut + count, out);
  bound(rises, in, out, length, 0,
        {lowest + k, highest + k, steepest + k, riseIntegral + k, slopeSquared + k});
}

double lowest(const double* values, std::size_t count) {
  constexpr std::size_t kLanes = One::kLanes, kRun = 4 * kLanes;
  One least[4] = {One::all(values[0]), One::all(values[0]), One::all(values[0]),
                  One::all(values[0])};
  std::size_t i = 0;
  for (; i + kRun <= count; i += kRun)
    for (std::size_t k = 0; k < 4; ++k)
      least[k] = min(least[k], One::load(values + i + k * kLanes));
  const One one = min(min(least[0], least[1]), min(least[2], least[3]));
  double lanes[kLanes];
  one.store(lanes);
  double lowest = *std::min_element(lanes, lanes + kLanes);
  for (; i < count; ++i) lowest = std::min(lowest, values[i]);
  return lowest;
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(boundAll);
HWY_EXPORT(lowest);

std::size_t placeOfLowest(std::span<const double> values) {
  const double least = HWY_DYNAMIC_DISPATCH(lowest)(values.data(), values.size());
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), least) - values.begin());
}

void boundSegments(const double* rise, const double* slopeIn, const double* slopeOut,
                   std::size_t count, double length, BlockLevel& blocks) {
  blocks.resize(count);
  HWY_DYNAMIC_DISPATCH(boundAll)
  (rise, slopeIn, slopeOut, count, length, blocks.lowest.data(), blocks.highest.data(),
   blocks.steepest.data(), blocks.riseIntegral.data(), blocks.slopeSquared.data());
}

SegmentBounds boundSegment(const double* rise, double slopeIn, double slopeOut, double length) {
  double found[5][BlockLevel::kPadding];
  HWY_DYNAMIC_DISPATCH(boundAll)
  (rise, &slopeIn, &slopeOut, 1, length, found[0], found[1], found[2], found[3], found[4]);
  return {found[0][0], found[1][0], found[2][0], found[3][0], found[4][0]};
}

}  // namespace asperity
#endif  // HWY_ONCE
