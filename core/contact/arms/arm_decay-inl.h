// This file has the integrals of decay_moments.h for many arms at once: the decay over a distance
// and the driving by the line. It is compiled once per instruction set.

#if defined(ASPERITY_ARM_DECAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_ARM_DECAY_INL
#undef ASPERITY_ARM_DECAY_INL
#else
#define ASPERITY_ARM_DECAY_INL
#endif

#include <array>

#include "core/contact/kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// DrivenDecay of decay_moments.h: e(1) = kept e(0) + sum D_k driven_k.
struct ArmDecay {
  One kept, driven0, driven1, driven2;

  HWY_INLINE One strain(One before, One d0, One d1, One d2) const {
    return mulAdd(kept, before, mulAdd(driven0, d0, mulAdd(driven1, d1, driven2 * d2)));
  }
};

/// Returns the sum over r of (-z)^r k! / (k + r + 1)!, which is the integral of exp(-(1 - u) z) u^k
/// over [0, 1], to rounding for z up to 1/2. The terms are added in pairs, whose steps wait less
/// for each other than those of Horner's rule.
template <int k>
HWY_INLINE One drivenSeries(One z) {
  constexpr std::size_t kTerms = 14;
  constexpr std::array<double, kTerms> kTerm = [] {
    std::array<double, kTerms> term{};
    term[0] = 1.0 / (k + 1);
    for (std::size_t r = 1; r < kTerms; ++r)
      term[r] = term[r - 1] / static_cast<double>(static_cast<std::size_t>(k) + r + 1);
    return term;
  }();
  const One x = -z, x2 = x * x, x4 = x2 * x2;
  const auto pair = [&](std::size_t r) {
    return mulAdd(x, One::all(kTerm[r + 1]), One::all(kTerm[r]));
  };
  const One first = mulAdd(x2, pair(2), pair(0)), second = mulAdd(x2, pair(6), pair(4)),
            third = mulAdd(x2, pair(10), pair(8));
  return mulAdd(x4, mulAdd(x4, mulAdd(x4, pair(12), third), second), first);
}

/// Returns the decay for z >= 0: below 1/2 from the series downwards, above it from the exponential
/// upwards. Lanes of both kinds cost both ways.
HWY_INLINE ArmDecay armDecay(One z) {
  const One one = One::all(1);
  const OneMask isSlow = z < One::all(0.5);
  ArmDecay decay{};
  if (any(isSlow)) {
    decay.driven2 = drivenSeries<2>(z);
    decay.driven1 = One::all(0.5) * negMulAdd(z, decay.driven2, one);
    decay.driven0 = negMulAdd(z, decay.driven1, one);
    decay.kept = negMulAdd(z, decay.driven0, one);
  }
  if (any(!isSlow)) {
    const OneExponential e = exponentialOf(z);
    const One kept = mulAdd(e.two, e.grown, e.two), inverse = one / z;
    const One driven0 = (one - kept) * inverse, driven1 = (one - driven0) * inverse;
    const One driven2 = (one - driven1 - driven1) * inverse;
    decay.kept = select(isSlow, decay.kept, kept);
    decay.driven0 = select(isSlow, decay.driven0, driven0);
    decay.driven1 = select(isSlow, decay.driven1, driven1);
    decay.driven2 = select(isSlow, decay.driven2, driven2);
  }
  return decay;
}

/// The integrals of an arm over a piece in contact, where w' = D_0 + D_1 u + D_2 u^2: those over u
/// in [0, 1] of e and of e w', and z times that of e^2.
struct ArmIntegrals {
  One strain, work, loss;
};

HWY_INLINE ArmIntegrals armIntegrals(One z, One e, double slope0, double slope1, double slope2) {
  constexpr double kSlowBelow = 1.5;
  const One d0 = One::all(slope0), d1 = One::all(slope1), d2 = One::all(slope2);
  const OneMask isSlow = z < One::all(kSlowBelow);
  ArmIntegrals found{One::all(0), One::all(0), One::all(0)};
  // Gauss-Legendre quadrature is used where e hardly decays, because input and stored energy nearly
  // cancel there.
  if (any(isSlow)) {
    constexpr std::size_t kPoints = 8;
    constexpr double kNode[kPoints] = {
        0.019855071751231884, 0.10166676129318664, 0.2372337950418355, 0.40828267875217510,
        0.59171732124782490,  0.7627662049581645,  0.8983332387068134, 0.98014492824876812};
    constexpr double kWeight[kPoints] = {
        0.05061426814518815, 0.11119051722668725, 0.15685332293894365, 0.18134189168918105,
        0.18134189168918105, 0.15685332293894365, 0.11119051722668725, 0.05061426814518815};
    const One limited = min(z, One::all(kSlowBelow));
    for (std::size_t point = 0; point < kPoints; ++point) {
      const double u = kNode[point], u2 = u * u;
      const One strain =
          armDecay(One::all(u) * limited)
              .strain(e, One::all(u * slope0), One::all(u2 * slope1), One::all(u2 * u * slope2));
      const One weighed = One::all(kWeight[point]) * strain;
      found.strain = found.strain + weighed;
      found.work = mulAdd(One::all(slope0 + u * slope1 + u2 * slope2), weighed, found.work);
      found.loss = mulAdd(weighed, strain, found.loss);
    }
    found.loss = z * found.loss;
  }
  // Elsewhere the integrals follow from e' = w' - z e, times 1, u, u^2 and e.
  if (any(!isSlow)) {
    const One after = armDecay(z).strain(e, d0, d1, d2), inverse = One::all(1) / z;
    const auto driven = [&](double k) {
      return One::all(slope0 / k + slope1 / (k + 1) + slope2 / (k + 2));
    };
    const One zeroth = (driven(1) - (after - e)) * inverse;
    const One first = (driven(2) - after + zeroth) * inverse;
    const One second = (driven(3) - after + first + first) * inverse;
    const One work = mulAdd(d0, zeroth, mulAdd(d1, first, d2 * second));
    const One stored = One::all(0.5) * (after - e) * (after + e);
    found.strain = select(isSlow, found.strain, zeroth);
    found.work = select(isSlow, found.work, work);
    found.loss = select(isSlow, found.loss, work - stored);
  }
  return found;
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
