// The body of runCubicPasses in kernels.h, compiled once per instruction set: it chooses the next
// segment of each lane. segment_step-inl.h computes inside the segments.

#if defined(ASPERITY_CUBIC_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_CUBIC_KERNEL_INL
#undef ASPERITY_CUBIC_KERNEL_INL
#else
#define ASPERITY_CUBIC_KERNEL_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/contact/kernels/segment_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

constexpr std::size_t kMaxLevels = 16;

class CubicKernel {
 public:
  CubicKernel(const PreparedProfile& line, PassQueue& queue)
      : line_(line), queue_(queue), last_(line.segments() - 1), levels_(line.blocks.size()) {}

  void run() {
    constexpr int kStepsBetweenQuestions = 256;
    // All lanes are idle and have harmless numbers.
    for (std::size_t lane = kLanes; lane-- > 0;) {
      begin(lane, 0, last_);
      lanes_.busy[lane] = 0;
      idle_[idleCount_++] = lane;
    }
    // Begin the first pass of every stream.
    for (std::size_t stream = 0; stream < kLanes; ++stream) {
      PassRequest request;
      if (queue_.begin(stream, request)) setPass(stream, request);
    }
    fillLanes();
    int untilQuestion = kStepsBetweenQuestions;
    for (; idleCount_ < kLanes; --untilQuestion) {
      // Ask from time to time whether to stop.
      if (untilQuestion == 0) {
        if (queue_.isStopped()) return;
        untilQuestion = kStepsBetweenQuestions;
      }
      // Every lane computes the next piece of its segment.
      SegmentStep(lanes_).run();
      // Lanes that have finished their segments continue: first those in contact, then free ones,
      // so that branches are predictable.
      const unsigned pressed = lanes_.finished & lanes_.pressed, free = lanes_.finished & ~pressed;
      for (unsigned left = pressed; left != 0; left &= left - 1) goOn<true>(lowestBit(left));
      for (unsigned left = free; left != 0; left &= left - 1) goOn<false>(lowestBit(left));
    }
  }

 private:
  static constexpr std::size_t kLanes = Wide::kLanes;
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kWindow = BlockLevel::kPadding;  // blocks compared at once

  /// A pass that is running.
  struct Pass {
    PassRequest request;
    PassSums sums;
    std::size_t parts = 0, running = 0;     // started; of these, unfinished
    std::size_t from = kNone, nextCut = 0;  // where the next part begins, and may end
    double inverse = 0;
    // lost part of a depth over 0, 1, ... blocks of each level
    double lost[kMaxLevels][kWindow + 1];
  };
  /// A part of a pass: segments up to `last`.
  struct Part {
    std::size_t pass = 0, segment = 0, last = 0;
    double segmentsInspected = 0;
  };

  void setPass(std::size_t stream, const PassRequest& request) {
    Pass& pass = passes_[stream];
    if (pass.inverse == 0 || pass.request.relaxationLength != request.relaxationLength)
      setRelaxation(pass, request.relaxationLength);
    pass.request = request;
    pass.sums = {};
    pass.sums.work = kNotGathered;
    pass.parts = pass.running = pass.nextCut = pass.from = 0;
  }

  /// Gives idle lanes the earliest parts of any pass: so lanes stay near each other, and data of a
  /// long line that one of them has read are in the cache for the others.
  void fillLanes() {
    for (std::size_t from = 0; idleCount_ > 0 && from != kNone;) {
      std::size_t first = 0;
      for (std::size_t stream = 1; stream < kLanes; ++stream)
        if (passes_[stream].from < passes_[first].from) first = stream;
      from = passes_[first].from;
      if (from != kNone) beginPart(first);
    }
  }

  void beginPart(std::size_t stream) {
    Pass& pass = passes_[stream];
    const std::size_t lane = idle_[--idleCount_], from = pass.from;
    std::size_t last = last_;
    pass.from = kNone;
    // The part ends before the next cut with certain contact, if the pass may be cut further.
    const std::size_t wanted = static_cast<std::size_t>(pass.request.parts),
                      cuts = line_.cuts.size();
    ++pass.parts;
    ++pass.running;
    for (std::size_t k = pass.nextCut; k < cuts && pass.parts < wanted; ++k) {
      // The skipped cuts are spread evenly.
      if (k * wanted < pass.parts * cuts || !touchesAt(line_.cuts[k], pass.request)) continue;
      pass.from = line_.cuts[k].segment;
      last = pass.from - 1;
      pass.nextCut = k + 1;
      break;
    }
    parts_[lane].pass = stream;
    begin(lane, from, last);
  }

