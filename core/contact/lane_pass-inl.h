// The body of lane_pass.h, compiled once per instruction set. See resolved_pass.cpp for the same
// steps in plain form; names follow it. Read it first.

#if defined(ASPERITY_LANE_PASS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_LANE_PASS_INL
#undef ASPERITY_LANE_PASS_INL
#else
#define ASPERITY_LANE_PASS_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "core/contact/lane_pass.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, kMostLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

constexpr D d;
constexpr int kMostRootSteps = 100;
/// A root's last step, relative, for a contact may be far shorter than its segment; what is left of
/// the error is its cube.
constexpr double kRootStep = 1e-6;

HWY_INLINE V set(double value) {
  return hn::Set(d, value);
}
HWY_INLINE M noLane() {
  return hn::FirstN(d, 0);
}
HWY_INLINE bool any(M mask) {
  return !hn::AllFalse(d, mask);
}

/// c0 + c1 t + c2 t^2 + c3 t^3, the same in all lanes.
struct Segment {
  double c0, c1, c2, c3;

  HWY_INLINE V at(V t) const {
    return hn::MulAdd(t, hn::MulAdd(t, hn::MulAdd(t, set(c3), set(c2)), set(c1)), set(c0));
  }
  HWY_INLINE V slopeAt(V t) const {
    return hn::MulAdd(t, hn::MulAdd(t, set(3 * c3), set(2 * c2)), set(c1));
  }
  HWY_INLINE V halfCurvatureAt(V t) const { return hn::MulAdd(t, set(3 * c3), set(c2)); }
};

/// p over a segment, per 4G: a polynomial that differs from lane to lane.
struct Pressure {
  V c0, c1, c2, c3;

  HWY_INLINE V at(V t) const { return hn::MulAdd(t, hn::MulAdd(t, hn::MulAdd(t, c3, c2), c1), c0); }
  HWY_INLINE V slopeAt(V t) const {
    return hn::MulAdd(t, hn::MulAdd(t, hn::Mul(c3, set(3)), hn::Add(c2, c2)), c1);
  }
  HWY_INLINE V halfCurvatureAt(V t) const { return hn::MulAdd(hn::Mul(c3, set(3)), t, c2); }
};

/// Halley's method inside [low, high] for the lanes wanted, bisection where it would leave.
/// function(t, value, slope, half of the curvature); the sign of its value at `low` is given.
template <class Function>
HWY_INLINE V rootBetween(V low, V high, M negativeAtLow, V guess, M wanted,
                         const Function& function) {
  V t = guess;
  for (int step = 0; step < kMostRootSteps; ++step) {
    V value, slope, halfCurvature;
    function(t, value, slope, halfCurvature);
    const M before = hn::Xor(hn::Lt(value, hn::Zero(d)), hn::Not(negativeAtLow));
    low = hn::IfThenElse(before, t, low);
    high = hn::IfThenElse(before, high, t);
    const V below = hn::NegMulAdd(value, halfCurvature, hn::Mul(slope, slope));
    V next = hn::Sub(t, hn::Div(hn::Mul(value, slope), below));
    const M inside = hn::And(hn::Ge(next, low), hn::Le(next, high));
    next = hn::IfThenElse(inside, next, hn::Mul(set(0.5), hn::Add(low, high)));
    const V moved = hn::Abs(hn::Sub(next, t));
    t = next;
    if (hn::AllFalse(d, hn::And(wanted, hn::Gt(moved, hn::MulAdd(t, set(kRootStep), set(1e-24))))))
      break;
  }
  return t;
}

template <bool kLinear>
class LanePass {
 public:
  LanePass(const TravelLine& line, const double* depth, const double* memory)
      : line_(line), depth_(hn::Load(d, depth)), memory_(hn::Load(d, memory)) {
    const V large = set(1e300);
    inverse_ = hn::Min(hn::Div(set(1), hn::Max(memory_, set(1e-300))), large);
    kept_[0] = decay(set(line.spacing));
    for (std::size_t k = 1; k < line.blocks.size(); ++k) {
      const V squared = hn::Mul(kept_[k - 1], kept_[k - 1]);
      kept_[k] = hn::Mul(squared, squared);
    }
  }

