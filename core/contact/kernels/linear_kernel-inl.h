// The body of runLinearPasses in kernels.h: one pass. Compiled once per instruction set.

#if defined(ASPERITY_LINEAR_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_LINEAR_KERNEL_INL
#undef ASPERITY_LINEAR_KERNEL_INL
#else
#define ASPERITY_LINEAR_KERNEL_INL
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/kernels/arc_gap-inl.h"
#include "core/contact/kernels/pass.h"
#include "core/contact/kernels/summit_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// The polynomial c0 + c1 t.
struct WideStraight {
  Wide c0, c1;

  HWY_INLINE Wide at(Wide t) const { return mulAdd(t, c1, c0); }
  HWY_INLINE Wide slopeAt(Wide) const { return c1; }
  HWY_INLINE Wide halfCurvatureAt(Wide) const { return Wide::all(0); }
};

/// The partly covered segments of some patches of contact: the first, where contact begins after a
/// free arc, and the last, if contact ends inside it. Lengths in m. A patch of zeros adds nothing;
/// the first patch of the line begins with one, because no arc precedes it.
struct alignas(64) Patches {
  static constexpr std::size_t kMax = Summits::kMax;
  using Values = double[kMax];

  // The free arc: w and height at its beginning, and its length to the lower end of the first
  // segment.
  Values arcDepth, arcHeight, arcLength;
  // The first segment, with t from its lower end: the height there, and its rise; 1 if that is its
  // start, -1 if it is its end; t of its higher end, or of a summit inside.
  Values low, climb, onwards, end;
  // The last segment up to the summit, unless it is also the first one.
  Values lastHeight, lastSlope, lastLength;
};

/// One pass.
class LinearKernel {
 public:
  LinearKernel(const PreparedProfile& line, const PassRequest& request)
      : line_(line),
        depth_(request.depth),
        relaxationLength_(request.relaxationLength),
        // Without relaxation the free surface returns at once.
        inverse_(request.relaxationLength > 0 ? std::min(1 / request.relaxationLength, 1e300)
                                              : 1e300),
        search_(line, depth_, relaxationLength_, inverse_) {
    const One steps = {hn::Iota(kTag, 0)};
    decay_ = One::all(1) - lostAfter(steps * One::all(line.spacing * inverse_));
    decayOverAll_ = std::exp(-line.spacing * static_cast<double>(One::kLanes) * inverse_);
  }

  /// Runs the pass; returns false where it was stopped.
  HWY_INLINE bool run(const PassQueue& queue, PassSums& sums) {
    const bool done = search_.run([&] {
      addPatches();
      return !queue.isStopped();
    });
    const double length = line_.spacing * static_cast<double>(whole_);
    const double depths = depth_ * length - 0.5 * line_.spacing * totalOf(wholeHeights_);
    sums = {};
    sums.work = kNotGathered;
    sums.depth = depths + totalOf(depths_) + totalOf(freeDepths_);
    sums.contactLength = length + totalOf(length_);
    sums.stiffness = sums.contactLength + totalOf(freeStiffness_);
    sums.slopeSquared = line_.spacing * totalOf(wholeSlopes_) + totalOf(slopes_);
    sums.dissipation = relaxationLength_ * sums.slopeSquared + totalOf(freeLoss_);
    sums.gaps = static_cast<double>(arcs_);
    sums.pressure =
        depths + totalOf(depths_) - relaxationLength_ * (wholeClimb_ + totalOf(climbs_));
    return done;
  }

 private:
  /// Adds patches of contact. They end at the summits that exceed all earlier ones; equal height
  /// suffices, because the free surface has risen since.
  HWY_INLINE void addPatches() {
    // Find the summits that exceed all earlier ones.
    const Summits& summits = search_.summits();
    std::size_t tops[Summits::kMax], count = 0;
    for (std::size_t k = 0; k < summits.count; ++k) {
      tops[count] = k;
      count += summits.order[k] >= highest_ ? 1 : 0;
      highest_ = std::max(highest_, summits.order[k]);
    }
    // Compute their patches of contact: the free arc before each, the depth of the surface at its
    // end, and the segments that are completely in contact.
    for (std::size_t patch = 0; patch < count; ++patch) setArc(patch, tops[patch]);
    for (std::size_t k = 0; k < count; k += One::kLanes) relax(k);
    for (std::size_t patch = 0; patch < count; ++patch) setPatch(patch, tops[patch]);
    // Compute the partly covered segments, many at a time.
    for (std::size_t k = 0; k < count; k += Wide::kLanes) {
      for (std::size_t patch = count; patch < k + Wide::kLanes; ++patch) clear(patch);
      addParts(k);
    }
  }

