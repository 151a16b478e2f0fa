// One step of the cubic kernel: every lane computes the next piece of its own segment on which the
// pressure p is monotone. pass.cpp has the same events in plain form, with the same names.
// Compiled once per instruction set.

#if defined(ASPERITY_SEGMENT_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_SEGMENT_STEP_INL
#undef ASPERITY_SEGMENT_STEP_INL
#else
#define ASPERITY_SEGMENT_STEP_INL
#endif

#include "core/contact/kernels/arc_gap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// The state of the lanes. Lengths in m; t runs over a segment: s = start + t along, and `along` is
/// negative where a segment is measured back from its end.
struct alignas(64) Lanes {
  using Values = double[Wide::kLanes];

  Values depth, relaxationLength, inverse;  // d, c, 1 / c
  Values height0, height1, slope0, slope1;  // z and dz/d|s| at t = 0 and t = 1
  Values start, along;
  Values from, limit;                               // t reached; t of the segment's end, or less
  Values arcHeight, arcPosition;                    // where the elastomer left the line
  Values surface;                                   // height of free lanes at the segment's end
  Values sumDepth, freeStiffness, freeLoss;         // m^2, m, m^2
  Values contactLength, slopeSquared, sumPressure;  // m, m, m^2
  Values gaps;                                      // number
  // Flags, 1 or 0:
  Values busy, touching;
  Values closes;            // a free arc ends with this segment at the latest
  Values isPressedAtLimit;  // p vanishes there, from above
  // The same as bits, set by a step:
  unsigned finished, pressed;  // reached the end of their segment; are in contact
};

HWY_INLINE WideMask isSet(const Lanes::Values& values) {
  return Wide::load(values) > Wide::all(0);
}
HWY_INLINE void setFlags(WideMask mask, Lanes::Values& values) {
  onlyIn(mask, Wide::all(1)).store(values);
}

/// The polynomial c0 + c1 t + c2 t^2 + c3 t^3.
struct WideCubic {
  Wide c0, c1, c2, c3;

  /// Returns hermiteCubic of polynomial.h; `step`: difference of the two values.
  static HWY_INLINE WideCubic hermite(Wide value0, Wide step, Wide slope0, Wide slope1) {
    return {value0, slope0, mulSub(Wide::all(3), step, slope0 + slope0 + slope1),
            negMulAdd(Wide::all(2), step, slope0 + slope1)};
  }

  HWY_INLINE Wide at(Wide t) const { return mulAdd(t, mulAdd(t, mulAdd(t, c3, c2), c1), c0); }
  HWY_INLINE Wide slopeAt(Wide t) const { return mulAdd(t, mulAdd(t, times(3, c3), c2 + c2), c1); }
  HWY_INLINE Wide halfCurvatureAt(Wide t) const { return mulAdd(times(3, c3), t, c2); }
};

HWY_INLINE WideCubic select(WideMask m, const WideCubic& x, const WideCubic& y) {
  return {select(m, x.c0, y.c0), select(m, x.c1, y.c1), select(m, x.c2, y.c2),
          select(m, x.c3, y.c3)};
}

class SegmentStep {
 public:
  explicit HWY_INLINE SegmentStep(Lanes& lanes) : lanes_(lanes) {}

  HWY_INLINE void run() {
    readSegment();
    // Find the next piece of the segment on which p is monotone.
    findPiece();
    // Lanes in contact leave at once where p is not above 0 at the start of the piece.
    leave(touching_ & !upFrom_, from_);
    // Find the edge of contact inside the piece, if there is one.
    findEvents();
    // Add free arcs and contact to the sums.
    close();
    addContact();
    leave(exits_, edge_);
    finish();
  }

 private:
  HWY_INLINE void readSegment() {
    depth_ = Wide::load(lanes_.depth);
    relaxationLength_ = Wide::load(lanes_.relaxationLength);
    inverse_ = Wide::load(lanes_.inverse);
    busy_ = isSet(lanes_.busy);
    touching_ = busy_ & isSet(lanes_.touching);
    start_ = Wide::load(lanes_.start);
    along_ = Wide::load(lanes_.along);
    onwards_ = along_ > Wide::all(0);
    perAlong_ = Wide::all(1) / along_;
    end_ = onlyIn(onwards_, Wide::all(1));
    arcHeight_ = Wide::load(lanes_.arcHeight);
    arcPosition_ = Wide::load(lanes_.arcPosition);
    low_ = Wide::load(lanes_.height0);
    // w = d - z over the segment.
    const Wide step = low_ - Wide::load(lanes_.height1), span = abs(along_);
    const Wide m0 = -(Wide::load(lanes_.slope0) * span), m1 = -(Wide::load(lanes_.slope1) * span);
    inside_ = WideCubic::hermite(depth_ - low_, step, m0, m1);
    // p / 4G = w + c w'.
    const Wide k = relaxationLength_ * perAlong_;
    pressure_.c0 = mulAdd(k, inside_.c1, inside_.c0);
    pressure_.c1 = mulAdd(k + k, inside_.c2, inside_.c1);
    pressure_.c2 = mulAdd(times(3, k), inside_.c3, inside_.c2);
    pressure_.c3 = inside_.c3;
  }