  HWY_INLINE void run(LaneSums& sums) {
    touching_ = hn::Eq(depth_, depth_);
    const std::size_t last = line_.segments() - 1;
    edges(0, touching_);
    int level = 0;
    for (std::size_t i = 1; i < last;) level = advance(i, level);
    if (last > 0) edges(last, hn::Eq(depth_, depth_));
    // The lowest point of the next period takes over, always in contact.
    closeArcs(hn::Not(touching_), set(line_.length));
    store(sums);
  }

 private:
  /// exp(-distance / c), without the denormal numbers at its far end.
  HWY_INLINE V decay(V distance) const {
    return hn::Exp(d, hn::Max(hn::Neg(hn::Mul(distance, inverse_)), set(-700)));
  }

  /// Takes the largest whole block at i that needs no look inside, or the edges of segment i.
  HWY_INLINE int advance(std::size_t& i, int level) {
    const int top = static_cast<int>(line_.blocks.size()) - 1;
    while (true) {
      const std::size_t from = i - 1, size = std::size_t{1} << (2 * level);
      const bool aligned = (from & (size - 1)) == 0;
      const std::size_t block = from >> (2 * level);
      if (!aligned || block >= line_.blocks[static_cast<std::size_t>(level)].size()) {
        --level;
        continue;
      }
      const SegmentBounds& bounds = line_.blocks[static_cast<std::size_t>(level)][block];
      const V far = hn::Mul(here_, kept_[level]);
      const M freely = hn::AndNot(touching_, hn::Le(hn::Sub(depth_, set(bounds.lowest)), far));
      const V least =
          hn::NegMulAdd(memory_, set(bounds.steepest), hn::Sub(depth_, set(bounds.highest)));
      const M pressed = hn::And(touching_, hn::Gt(least, hn::Zero(d)));
      const M simple = hn::Or(freely, pressed);
      if (hn::AllTrue(d, simple)) {
        takeWhole(bounds, line_.spacing * static_cast<double>(size),
                  line_.rise[i + size] - line_.rise[i], far, freely, pressed);
        i += size;
        return level < top ? level + 1 : level;
      }
      if (level == 0) {
        takeWhole(bounds, line_.spacing, line_.rise[i + 1] - line_.rise[i], far, freely, pressed);
        edges(i, hn::Not(simple));
        ++i;
        return 0;
      }
      --level;
    }
  }

  HWY_INLINE void takeWhole(const SegmentBounds& bounds, double length, double climb, V far,
                            M freely, M pressed) {
    here_ = hn::IfThenElse(freely, far, here_);
    const V span = set(length), none = hn::Zero(d);
    const V depths = hn::MulSub(depth_, span, set(bounds.riseIntegral));
    sumDepth_ = hn::Add(sumDepth_, hn::IfThenElse(pressed, depths, none));
    contactLength_ = hn::Add(contactLength_, hn::IfThenElse(pressed, span, none));
    slopeSquared_ = hn::Add(slopeSquared_, hn::IfThenElse(pressed, set(bounds.slopeSquared), none));
    const V pressure = hn::NegMulAdd(memory_, set(climb), depths);
    pressure_ = hn::Add(pressure_, hn::IfThenElse(pressed, pressure, none));
  }

  HWY_INLINE V freeDepth(V position) const {
    return hn::Mul(arcDepth_, decay(hn::Sub(position, arcPosition_)));
  }

  /// Free arcs of these lanes end at `position`.
  HWY_INLINE void closeArcs(M lanes, V position) {
    if (!any(lanes)) return;
    const V over = hn::Max(hn::Mul(hn::Sub(position, arcPosition_), inverse_), hn::Zero(d));
    const V exponent = hn::Max(hn::Neg(over), set(-350));
    const V lost = hn::Neg(hn::Expm1(d, exponent));  // 1 - e
    const V forgotten = hn::Mul(memory_, lost);
    // 1 - e^2 = (1 - e)(1 + e)
    const V energy = hn::Mul(hn::Mul(set(0.5), hn::Mul(arcDepth_, arcDepth_)),
                             hn::Mul(lost, hn::Sub(set(2), lost)));
    const V none = hn::Zero(d);
    sumDepth_ = hn::Add(sumDepth_, hn::IfThenElse(lanes, hn::Mul(arcDepth_, forgotten), none));
    freeStiffness_ = hn::Add(freeStiffness_, hn::IfThenElse(lanes, forgotten, none));
    freeLoss_ = hn::Add(freeLoss_, hn::IfThenElse(lanes, energy, none));
  }