  /// Sets the free arc before the summit's patch, up to the node after p rises through 0.
  HWY_INLINE void setArc(std::size_t patch, std::size_t summit) {
    const Summits& summits = search_.summits();
    patches_.arcDepth[patch] = left_.depth;
    patches_.arcHeight[patch] = left_.height;
    patches_.arcLength[patch] =
        line_.position(summits.start[summit] + 1) - left_.position - left_.along;
    left_ = {summits.position[summit], summits.along[summit], summits.height[summit],
             summits.depth[summit]};
  }

  HWY_INLINE void relax(std::size_t k) {
    const One depth = One::load(patches_.arcDepth + k), arc = One::load(patches_.arcLength + k);
    negMulAdd(depth, lostAfter(arc * One::all(inverse_)), depth).store(relaxed_ + k);
  }

  HWY_INLINE void setPatch(std::size_t patch, std::size_t summit) {
    const Summits& summits = search_.summits();
    const std::size_t last = summits.segment[summit];
    const double along = summits.along[summit];
    std::size_t whole = 0;
    bool isOne = false;  // first and last segment
    if (hasLeft_) {
      ++arcs_;
      const std::size_t next = summits.start[summit] + 1;
      const std::size_t first = findEntry(next, last, summits.inside[summit] > 0, relaxed_[patch]);
      isOne = first == last;
      setEntry(patch, first, next, isOne ? along / line_.spacing : 1);
      whole = first + 1;
    } else {
      clear(patch);
      hasLeft_ = true;
    }
    if (whole < last) addWhole(whole, last);
    patches_.lastHeight[patch] = summits.nodeHeight[summit];
    patches_.lastSlope[patch] = summits.slope[summit];
    patches_.lastLength[patch] = isOne ? 0 : along;
  }

  /// Returns the segment in which contact begins: the one before the first node, from `node` on,
  /// that is deeper than the free surface, which has the depth `relaxed` at that node.
  HWY_INLINE std::size_t findEntry(std::size_t node, std::size_t last, bool inside,
                                   double relaxed) const {
    const One d = One::all(depth_);
    for (; node <= last; node += One::kLanes) {
      const std::size_t count = std::min(One::kLanes, last + 1 - node);
      const One depth = d - One::loadFirst(line_.heightAboveMinimum.data() + node, count);
      const unsigned deeper = bitsOf(depth > One::all(relaxed) * decay_) & ((1U << count) - 1);
      if (deeper != 0) return node + static_cast<std::size_t>(std::countr_zero(deeper)) - 1;
      relaxed *= decayOverAll_;
    }
    return inside ? last : last - 1;
  }

  /// next: the node up to which arcLength has been counted.
  HWY_INLINE void setEntry(std::size_t patch, std::size_t segment, std::size_t next, double end) {
    const bool isBack = line_.isMeasuredBack(segment);
    const std::size_t low = isBack ? segment + 1 : segment, high = isBack ? segment : segment + 1;
    patches_.arcLength[patch] +=
        line_.spacing * static_cast<double>(static_cast<std::ptrdiff_t>(low - next));
    patches_.low[patch] = line_.heightAboveMinimum[low];
    patches_.climb[patch] = line_.heightAboveMinimum[high] - line_.heightAboveMinimum[low];
    patches_.onwards[patch] = isBack ? -1 : 1;
    patches_.end[patch] = end;
  }

  HWY_INLINE void clear(std::size_t patch) {
    for (double* values : {patches_.arcDepth, patches_.arcHeight, patches_.arcLength, patches_.low,
                           patches_.climb, patches_.onwards, patches_.end, patches_.lastHeight,
                           patches_.lastSlope, patches_.lastLength})
      values[patch] = 0;
  }

  /// Adds segments that are completely in contact.
  HWY_INLINE void addWhole(std::size_t from, std::size_t to) {
    whole_ += to - from;
    wholeClimb_ += line_.heightAboveMinimum[to] - line_.heightAboveMinimum[from];
    One heights = wholeHeights_, slopes = wholeSlopes_;
    for (std::size_t i = from; i < to; i += One::kLanes) {
      const std::size_t count = std::min(One::kLanes, to - i);
      const One slope = One::loadFirst(line_.slopeIn.data() + i, count);
      heights = heights + (One::loadFirst(line_.heightAboveMinimum.data() + i, count) +
                           One::loadFirst(line_.heightAboveMinimum.data() + i + 1, count));
      slopes = mulAdd(slope, slope, slopes);
    }
    wholeHeights_ = heights;
    wholeSlopes_ = slopes;
  }