  /// Finds the piece from the lane's position to where p turns next, or to the segment's end.
  HWY_INLINE void findPiece() {
    // Lanes enter every segment from 0 to 1; one measured back runs from 1 to 0.
    const Wide from = Wide::load(lanes_.from), limit = Wide::load(lanes_.limit);
    const WideMask turns = (from < limit) & !onwards_;
    from_ = select(turns, limit, from);
    to_ = select(turns, from, limit);
    // Zeros of c1 + 2 c2 t + 3 c3 t^2 without cancellation; NaN where there are none.
    const WideCubic& p = pressure_;
    const Wide a = times(3, p.c3);
    const Wide q = -(p.c2 + copySign(sqrt(negMulAdd(a, p.c1, p.c2 * p.c2)), p.c2));
    endPieceAt(q / a);
    endPieceAt(p.c1 / q);
    pressureFrom_ = pressure_.at(from_);
    pressureTo_ = pressure_.at(to_);
    upFrom_ = pressureFrom_ > Wide::all(0);
    upTo_ = (pressureTo_ > Wide::all(0)) | isSet(lanes_.isPressedAtLimit);
  }

  HWY_INLINE void endPieceAt(Wide t) {
    const Wide low = min(from_, to_), high = max(from_, to_);
    to_ = select((t > low) & (t < high), t, to_);
  }

  HWY_INLINE Wide positionAt(Wide t) const { return mulAdd(t, along_, start_); }

  /// Returns the depth of the line below `height` as a polynomial.
  HWY_INLINE WideCubic below(Wide height) const {
    return {height - low_, inside_.c1, inside_.c2, inside_.c3};
  }

  HWY_INLINE void leave(WideMask lanes, Wide t) {
    arcHeight_ = select(lanes, -below(Wide::all(0)).at(t), arcHeight_);
    arcPosition_ = select(lanes, positionAt(t), arcPosition_);
    touching_ = touching_ & !lanes;
  }

  /// Computes at most one edge of contact in each lane: where p vanishes in contact, where the line
  /// reaches the free surface, or, for a free lane, where p vanishes after an interval under
  /// pressure, which is where the line comes nearest to the free surface.
  HWY_INLINE void findEvents() {
    arc_ = {depth_ - arcHeight_, (start_ - arcPosition_) * inverse_, along_ * inverse_};
    const WideGap<WideCubic> rising{below(arcHeight_), arc_};
    const WideMask free = busy_ & !touching_;
    exits_ = touching_ & !upTo_;
    const WideMask bumps = free & upFrom_ & !upTo_, rises = free & upTo_;
    // Where p vanishes, it is already known whether the line reaches the free surface. Without
    // relaxation the two meet there to rounding, so that only points further inside can decide.
    const WideMask reached =
        rises & isSet(lanes_.isPressedAtLimit) & (to_ == Wide::load(lanes_.limit));
    enters_ = WideMask::none();
    hits_ = WideMask::none();
    edge_ = to_;
    Wide lostTo = to_, gapTo = to_;
    if (any(rises)) {
      lostTo = arc_.lostAt(to_);
      gapTo = rising.valueAt(to_, lostTo);
      enters_ = rises & ((gapTo > Wide::all(0)) | reached);
    }
    const WideMask wanted = exits_ | bumps | enters_;
    if (!any(wanted)) return;
    WideGap<WideCubic> gap{select(enters_, rising.polynomial, pressure_), arc_};
    gap.arc.depth = onlyIn(enters_, arc_.depth);
    const Wide low = min(from_, to_), high = max(from_, to_);
    const Wide secant = mulAdd(to_ - from_, pressureFrom_ / (pressureFrom_ - pressureTo_), from_);
    Wide guess = select(enters_, gap.step(to_, gapTo, lostTo), secant);
    guess = select((guess >= low) & (guess <= high) & !reached, guess, times(0.5, low + high));
    // The free surface is above the line at the piece's start, and the pressure there is positive.
    const WideRoot root = rootBetween(gap, low, high, !(enters_ ^ onwards_), guess, wanted);
    edge_ = select(wanted, root.t, to_);
    lost_ = root.lost;
    if (!any(bumps)) return;
    hits_ = bumps & (rising.valueAt(edge_, arc_.lostAt(edge_)) > Wide::all(0));
    if (any(bumps & !hits_)) {
      const Wide middle = times(0.5, from_ + edge_);
      hits_ = hits_ | (bumps & (rising.valueAt(middle, arc_.lostAt(middle)) > Wide::all(0)));
    }
  }