  /// Looks inside segment i, for these lanes.
  HWY_INLINE void edges(std::size_t i, M lanes) {
    // The last segment is measured back from its end, as in the plain pass.
    onwards_ = i + 1 < line_.segments();
    start_ = onwards_ ? line_.position[i] : line_.length;
    span_ = line_.segmentLength(i);
    along_ = onwards_ ? span_ : -span_;
    const Cubic cubic = onwards_ ? line_.segment(i) : line_.segmentBackwards(i);
    segment_ = {cubic.c0, cubic.c1, cubic.c2, cubic.c3};
    const V k = hn::Div(memory_, set(along_));
    Pressure p;
    p.c0 = hn::NegMulAdd(k, set(cubic.c1), hn::Sub(depth_, set(cubic.c0)));
    p.c1 = hn::NegMulSub(hn::Add(k, k), set(cubic.c2), set(cubic.c1));
    p.c2 = hn::NegMulSub(hn::Mul(set(3), k), set(cubic.c3), set(cubic.c2));
    p.c3 = set(-cubic.c3);
    left_ = noLane();
    pieces(p, lanes);
    const M free = hn::AndNot(touching_, lanes);
    if (!any(free)) return;
    const bool part = i == 0 || i + 1 == line_.segments();
    const V relaxed = hn::Mul(here_, kept_[0]);
    const bool left = part || any(hn::And(free, left_));
    here_ = hn::IfThenElse(free, left ? freeDepth(set(line_.position[i + 1])) : relaxed, here_);
  }

  /// y of free lanes at t, good enough to choose by; at the segment's ends it is known already.
  HWY_INLINE V roughDepth(V t) const {
    const M atStart = hn::Eq(t, set(onwards_ ? 0 : 1));
    const bool known = hn::AllTrue(d, hn::Or(atStart, touching_));
    return known ? here_ : hn::IfThenElse(atStart, here_, freeDepth(placeOf(t)));
  }

  /// Splits the segment where p may turn, so that p is monotone on each piece.
  HWY_INLINE void pieces(const Pressure& p, M lanes) {
    const V zero = hn::Zero(d), one = set(1);
    const V atEnd = p.at(one);
    if (!kLinear) {
      // Control points of p' over [0, 1]: of one sign, p is monotone.
      const V b0 = p.c1, b1 = hn::Add(p.c1, p.c2), b2 = p.slopeAt(one);
      const V product = hn::Min(hn::Mul(b0, b1), hn::Mul(b0, b2));
      const M turns = hn::And(lanes, hn::Lt(product, zero));
      if (any(turns)) return threePieces(p, lanes, atEnd);
    }
    if (onwards_)
      piece(p, zero, one, p.c0, atEnd, lanes);
    else
      piece(p, one, zero, atEnd, p.c0, lanes);
  }

  HWY_INLINE void threePieces(const Pressure& p, M lanes, V atEnd) {
    const V zero = hn::Zero(d), one = set(1);
    // Zeros of c1 + 2 c2 t + 3 c3 t^2 without cancellation; outside (0, 1) they do no harm.
    const V a = hn::Mul(set(3), p.c3);
    const V root = hn::Sqrt(hn::Max(hn::NegMulAdd(a, p.c1, hn::Mul(p.c2, p.c2)), zero));
    const V q = hn::Neg(hn::Add(p.c2, hn::CopySign(root, p.c2)));
    const auto inside = [&](V t) {  // also catches the NaN of 0 / 0
      return hn::IfThenElse(hn::And(hn::Gt(t, zero), hn::Lt(t, one)), t, zero);
    };
    const V first = inside(hn::Div(q, a)), second = inside(hn::Div(p.c1, q));
    const V low = hn::Min(first, second), high = hn::Max(first, second);
    const V atLow = p.at(low), atHigh = p.at(high);
    const M hasLow = hn::And(lanes, hn::Gt(low, zero));
    const M hasHigh = hn::And(lanes, hn::Gt(high, low));
    if (onwards_) {
      if (any(hasLow)) piece(p, zero, low, p.c0, atLow, hasLow);
      if (any(hasHigh)) piece(p, low, high, atLow, atHigh, hasHigh);
      piece(p, high, one, atHigh, atEnd, lanes);
    } else {
      piece(p, one, high, atEnd, atHigh, lanes);
      if (any(hasHigh)) piece(p, high, low, atHigh, atLow, hasHigh);
      if (any(hasLow)) piece(p, low, zero, atLow, p.c0, hasLow);
    }
  }