  HWY_INLINE void addParts(std::size_t k) {
    const Wide d = Wide::all(depth_), c = Wide::all(relaxationLength_),
               h = Wide::all(line_.spacing);
    const Wide depth = Wide::load(patches_.arcDepth + k),
               onwards = Wide::load(patches_.onwards + k);
    const Wide low = Wide::load(patches_.low + k), climb = Wide::load(patches_.climb + k);
    const Wide end = Wide::load(patches_.end + k), none = Wide::all(0);
    const WideMask isOnwards = onwards > none;
    const Wide rate = Wide::all(inverse_);
    const WideArc arc{depth, Wide::load(patches_.arcLength + k) * rate, onwards * h * rate};
    const WideGap<WideStraight> gap{{Wide::load(patches_.arcHeight + k) - low, -climb}, arc};
    // Find where the line meets the free surface.
    const WideRoot entry = entryIn(gap, end, isOnwards);
    addArc(depth, onlyIn(end > none, c * entry.lost), entry.lost);
    // Add contact in the first segment of the patch and in its last.
    const Wide from = onlyIn(isOnwards, entry.t),
               length = h * select(isOnwards, end - entry.t, entry.t);
    addPart(negMulAdd(climb, from, d - low), climb / h, length, onwards);
    addPart(d - Wide::load(patches_.lastHeight + k), Wide::load(patches_.lastSlope + k),
            Wide::load(patches_.lastLength + k), Wide::all(1));
  }

  static HWY_INLINE WideRoot entryIn(const WideGap<WideStraight>& gap, Wide end,
                                     WideMask isOnwards) {
    const Wide none = Wide::all(0), to = onlyIn(isOnwards, end);
    const Wide lost = gap.arc.lostAt(to), value = gap.valueAt(to, lost);
    // Where contact is a single point, rounding may have moved it out.
    const WideMask wanted = (end > none) & (value > none);
    Wide guess = gap.step(to, value, lost);
    guess = select((guess >= none) & (guess <= end), guess, times(0.5, end));
    const WideRoot root = rootBetween(gap, none, end, isOnwards, guess, wanted);
    return {select(wanted, root.t, to), select(wanted, root.lost, lost)};
  }

  HWY_INLINE void addArc(Wide depth, Wide forgotten, Wide lost) {
    freeDepths_ = mulAdd(depth, forgotten, freeDepths_);
    freeStiffness_ = freeStiffness_ + forgotten;
    // 1 - e^2 = (1 - e)(1 + e)
    freeLoss_ = mulAdd(times(0.5, depth * depth), lost * (Wide::all(2) - lost), freeLoss_);
  }

  /// Adds contact over a part of a segment, from its lower end on, where w is `depth`.
  HWY_INLINE void addPart(Wide depth, Wide slope, Wide length, Wide onwards) {
    const Wide climb = slope * length;
    length_ = length_ + length;
    depths_ = mulAdd(length, negMulAdd(times(0.5, climb), Wide::all(1), depth), depths_);
    slopes_ = mulAdd(slope, climb, slopes_);
    climbs_ = mulAdd(onwards, climb, climbs_);
  }

  static HWY_INLINE double totalOf(One values) {
    return hn::GetLane(hn::SumOfLanes(kTag, values.v));
  }
  template <class T>
  static HWY_INLINE double totalOf(Pair<T> values) {
    return totalOf(values.a + values.b);
  }

  struct Left {
    double position, along, height, depth;  // s of its segment and from its start, z, w; m
  };

  const PreparedProfile& line_;
  double depth_, relaxationLength_, inverse_;
  SummitSearch search_;
  double highest_ = -std::numeric_limits<double>::infinity();  // order of the last top
  bool hasLeft_ = false;
  Left left_{};  // end of the last patch
  Patches patches_;
  // m, depth of the free surface up to which arcs are counted
  alignas(64) Patches::Values relaxed_;
  One decay_;              // of a free surface over 0, 1, ... segments
  double decayOverAll_;    // over as many segments as a vector has lanes
  std::size_t whole_ = 0;  // number of segments
  std::size_t arcs_ = 0;   // number of free arcs
  double wholeClimb_ = 0;  // m
  One wholeHeights_ = One::all(0), wholeSlopes_ = One::all(0);  // m: of both ends; 1
  Wide length_ = Wide::all(0), depths_ = length_, slopes_ = length_, climbs_ = length_;
  Wide freeDepths_ = length_, freeStiffness_ = length_, freeLoss_ = length_;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