  void setRelaxation(Pass& pass, double relaxationLength) {
    // Without relaxation the free surface returns at once.
    pass.inverse = relaxationLength > 0 ? std::min(1 / relaxationLength, 1e300) : 1e300;
    double one = -std::expm1(-line_.spacing * pass.inverse);
    for (std::size_t level = 0; level < levels_; ++level) {
      double* lost = pass.lost[level];
      lost[0] = 0;
      for (std::size_t k = 0; k < kWindow; ++k) lost[k + 1] = lost[k] + (1 - lost[k]) * one;
      one = lost[4];
    }
  }

  /// Returns whether contact is certain at the cut: w e^(s/c) grows over the segment before it, the
  /// line further back within `clear` is not as deep, and anything from beyond has relaxed below
  /// it.
  bool touchesAt(const PreparedProfile::Cut& cut, const PassRequest& request) const {
    const SegmentBounds before = line_.blocks[0][cut.segment - 2];
    const double height = line_.heightAboveMinimum[cut.segment], w = request.depth - height;
    return request.depth - before.highest - request.relaxationLength * before.steepest > 0 &&
           w > 0 && cut.clear >= request.relaxationLength * std::log1p(height / w);
  }

  void begin(std::size_t lane, std::size_t from, std::size_t last) {
    Part& part = parts_[lane];
    const Pass& pass = passes_[part.pass];
    part.segment = from;
    part.last = last;
    part.segmentsInspected = 0;
    lanes_.depth[lane] = pass.request.depth;
    lanes_.relaxationLength[lane] = pass.request.relaxationLength;
    lanes_.inverse[lane] = pass.inverse;
    lanes_.arcHeight[lane] = lanes_.arcPosition[lane] = lanes_.surface[lane] = 0;
    lanes_.sumDepth[lane] = lanes_.freeStiffness[lane] = lanes_.freeLoss[lane] = 0;
    lanes_.gaps[lane] = 0;
    lanes_.contactLength[lane] = lanes_.slopeSquared[lane] = lanes_.sumPressure[lane] = 0;
    lanes_.busy[lane] = lanes_.touching[lane] = lanes_.limit[lane] = 1;
    lanes_.from[lane] = lanes_.isPressedAtLimit[lane] = lanes_.closes[lane] = 0;
    load(lane);
  }

  static std::size_t lowestBit(unsigned bits) {
    return static_cast<std::size_t>(std::countr_zero(bits));
  }

  /// Continues after a finished segment: takes whole blocks, then the next segment.
  template <bool kPressed>
  HWY_INLINE void goOn(std::size_t lane) {
    Part& part = parts_[lane];
    ++part.segmentsInspected;
    if (part.segment == part.last) return endPart(lane);
    ++part.segment;
    if (kPressed)
      skipPressed(lane, part);
    else
      skipFree(lane, part);
    load(lane);
  }

  void endPart(std::size_t lane) {
    const Part& part = parts_[lane];
    const std::size_t stream = part.pass;
    Pass& pass = passes_[stream];
    PassSums& sums = pass.sums;
    const double length = lanes_.contactLength[lane], slopes = lanes_.slopeSquared[lane];
    sums.depth += lanes_.sumDepth[lane];
    sums.contactLength += length;
    sums.stiffness += length + lanes_.freeStiffness[lane];
    sums.slopeSquared += slopes;
    sums.dissipation += pass.request.relaxationLength * slopes + lanes_.freeLoss[lane];
    sums.pressure += lanes_.sumPressure[lane];
    sums.gaps += lanes_.gaps[lane];
    sums.segmentsInspected += part.segmentsInspected;
    lanes_.busy[lane] = 0;
    idle_[idleCount_++] = lane;
    PassRequest request;
    if (--pass.running == 0 && pass.from == kNone && queue_.next(stream, sums, request))
      setPass(stream, request);
    fillLanes();
  }

  /// Goes from segment i at most to the last, over as many `simple` blocks at once as possible, up
  /// and down the levels; returns where it stops. simple(level, block) compares kWindow blocks,
  /// take(level, block, count) takes simple ones.
  template <class Simple, class Take>
  HWY_INLINE std::size_t skip(std::size_t i, std::size_t last, const Simple& simple,
                              const Take& take) const {
    for (std::size_t level = 0; i < last;) {
      const std::size_t block = (i - 1) >> (2 * level);
      // The run ends where the next level's blocks begin.
      const std::size_t most = std::min(kWindow - (block & 3), (last - i) >> (2 * level));
      const std::size_t count = most > 0 ? std::min(simple(level, block), most) : 0;
      if (count > 0) take(level, block, count);
      i += count << (2 * level);
      if (count > 0 && count == most && ((block + count) & 3) == 0 && level + 1 < levels_)
        ++level;
      else if (level > 0)
        --level;
      else if (count < most)
        break;
    }
    return i;
  }

