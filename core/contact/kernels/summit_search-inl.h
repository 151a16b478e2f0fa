// The summits of the linear kernel: where the pressure p of a line of straight segments falls
// through 0, inside a segment or at a corner. Compiled once per instruction set.

#if defined(ASPERITY_SUMMIT_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_SUMMIT_SEARCH_INL
#undef ASPERITY_SUMMIT_SEARCH_INL
#else
#define ASPERITY_SUMMIT_SEARCH_INL
#endif

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/contact/kernels/wide-inl.h"
#include "core/contact/line/prepared_profile.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// A batch of summits in order of travel; lengths in m.
struct alignas(64) Summits {
  static constexpr std::size_t kMax = 128;
  using Values = double[kMax];

  std::size_t count = 0;
  std::size_t segment[kMax];  // the segment that it ends; at a corner, the one that begins there
  std::size_t start[kMax];    // segment in which, or at whose start, p rose through 0 before
  // At the segment's start: s, height, and the slope dz/ds after it.
  Values position, nodeHeight, slope;
  Values inside;  // 1: inside the segment; 0: at its start
  // Added by SummitSearch::measure():
  Values along;   // from the segment's start
  Values height;  // z
  Values depth;   // w
  Values order;   // ln w + s / c, by which one exceeds another
};

/// Follows a line at one depth and relaxation length and collects its summits in batches. Summits
/// above the depth do not count.
class SummitSearch {
 public:
  SummitSearch(const PreparedProfile& line, double depth, double relaxationLength, double inverse)
      : line_(line), depth_(depth), relaxationLength_(relaxationLength), inverse_(inverse) {}

  const Summits& summits() const { return summits_; }

  /// Collects all of the line's summits and its end, which counts as one. take() is called before
  /// the batch is full; it is emptied afterwards. Ends where take() returns false.
  template <class Take>
  HWY_INLINE bool run(const Take& take) {
    const std::size_t segments = line_.segments();
    addSegments(0, 1);  // it is outside of the blocks
    std::size_t done = 1;
    if (line_.blocks.size() > kWordLevel) {
      if (!goOverWords(take)) return false;
      done += kWord * line_.blocks[kWordLevel].size();
    }
    for (; done < segments; done += kWord)
      if (!addWord(done, std::min(kWord, segments - done), take)) return false;
    add(segments, start_, 0, 0);
    return empty(take);
  }

 private:
  static constexpr std::size_t kWord = 64, kWordLevel = 3;  // segments compared together

  /// Skips words above the depth, which have no summits, and words that are completely under
  /// pressure.
  template <class Take>
  HWY_INLINE bool goOverWords(const Take& take) {
    const BlockLevel& words = line_.blocks[kWordLevel];
    const One d = One::all(depth_), c = One::all(relaxationLength_);
    for (std::size_t word = 0; word < words.size(); word += One::kLanes) {
      const One room = d - One::load(words.highest.data() + word);
      const unsigned rising = bitsOf(room > c * One::load(words.steepest.data() + word));
      unsigned left = bitsOf(One::load(words.lowest.data() + word) < d);
      if (word + One::kLanes > words.size()) left &= (1U << (words.size() - word)) - 1;
      for (; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t first = 1 + kWord * (word + lane);
        if ((rising >> lane & 1) != 0)
          passRising(first);
        else if (!addWord(first, kWord, take))
          return false;
      }
    }
    return true;
  }

  void passRising(std::size_t first) {
    if (first != next_ || !isRising_) start_ = first;
    isRising_ = true;
    next_ = first + kWord;
  }

  template <class Take>
  HWY_INLINE bool addWord(std::size_t first, std::size_t count, const Take& take) {
    addSegments(first, count);
    return summits_.count + kWord < Summits::kMax || empty(take);
  }

  template <class Take>
  HWY_INLINE bool empty(const Take& take) {
    measure();
    const bool goOn = take();
    summits_.count = 0;
    return goOn;
  }