  /// [from, to], where p is monotone: at most one stretch of it is pressed.
  HWY_INLINE void piece(const Pressure& p, V from, V to, V pFrom, V pTo, M lanes) {
    const V zero = hn::Zero(d);
    const M upFrom = hn::And(lanes, hn::Gt(pFrom, zero));
    const M upTo = hn::And(lanes, hn::Gt(pTo, zero));
    const M crosses = hn::Xor(upFrom, upTo);
    V crossing = from;
    if (any(crosses)) crossing = pressureZero(p, from, to, pFrom, pTo, crosses);
    leave(hn::AndNot(upFrom, hn::And(lanes, touching_)), from);
    const M pressed = hn::Or(upFrom, upTo);
    if (!any(pressed)) return;
    const V begin = hn::IfThenElse(upFrom, from, crossing);
    const V end = hn::IfThenElse(upTo, to, crossing);
    const V entry = enter(begin, end, hn::AndNot(touching_, pressed));
    const M contact = hn::And(pressed, touching_);
    addContact(entry, end, contact);
    leave(hn::AndNot(upTo, contact), end);
  }

  HWY_INLINE V pressureZero(const Pressure& p, V from, V to, V pFrom, V pTo, M wanted) {
    const V guess = hn::MulAdd(hn::Sub(to, from), hn::Div(pFrom, hn::Sub(pFrom, pTo)), from);
    if (kLinear) return hn::IfThenElse(wanted, guess, from);
    const M negativeAtLow = hn::Lt(onwards_ ? pFrom : pTo, hn::Zero(d));
    const V t = rootBetween(onwards_ ? from : to, onwards_ ? to : from, negativeAtLow, guess,
                            wanted, [&p](V at, V& value, V& slope, V& halfCurvature) {
                              value = p.at(at);
                              slope = p.slopeAt(at);
                              halfCurvature = p.halfCurvatureAt(at);
                            });
    return hn::IfThenElse(wanted, t, from);
  }

  HWY_INLINE void leave(M lanes, V t) {
    if (!any(lanes)) return;
    arcDepth_ = hn::IfThenElse(lanes, hn::Sub(depth_, segment_.at(t)), arcDepth_);
    arcPosition_ = hn::IfThenElse(lanes, placeOf(t), arcPosition_);
    left_ = hn::Or(left_, lanes);
    touching_ = hn::AndNot(lanes, touching_);
  }

  HWY_INLINE V placeOf(V t) const { return hn::MulAdd(t, set(along_), set(start_)); }

  /// Where the line catches up with the free surface between begin and end, for free lanes; the
  /// others begin at once.
  HWY_INLINE V enter(V begin, V end, M freely) {
    if (!any(freely)) return begin;
    const V gapAtEnd = hn::Sub(hn::Sub(depth_, segment_.at(end)), freeDepth(placeOf(end)));
    const M enters = hn::And(freely, hn::Gt(gapAtEnd, hn::Zero(d)));
    if (!any(enters)) return begin;
    const V gapAtBegin = hn::Sub(hn::Sub(depth_, segment_.at(begin)), roughDepth(begin));
    const M inside = hn::And(enters, hn::Lt(gapAtBegin, hn::Zero(d)));
    V entry = begin;
    if (any(inside)) {
      const V guess = hn::MulAdd(hn::Sub(end, begin),
                                 hn::Div(gapAtBegin, hn::Sub(gapAtBegin, gapAtEnd)), begin);
      const V rate = hn::Mul(set(along_), inverse_);
      const V low = onwards_ ? begin : end, high = onwards_ ? end : begin;
      const V t = rootBetween(low, high, onwards_ ? inside : hn::Not(inside), guess, inside,
                              [&](V at, V& value, V& slope, V& halfCurvature) {
                                const V free = freeDepth(placeOf(at));
                                value = hn::Sub(hn::Sub(depth_, segment_.at(at)), free);
                                slope = hn::MulSub(rate, free, segment_.slopeAt(at));
                                halfCurvature =
                                    hn::NegMulSub(hn::Mul(rate, hn::Mul(rate, free)), set(0.5),
                                                  segment_.halfCurvatureAt(at));
                              });
      entry = hn::IfThenElse(inside, t, begin);
    }
    closeArcs(enters, placeOf(entry));
    touching_ = hn::Or(touching_, enters);
    return entry;
  }