  /// Returns the first of kWindow blocks for which `holds` is false, or kWindow.
  template <class Holds>
  static HWY_INLINE std::size_t firstOther(const Holds& holds) {
    for (std::size_t k = 0; k < kWindow; k += One::kLanes) {
      const auto other = hn::Not(holds(k).m);
      if (!hn::AllFalse(kTag, other))
        return k + static_cast<std::size_t>(hn::FindFirstTrue(kTag, other));
    }
    return kWindow;
  }

  HWY_INLINE void skipFree(std::size_t lane, Part& part) {
    const Pass& pass = passes_[part.pass];
    const One depth = One::all(lanes_.depth[lane]);
    double surface = lanes_.surface[lane];
    const auto isFree = [&](std::size_t level, std::size_t block) {
      const double* lowest = line_.blocks[level].lowest.data() + block;
      const double* lost = pass.lost[level];
      const One start = One::all(surface), over = depth - start;
      return firstOther([&](std::size_t k) {
        return One::load(lowest + k) >= mulAdd(over, One::load(lost + k + 1), start);
      });
    };
    part.segment = skip(part.segment, part.last, isFree,
                        [&](std::size_t level, std::size_t, std::size_t count) {
                          surface += (lanes_.depth[lane] - surface) * pass.lost[level][count];
                        });
  }

  HWY_INLINE void skipPressed(std::size_t lane, Part& part) {
    const double depth = lanes_.depth[lane], c = lanes_.relaxationLength[lane];
    const std::size_t from = part.segment;
    const One wideDepth = One::all(depth), wideLength = One::all(c);
    double heights = 0, slopes = 0;
    const auto isPressed = [&](std::size_t level, std::size_t block) {
      const double* highest = line_.blocks[level].highest.data() + block;
      const double* steepest = line_.blocks[level].steepest.data() + block;
      return firstOther([&](std::size_t k) {
        const One least = wideDepth - One::load(highest + k);
        return negMulAdd(wideLength, One::load(steepest + k), least) > One::all(0);
      });
    };
    const auto take = [&](std::size_t level, std::size_t block, std::size_t count) {
      heights += sumOfFirst(count, line_.blocks[level].heightIntegral.data() + block);
      slopes += sumOfFirst(count, line_.blocks[level].slopeSquared.data() + block);
    };
    const std::size_t to = skip(from, part.last, isPressed, take);
    if (to == from) return;
    part.segment = to;
    const double length = line_.spacing * static_cast<double>(to - from);
    const double depths = depth * length - heights;
    lanes_.sumDepth[lane] += depths;
    lanes_.contactLength[lane] += length;
    lanes_.slopeSquared[lane] += slopes;
    lanes_.sumPressure[lane] +=
        depths - c * (line_.heightAboveMinimum[to] - line_.heightAboveMinimum[from]);
  }

  static HWY_INLINE double sumOfFirst(std::size_t count, const double* values) {
    auto sum = hn::Zero(kTag);
    for (std::size_t k = 0; k < kWindow && k < count; k += One::kLanes) {
      const auto used = hn::FirstN(kTag, std::min(count - k, One::kLanes));
      sum = hn::Add(sum, hn::IfThenElseZero(used, hn::LoadU(kTag, values + k)));
    }
    return hn::GetLane(hn::SumOfLanes(kTag, sum));
  }

  /// Loads a segment with few stores, because the vectors read them at once. Segments are measured
  /// from their lower end, as in the plain pass.
  HWY_INLINE void load(std::size_t lane) {
    const std::size_t i = parts_[lane].segment;
    const bool isBack = line_.isMeasuredBack(i);
    const std::size_t first = isBack ? i + 1 : i, second = isBack ? i : i + 1;
    const double length = line_.segmentLength(i);
    lanes_.height0[lane] = line_.heightAboveMinimum[first];
    lanes_.height1[lane] = line_.heightAboveMinimum[second];
    lanes_.start[lane] = line_.position(first);
    lanes_.along[lane] = isBack ? -length : length;
    lanes_.slope0[lane] = isBack ? -line_.slopeOut[i] : line_.slopeIn[i];
    lanes_.slope1[lane] = isBack ? -line_.slopeIn[i] : line_.slopeOut[i];
    if (i == parts_[lane].last) lanes_.closes[lane] = 1;
  }

  const PreparedProfile& line_;
  PassQueue& queue_;
  std::size_t last_, levels_;
  Pass passes_[kLanes];
  Part parts_[kLanes];
  Lanes lanes_;
  std::size_t idle_[kLanes], idleCount_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
