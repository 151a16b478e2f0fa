#include "core/contact/line/segment_bounds.h"

#include <algorithm>

// The instruction sets are those of the contact kernels: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/line/segment_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// This include comes after it, as Highway requires.
#include "core/contact/kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// The arrays of a BlockLevel.
struct Bounded {
  double *lowest, *highest, *steepest, *heightIntegral, *slopeSquared;
};

// Bounds one vector of segments. It has no fused operations, because machines without them would
// round differently.
HWY_INLINE void bound(const double* height, const double* slopeIn, const double* slopeOut,
                      double length, std::size_t k, const Bounded& to) {
  const auto all = [](double value) { return One::all(value); };
  const One begin = One::load(height + k), end = One::load(height + k + 1);
  const One in = One::load(slopeIn + k), out = One::load(slopeOut + k);
  // The two inner control points of the height, and the inner one of its slope.
  const One span = all(length), third = all(length * (1.0 / 3)), perLength = all(1 / length);
  const One first = begin + in * third, second = end - out * third;
  const One middle = all(3) * (second - first) * perLength;
  const One step = end - begin, m0 = in * span, m1 = out * span;
  // This is the integral of the slope squared, (m0 + b t + c t^2)^2, by the coefficients of
  // Hermite's cubic.
  const One b = all(2) * (all(3) * step - all(2) * m0 - m1), c = all(3) * (m0 + m1 - all(2) * step);
  const One high = b * c * all(0.5) + c * c * all(0.2);
  const One squares = m0 * m0 + (m0 * b + ((b * b + all(2) * m0 * c) * all(1.0 / 3) + high));
  min(min(begin, end), min(first, second)).store(to.lowest + k);
  max(max(begin, end), max(first, second)).store(to.highest + k);
  max(max(in, out), middle).store(to.steepest + k);
  (span * (all(0.5) * (begin + end) + span * (in - out) * all(1.0 / 12)))
      .store(to.heightIntegral + k);
  (squares * perLength).store(to.slopeSquared + k);
}

void boundAll(const double* height, const double* slopeIn, const double* slopeOut,
              std::size_t count, double length, double* lowest, double* highest, double* steepest,
              double* heightIntegral, double* slopeSquared) {
  constexpr std::size_t kLanes = One::kLanes;
  const Bounded to{lowest, highest, steepest, heightIntegral, slopeSquared};
  std::size_t k = 0;
  for (; k + kLanes <= count; k += kLanes) bound(height, slopeIn, slopeOut, length, k, to);
  if (k == count) return;
  // The remaining ones are padded.
  double heights[kLanes + 1] = {}, in[kLanes] = {}, out[kLanes] = {};
  std::copy(height + k, height + count + 1, heights);
  std::copy(slopeIn + k, slopeIn + count, in);
  std::copy(slopeOut + k, slopeOut + count, out);
  bound(heights, in, out, length, 0,
        {lowest + k, highest + k, steepest + k, heightIntegral + k, slopeSquared + k});
}

/// Numbers 4 k + i of a row as vectors of consecutive k, one vector for each i.
struct Fours {
  One a, b, c, d;

  static HWY_INLINE Fours load(const double* from) {
    Fours fours;
    hn::LoadInterleaved4(kTag, from, fours.a.v, fours.b.v, fours.c.v, fours.d.v);
    return fours;
  }
  template <class Merge>
  HWY_INLINE One merged(const Merge& merge) const {
    return merge(merge(a, b), merge(c, d));
  }
};

constexpr auto kMin = [](One x, One y) { return min(x, y); };
constexpr auto kMax = [](One x, One y) { return max(x, y); };
constexpr auto kSum = [](One x, One y) { return x + y; };

/// Calls take(k, row) for every vector of fours of a row of `count` fours; `more` numbers after
/// each four are read, too. The remaining ones are padded, in the row and where `take` stores them.
template <std::size_t kMore, class Take>
HWY_INLINE void forFours(const double* row, std::size_t count, const Take& take) {
  std::size_t k = 0;
  for (; k + One::kLanes <= count; k += One::kLanes) take(k, row + 4 * k);
  if (k == count) return;
  double rest[4 * One::kLanes + kMore] = {};
  std::copy(row + 4 * k, row + 4 * count + kMore, rest);
  take(k, rest);
}