  /// Sums between two places of this segment, by the polynomial about the lower one.
  HWY_INLINE void addContact(V begin, V end, M lanes) {
    const V from = hn::Min(begin, end);
    const V x = hn::Abs(hn::Sub(end, begin)), none = hn::Zero(d);
    const V w = hn::Sub(depth_, segment_.at(from)), c1 = segment_.slopeAt(from);
    const V c3 = set(segment_.c3);
    const V c2 = hn::MulAdd(set(3 * segment_.c3), from, set(segment_.c2));
    // Integral of the rise's change: x^2 (c1 / 2 + x (c2 / 3 + x c3 / 4)).
    const V change =
        hn::Mul(hn::Mul(x, x),
                hn::MulAdd(x, hn::MulAdd(x, hn::Mul(c3, set(0.25)), hn::Mul(c2, set(1.0 / 3))),
                           hn::Mul(c1, set(0.5))));
    const V depths = hn::Mul(set(span_), hn::MulSub(w, x, change));
    // Integral of (c1 + b t + c t^2)^2.
    const V b = hn::Add(c2, c2), c = hn::Mul(set(3), c3);
    const V t5 = hn::Mul(hn::Mul(c, c), set(0.2));
    const V t4 = hn::MulAdd(x, t5, hn::Mul(hn::Mul(b, c), set(0.5)));
    const V t3 =
        hn::MulAdd(x, t4, hn::Mul(hn::MulAdd(b, b, hn::Mul(hn::Add(c1, c1), c)), set(1.0 / 3)));
    const V t2 = hn::MulAdd(x, t3, hn::Mul(c1, b));
    const V squares = hn::Mul(hn::Mul(x, hn::MulAdd(x, t2, hn::Mul(c1, c1))), set(1 / span_));
    sumDepth_ = hn::Add(sumDepth_, hn::IfThenElse(lanes, depths, none));
    contactLength_ = hn::Add(contactLength_, hn::IfThenElse(lanes, hn::Mul(x, set(span_)), none));
    slopeSquared_ = hn::Add(slopeSquared_, hn::IfThenElse(lanes, squares, none));
    const V climb = hn::Mul(x, hn::MulAdd(x, hn::MulAdd(x, c3, c2), c1));
    const V sinking = hn::Mul(memory_, onwards_ ? climb : hn::Neg(climb));
    pressure_ = hn::Add(pressure_, hn::IfThenElse(lanes, hn::Sub(depths, sinking), none));
  }

  HWY_INLINE void store(LaneSums& sums) const {
    hn::StoreU(sumDepth_, d, sums.depth.data());
    hn::StoreU(hn::Add(contactLength_, freeStiffness_), d, sums.stiffness.data());
    hn::StoreU(hn::MulAdd(memory_, slopeSquared_, freeLoss_), d, sums.dissipation.data());
    hn::StoreU(contactLength_, d, sums.contactLength.data());
    hn::StoreU(slopeSquared_, d, sums.slopeSquared.data());
    hn::StoreU(pressure_, d, sums.pressure.data());
  }

  static constexpr int kMostLevels = 16;

  const TravelLine& line_;
  V depth_, memory_, inverse_;
  V kept_[kMostLevels];  // decay over a block of each level
  M touching_ = noLane();
  M left_ = noLane();     // lanes that left the line in this segment
  V here_ = hn::Zero(d);  // y of free lanes at the next segment's start
  V arcDepth_ = hn::Zero(d), arcPosition_ = hn::Zero(d);
  V sumDepth_ = hn::Zero(d), freeStiffness_ = hn::Zero(d), freeLoss_ = hn::Zero(d);
  V contactLength_ = hn::Zero(d), slopeSquared_ = hn::Zero(d);
  V pressure_ = hn::Zero(d);
  Segment segment_{};
  double start_ = 0, span_ = 0, along_ = 0;  // s = start + t along, |along| = span
  bool onwards_ = true;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