  HWY_INLINE void addSegments(std::size_t first, std::size_t count) {
    // One bit per segment: p > 0 at its start, at its end; start below the depth.
    std::uint64_t begins = 0, ends = 0, below = 0;
    const One d = One::all(depth_), c = One::all(relaxationLength_), none = One::all(0);
    const auto compare = [&](std::size_t k, One begin, One end, One slope) {
      const One needed = c * slope, room = d - begin;
      begins |= std::uint64_t{bitsOf(room > needed)} << k;
      ends |= std::uint64_t{bitsOf(d - end > needed)} << k;
      below |= std::uint64_t{bitsOf(room > none)} << k;
    };
    const double *height = line_.heightAboveMinimum.data() + first,
                 *slope = line_.slopeIn.data() + first;
    if (count == kWord) {
      for (std::size_t k = 0; k < kWord; k += One::kLanes)
        compare(k, One::load(height + k), One::load(height + k + 1), One::load(slope + k));
    } else {
      for (std::size_t k = 0; k < count; k += One::kLanes)
        compare(k, One::loadFirst(height + k, count - k), One::loadFirst(height + k + 1, count - k),
                One::loadFirst(slope + k, count - k));
      const std::uint64_t valid = (std::uint64_t{1} << count) - 1;
      begins &= valid, ends &= valid, below &= valid;
    }
    const bool wasRising = isRising_ && first == next_;
    const std::uint64_t before = ends << 1 | (wasRising ? 1 : 0);
    const std::uint64_t rises = (begins & ~before) | (ends & ~begins);
    addFalls((begins & ~ends) | (before & ~begins & below), begins, rises, first);
    if (rises != 0) start_ = first + 63 - static_cast<std::size_t>(std::countl_zero(rises));
    isRising_ = (ends >> (count - 1) & 1) != 0;
    next_ = first + count;
  }

  HWY_INLINE void addFalls(std::uint64_t falls, std::uint64_t begins, std::uint64_t rises,
                           std::size_t first) {
    for (; falls != 0; falls &= falls - 1) {
      const std::uint64_t bit = falls & (~falls + 1);
      const bool inside = (begins & bit) != 0;
      // At a corner p may rise again inside the next segment.
      const std::uint64_t before = rises & (inside ? bit | (bit - 1) : bit - 1);
      const std::size_t start =
          before != 0 ? first + 63 - static_cast<std::size_t>(std::countl_zero(before)) : start_;
      const std::size_t segment = first + static_cast<std::size_t>(std::countr_zero(falls));
      add(segment, start, line_.slopeIn[segment], inside ? 1 : 0);
    }
  }

  HWY_INLINE void add(std::size_t segment, std::size_t start, double slope, double inside) {
    const std::size_t k = summits_.count++;
    summits_.segment[k] = segment;
    summits_.start[k] = start;
    summits_.position[k] = line_.position(segment);
    summits_.nodeHeight[k] = line_.heightAboveMinimum[segment];
    summits_.slope[k] = slope;
    summits_.inside[k] = inside;
  }

  HWY_INLINE void measure() {
    constexpr double kMin = 1e-300;
    const One d = One::all(depth_), c = One::all(relaxationLength_), inverse = One::all(inverse_);
    for (std::size_t k = 0; k < summits_.count; k += One::kLanes) {
      const One height = One::load(summits_.nodeHeight + k), slope = One::load(summits_.slope + k);
      const OneMask inside = One::load(summits_.inside + k) > One::all(0);
      // At a corner the summit is the node; inside, p is 0 where w = c dz/ds.
      const One corner = d - height, vanishing = c * slope;
      const One along = onlyIn(inside, (corner - vanishing) / slope);
      const One depth = select(inside, vanishing, corner);
      const One logarithm{hn::Log(kTag, max(depth, One::all(kMin)).v)};
      along.store(summits_.along + k);
      mulAdd(along, slope, height).store(summits_.height + k);
      depth.store(summits_.depth + k);
      mulAdd(One::load(summits_.position + k) + along, inverse, logarithm)
          .store(summits_.order + k);
    }
  }

  const PreparedProfile& line_;
  double depth_, relaxationLength_, inverse_;
  std::size_t start_ = 0;  // of the last or present interval under pressure
  std::size_t next_ = 0;   // the first segment not compared yet
  // p > 0 before it; travel starts at the lowest point, which is in contact
  bool isRising_ = true;
  Summits summits_;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
