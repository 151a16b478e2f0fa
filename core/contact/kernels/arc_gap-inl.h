// The intersection of the line with the free surface inside a segment, in many lanes at once: the
// equation and its root. Compiled once per instruction set.

#if defined(ASPERITY_ARC_GAP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_ARC_GAP_INL
#undef ASPERITY_ARC_GAP_INL
#else
#define ASPERITY_ARC_GAP_INL
#endif

#include "core/contact/kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

constexpr int kMaxRootSteps = 100;
/// The relative size of a root's last step, because a contact may be far shorter than its segment;
/// the remaining error is its cube.
constexpr double kRootStep = 1e-6;

HWY_INLINE Wide times(double factor, Wide x) {
  return Wide::all(factor) * x;
}
/// A free surface that was `depth` deep and has risen by depth (1 - exp(-(offset + rate t))).
/// Heights distinguish line and surface to the last digit even where the depth is far larger, or
/// hardly relaxes over a period.
struct WideArc {
  Wide depth, offset, rate;

  HWY_INLINE Wide lostAt(Wide t) const { return lostAfter(mulAdd(rate, t, offset)); }
};

/// A polynomial and the rise of an arc: one equation for all edges of contact.
template <class Polynomial>
struct WideGap {
  Polynomial polynomial;
  WideArc arc;

  HWY_INLINE Wide valueAt(Wide t, Wide lost) const {
    return mulAdd(arc.depth, lost, polynomial.at(t));
  }

  /// Returns Halley's step from t, where that part of the arc's depth is lost. The step goes far
  /// outside where the root lies beyond a turning point, near which such steps are short.
  HWY_INLINE Wide step(Wide t, Wide value, Wide lost) const {
    const Wide fall = arc.rate * negMulAdd(arc.depth, lost, arc.depth);
    const Wide slope = polynomial.slopeAt(t) + fall;
    const Wide halfCurvature = negMulAdd(times(0.5, arc.rate), fall, polynomial.halfCurvatureAt(t));
    const Wide squared = slope * slope, below = negMulAdd(value, halfCurvature, squared);
    return select(below <= squared + squared, t - value * slope / below, Wide::all(1e9));
  }
};

struct WideRoot {
  Wide t, lost;  // lost: part of the arc's depth
};

/// Halley's method inside [low, high] for the wanted lanes, with bisection where it would leave.
/// The root's `lost` is valid where the arc's depth is above 0.
template <class Gap>
HWY_INLINE WideRoot rootBetween(const Gap& gap, Wide low, Wide high, WideMask negativeAtLow,
                                Wide guess, WideMask wanted) {
  // Steps are limited to a length over which the arc bends little.
  const Wide one = Wide::all(1);
  const Wide reach = select(gap.arc.depth > Wide::all(0), one / abs(gap.arc.rate), one);
  Wide t = guess, further = one, lost = one;
  for (int step = 0; step < kMaxRootSteps; ++step) {
    // The bracket shrinks from the side whose sign agrees.
    lost = gap.arc.lostAt(t);
    const Wide value = gap.valueAt(t, lost);
    const WideMask before = !((value < Wide::all(0)) ^ negativeAtLow);
    low = select(before, t, low);
    high = select(before, high, t);
    // The next step must stay inside.
    const Wide enough = mulAdd(min(t, reach), Wide::all(kRootStep), Wide::all(1e-24));
    Wide next = gap.step(t, value, lost);
    // A step that leaves by less than its own error means that the root is at this end.
    const WideMask inside = (next >= low - enough) & (next <= high + enough);
    next = select(inside, min(max(next, low), high), times(0.5, low + high));
    further = next - t;
    t = next;
    if (!any(wanted & (abs(further) > enough))) break;
  }
  // The last step is short, so two terms of the series of its exponential suffice. But if the
  // surface relaxes at once, all depth is lost, however short the step was.
  const Wide x = min(max(gap.arc.rate * further, -one), one);
  return {t, mulAdd(one - lost, negMulAdd(times(0.5, x), x, x), lost)};
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