  /// Ends the free arcs of entering lanes at their edges.
  HWY_INLINE void close() {
    sumDepth_ = Wide::load(lanes_.sumDepth);
    freeStiffness_ = Wide::load(lanes_.freeStiffness);
    freeLoss_ = Wide::load(lanes_.freeLoss);
    if (any(enters_)) closeArcs(enters_, lost_);
  }

  HWY_INLINE void closeArcs(WideMask lanes, Wide lost) {
    const Wide forgotten = relaxationLength_ * lost, depth = depth_ - arcHeight_;
    // 1 - e^2 = (1 - e)(1 + e)
    const Wide energy = times(0.5, depth * depth) * (lost * (Wide::all(2) - lost));
    sumDepth_ = sumDepth_ + onlyIn(lanes, depth * forgotten);
    freeStiffness_ = freeStiffness_ + onlyIn(lanes, forgotten);
    freeLoss_ = freeLoss_ + onlyIn(lanes, energy);
    (Wide::load(lanes_.gaps) + onlyIn(lanes, Wide::all(1))).store(lanes_.gaps);
  }

  /// Adds the sums between two positions in this segment, by the polynomial about the lower one.
  HWY_INLINE void addContact() {
    const WideMask lanes = touching_ | enters_;
    const Wide begin = select(enters_, edge_, from_), end = select(exits_, edge_, to_);
    const Wide from = min(begin, end), x = abs(end - begin);
    const Wide span = abs(along_);
    const Wide w = inside_.at(from), c1 = inside_.slopeAt(from);
    const Wide c2 = inside_.halfCurvatureAt(from), c3 = inside_.c3;
    // The integral of w's change is x^2 (c1 / 2 + x (c2 / 3 + x c3 / 4)).
    const Wide change = mulAdd(x, mulAdd(x, times(0.25, c3), times(1.0 / 3, c2)), times(0.5, c1));
    // This is the integral of (c1 + b t + c t^2)^2.
    const Wide b = c2 + c2, c = times(3, c3);
    const Wide t4 = mulAdd(x, times(0.2, c * c), times(0.5, b * c));
    const Wide t3 = mulAdd(x, t4, times(1.0 / 3, mulAdd(b, b, (c1 + c1) * c)));
    const Wide squares = mulAdd(x, mulAdd(x, t3, c1 * b), c1 * c1);
    const Wide climb = mulAdd(x, mulAdd(x, c3, c2), c1);
    const Wide depths = span * x * mulAdd(x, change, w);
    const Wide sinking = relaxationLength_ * x * select(onwards_, climb, -climb);
    const Wide length = Wide::load(lanes_.contactLength), slopes = Wide::load(lanes_.slopeSquared);
    sumDepth_ = sumDepth_ + onlyIn(lanes, depths);
    (length + onlyIn(lanes, x * span)).store(lanes_.contactLength);
    (slopes + onlyIn(lanes, x * squares * abs(perAlong_))).store(lanes_.slopeSquared);
    (Wide::load(lanes_.sumPressure) + onlyIn(lanes, depths + sinking)).store(lanes_.sumPressure);
  }

  HWY_INLINE void finish() {
    touching_ = touching_ | enters_;
    const WideMask finished = busy_ & !hits_ & (to_ == end_), free = finished & !touching_;
    if (any(free)) {
      const Wide over = (positionAt(end_) - arcPosition_) * inverse_;
      const Wide lost = lostAfter(max(over, Wide::all(0)));
      mulAdd(depth_ - arcHeight_, lost, arcHeight_).store(lanes_.surface);
      // The arc ends at a point that is always in contact.
      const WideMask last = free & isSet(lanes_.closes);
      if (any(last)) closeArcs(last, lost);
    }
    sumDepth_.store(lanes_.sumDepth);
    freeStiffness_.store(lanes_.freeStiffness);
    freeLoss_.store(lanes_.freeLoss);
    arcHeight_.store(lanes_.arcHeight);
    arcPosition_.store(lanes_.arcPosition);
    setFlags(touching_, lanes_.touching);
    // Prepare the next segment where this one is finished.
    const Wide next = onlyIn(!finished, select(hits_, from_, to_));
    next.store(lanes_.from);
    select(hits_, edge_, select(finished, Wide::all(1), end_)).store(lanes_.limit);
    setFlags(hits_, lanes_.isPressedAtLimit);
    lanes_.finished = bitsOf(finished);
    lanes_.pressed = bitsOf(touching_);
  }

  Lanes& lanes_;
  Wide depth_, relaxationLength_, inverse_;
  Wide start_, along_, perAlong_, end_;  // end_: t where material leaves the segment
  WideCubic inside_, pressure_;          // w = d - z and p, per 4G
  WideArc arc_;
  Wide low_, arcHeight_, arcPosition_;  // low_: z at t = 0
  Wide from_, to_, pressureFrom_, pressureTo_;
  Wide edge_, lost_;
  Wide sumDepth_, freeStiffness_, freeLoss_;
  WideMask busy_, touching_, onwards_, upFrom_, upTo_, exits_, enters_, hits_;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