template <class Merge>
HWY_INLINE void mergeRow(const double* from, double* to, std::size_t count, const Merge& merge) {
  forFours<0>(from, count, [&](std::size_t k, const double* row) {
    Fours::load(row).merged(merge).store(to + k);
  });
}

void leastOfFours(const double* from, double* to, std::size_t count) {
  mergeRow(from, to, count, kMin);
}
void mostOfFours(const double* from, double* to, std::size_t count) {
  mergeRow(from, to, count, kMax);
}
void sumOfFours(const double* from, double* to, std::size_t count) {
  mergeRow(from, to, count, kSum);
}

void heightOfFours(const double* height, std::size_t count, double length, double* lowest,
                   double* highest, double* heightIntegral) {
  forFours<1>(height, count, [&](std::size_t k, const double* row) {
    const Fours begins = Fours::load(row), ends = Fours::load(row + 1);
    min(begins.merged(kMin), ends.d).store(lowest + k);
    max(begins.merged(kMax), ends.d).store(highest + k);
    const One inner = (begins.b + begins.c) + begins.d;
    (One::all(length) * (One::all(0.5) * (begins.a + ends.d) + inner)).store(heightIntegral + k);
  });
}

void slopeOfFours(const double* slope, std::size_t count, double length, double* steepest,
                  double* slopeSquared) {
  forFours<0>(slope, count, [&](std::size_t k, const double* row) {
    const Fours m = Fours::load(row);
    m.merged(kMax).store(steepest + k);
    const Fours squares{m.a * m.a, m.b * m.b, m.c * m.c, m.d * m.d};
    (One::all(length) * squares.merged(kSum)).store(slopeSquared + k);
  });
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
HWY_EXPORT(leastOfFours);
HWY_EXPORT(mostOfFours);
HWY_EXPORT(sumOfFours);
HWY_EXPORT(heightOfFours);
HWY_EXPORT(slopeOfFours);

std::size_t lowestIndex(std::span<const double> values) {
  const double least = HWY_DYNAMIC_DISPATCH(lowest)(values.data(), values.size());
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), least) - values.begin());
}

void boundSegments(const double* height, const double* slopeIn, const double* slopeOut,
                   std::size_t count, double length, BlockLevel& blocks) {
  HWY_DYNAMIC_DISPATCH(boundAll)
  (height, slopeIn, slopeOut, count, length, blocks.lowest.data(), blocks.highest.data(),
   blocks.steepest.data(), blocks.heightIntegral.data(), blocks.slopeSquared.data());
}

void boundStraightFours(const double* height, const double* slope, std::size_t count, double length,
                        BlockLevel& blocks) {
  const std::size_t fours = count / 4;
  blocks.resize(fours);
  HWY_DYNAMIC_DISPATCH(heightOfFours)
  (height, fours, length, blocks.lowest.data(), blocks.highest.data(),
   blocks.heightIntegral.data());
  HWY_DYNAMIC_DISPATCH(slopeOfFours)
  (slope, fours, length, blocks.steepest.data(), blocks.slopeSquared.data());
}

void mergeFours(const BlockLevel& finer, BlockLevel& blocks) {
  const std::size_t count = finer.size() / 4;
  const bool isNodal = finer.highest.empty();
  if (isNodal)
    blocks.resizeForNodal(count);
  else
    blocks.resize(count);
  HWY_DYNAMIC_DISPATCH(leastOfFours)(finer.lowest.data(), blocks.lowest.data(), count);
  if (isNodal) return;
  HWY_DYNAMIC_DISPATCH(mostOfFours)(finer.highest.data(), blocks.highest.data(), count);
  HWY_DYNAMIC_DISPATCH(mostOfFours)(finer.steepest.data(), blocks.steepest.data(), count);
  HWY_DYNAMIC_DISPATCH(sumOfFours)
  (finer.heightIntegral.data(), blocks.heightIntegral.data(), count);
  HWY_DYNAMIC_DISPATCH(sumOfFours)(finer.slopeSquared.data(), blocks.slopeSquared.data(), count);
}

SegmentBounds boundSegment(const double* height, double slopeIn, double slopeOut, double length) {
  double found[5][BlockLevel::kPadding];
  HWY_DYNAMIC_DISPATCH(boundAll)
  (height, &slopeIn, &slopeOut, 1, length, found[0], found[1], found[2], found[3], found[4]);
  return {found[0][0], found[1][0], found[2][0], found[3][0], found[4][0]};
}

}  // namespace asperity
#endif  // HWY_ONCE
