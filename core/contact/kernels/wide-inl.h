// Numbers for many lanes at once: one vector of the machine, or several side by side, so that the
// machine need not wait for the long dependency chains of one vector. Compiled once per instruction
// set.

#if defined(ASPERITY_WIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_WIDE_INL
#undef ASPERITY_WIDE_INL
#else
#define ASPERITY_WIDE_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<double, 8> kTag;

struct OneMask {
  static constexpr std::size_t kLanes = hn::MaxLanes(kTag);

  hn::Mask<decltype(kTag)> m;

  static HWY_INLINE OneMask none() { return {hn::FirstN(kTag, 0)}; }
};

/// One vector.
struct One {
  using Mask = OneMask;
  static constexpr std::size_t kLanes = hn::MaxLanes(kTag);

  hn::Vec<decltype(kTag)> v;

  static HWY_INLINE One all(double value) { return {hn::Set(kTag, value)}; }
  static HWY_INLINE One load(const double* from) { return {hn::LoadU(kTag, from)}; }
  /// Loads only the first `count` numbers, and 0 after them; nothing else is read.
  static HWY_INLINE One loadFirst(const double* from, std::size_t count) {
    return {hn::MaskedLoad(hn::FirstN(kTag, count), kTag, from)};
  }
  HWY_INLINE void store(double* to) const { hn::StoreU(v, kTag, to); }
};

template <class T>
struct PairMask {
  T a, b;

  static HWY_INLINE PairMask none() { return {T::none(), T::none()}; }
};

/// A pair with twice as many lanes.
template <class T>
struct Pair {
  using Mask = PairMask<typename T::Mask>;
  static constexpr std::size_t kLanes = 2 * T::kLanes;

  T a, b;

  static HWY_INLINE Pair all(double value) { return {T::all(value), T::all(value)}; }
  static HWY_INLINE Pair load(const double* from) {
    return {T::load(from), T::load(from + T::kLanes)};
  }
  HWY_INLINE void store(double* to) const { a.store(to), b.store(to + T::kLanes); }
};

// clang-format off
HWY_INLINE One operator+(One x, One y) { return {hn::Add(x.v, y.v)}; }
HWY_INLINE One operator-(One x, One y) { return {hn::Sub(x.v, y.v)}; }
HWY_INLINE One operator*(One x, One y) { return {hn::Mul(x.v, y.v)}; }
HWY_INLINE One operator/(One x, One y) { return {hn::Div(x.v, y.v)}; }
HWY_INLINE One operator-(One x) { return {hn::Neg(x.v)}; }
HWY_INLINE One mulAdd(One x, One y, One z) { return {hn::MulAdd(x.v, y.v, z.v)}; }
HWY_INLINE One mulSub(One x, One y, One z) { return {hn::MulSub(x.v, y.v, z.v)}; }
HWY_INLINE One negMulAdd(One x, One y, One z) { return {hn::NegMulAdd(x.v, y.v, z.v)}; }
HWY_INLINE One min(One x, One y) { return {hn::Min(x.v, y.v)}; }
HWY_INLINE One max(One x, One y) { return {hn::Max(x.v, y.v)}; }
HWY_INLINE One abs(One x) { return {hn::Abs(x.v)}; }
HWY_INLINE One sqrt(One x) { return {hn::Sqrt(x.v)}; }
HWY_INLINE One copySign(One x, One sign) { return {hn::CopySign(x.v, sign.v)}; }
HWY_INLINE One select(OneMask m, One x, One y) { return {hn::IfThenElse(m.m, x.v, y.v)}; }
HWY_INLINE One onlyIn(OneMask m, One x) { return {hn::IfThenElseZero(m.m, x.v)}; }
HWY_INLINE OneMask operator<(One x, One y) { return {hn::Lt(x.v, y.v)}; }
HWY_INLINE OneMask operator>(One x, One y) { return {hn::Gt(x.v, y.v)}; }
HWY_INLINE OneMask operator<=(One x, One y) { return {hn::Le(x.v, y.v)}; }
HWY_INLINE OneMask operator>=(One x, One y) { return {hn::Ge(x.v, y.v)}; }
HWY_INLINE OneMask operator==(One x, One y) { return {hn::Eq(x.v, y.v)}; }
HWY_INLINE OneMask operator&(OneMask x, OneMask y) { return {hn::And(x.m, y.m)}; }
HWY_INLINE OneMask operator|(OneMask x, OneMask y) { return {hn::Or(x.m, y.m)}; }
HWY_INLINE OneMask operator^(OneMask x, OneMask y) { return {hn::Xor(x.m, y.m)}; }
HWY_INLINE OneMask operator!(OneMask x) { return {hn::Not(x.m)}; }
HWY_INLINE bool any(OneMask x) { return !hn::AllFalse(kTag, x.m); }
HWY_INLINE unsigned bitsOf(OneMask x) { std::uint8_t bits[8] = {}; hn::StoreMaskBits(kTag, x.m, bits); return bits[0]; }
// clang-format on

/// Returns 1 - exp(-x) to two units in the last place; x is limited to -350 to 350. It takes half
/// the time of the library's function, whose steps depend on each other; edges of contact wait for
/// this result.
HWY_INLINE One lostAfter(One x) {
  constexpr double kWhole = 6755399441055744.0;  // adding it removes the fraction of a number
  x = max(min(x, One::all(350)), One::all(-350));
  // -x = n ln 2 + r
  const One moved = negMulAdd(x, One::all(1.4426950408889634), One::all(kWhole));
  const One n = moved - One::all(kWhole);
  const One r = negMulAdd(n, One::all(2.3190468138462996e-17),
                          negMulAdd(n, One::all(0.6931471805599453), -x));
  // This is the series of exp(r) - 1 in Estrin's order.
  const auto pair = [r](double a, double b) { return mulAdd(r, One::all(1 / b), One::all(1 / a)); };
  const One r2 = r * r, r4 = r2 * r2;
  const One low = mulAdd(r2, pair(24, 120), pair(2, 6));
  const One middle = mulAdd(r2, pair(40320, 362880), pair(720, 5040));
  const One high = mulAdd(r2, pair(479001600, 6227020800), pair(3628800, 39916800));
  const One grown = mulAdd(r2, mulAdd(r4, mulAdd(r4, high, middle), low), r);
  // 2^n: n is in the lowest bits of `moved`.
  const hn::RebindToUnsigned<decltype(kTag)> bits;
  const auto power = hn::ShiftLeft<52>(hn::BitCast(bits, moved.v));
  const One two = {hn::BitCast(kTag, hn::Add(power, hn::Set(bits, 0x3FF0000000000000ULL)))};
  return negMulAdd(two, grown, One::all(1) - two);
}

// clang-format off
#define ASPERITY_PAIR template <class T> HWY_INLINE
ASPERITY_PAIR Pair<T> operator+(Pair<T> x, Pair<T> y) { return {x.a + y.a, x.b + y.b}; }
ASPERITY_PAIR Pair<T> operator-(Pair<T> x, Pair<T> y) { return {x.a - y.a, x.b - y.b}; }
ASPERITY_PAIR Pair<T> operator*(Pair<T> x, Pair<T> y) { return {x.a * y.a, x.b * y.b}; }
ASPERITY_PAIR Pair<T> operator/(Pair<T> x, Pair<T> y) { return {x.a / y.a, x.b / y.b}; }
ASPERITY_PAIR Pair<T> operator-(Pair<T> x) { return {-x.a, -x.b}; }
ASPERITY_PAIR Pair<T> mulAdd(Pair<T> x, Pair<T> y, Pair<T> z) { return {mulAdd(x.a, y.a, z.a), mulAdd(x.b, y.b, z.b)}; }
ASPERITY_PAIR Pair<T> mulSub(Pair<T> x, Pair<T> y, Pair<T> z) { return {mulSub(x.a, y.a, z.a), mulSub(x.b, y.b, z.b)}; }
ASPERITY_PAIR Pair<T> negMulAdd(Pair<T> x, Pair<T> y, Pair<T> z) { return {negMulAdd(x.a, y.a, z.a), negMulAdd(x.b, y.b, z.b)}; }
ASPERITY_PAIR Pair<T> min(Pair<T> x, Pair<T> y) { return {min(x.a, y.a), min(x.b, y.b)}; }
ASPERITY_PAIR Pair<T> max(Pair<T> x, Pair<T> y) { return {max(x.a, y.a), max(x.b, y.b)}; }
ASPERITY_PAIR Pair<T> abs(Pair<T> x) { return {abs(x.a), abs(x.b)}; }
ASPERITY_PAIR Pair<T> sqrt(Pair<T> x) { return {sqrt(x.a), sqrt(x.b)}; }
ASPERITY_PAIR Pair<T> copySign(Pair<T> x, Pair<T> sign) { return {copySign(x.a, sign.a), copySign(x.b, sign.b)}; }
ASPERITY_PAIR Pair<T> lostAfter(Pair<T> x) { return {lostAfter(x.a), lostAfter(x.b)}; }
ASPERITY_PAIR Pair<T> select(typename Pair<T>::Mask m, Pair<T> x, Pair<T> y) { return {select(m.a, x.a, y.a), select(m.b, x.b, y.b)}; }
ASPERITY_PAIR Pair<T> onlyIn(typename Pair<T>::Mask m, Pair<T> x) { return {onlyIn(m.a, x.a), onlyIn(m.b, x.b)}; }
ASPERITY_PAIR typename Pair<T>::Mask operator<(Pair<T> x, Pair<T> y) { return {x.a < y.a, x.b < y.b}; }
ASPERITY_PAIR typename Pair<T>::Mask operator>(Pair<T> x, Pair<T> y) { return {x.a > y.a, x.b > y.b}; }
ASPERITY_PAIR typename Pair<T>::Mask operator<=(Pair<T> x, Pair<T> y) { return {x.a <= y.a, x.b <= y.b}; }
ASPERITY_PAIR typename Pair<T>::Mask operator>=(Pair<T> x, Pair<T> y) { return {x.a >= y.a, x.b >= y.b}; }
ASPERITY_PAIR typename Pair<T>::Mask operator==(Pair<T> x, Pair<T> y) { return {x.a == y.a, x.b == y.b}; }
ASPERITY_PAIR PairMask<T> operator&(PairMask<T> x, PairMask<T> y) { return {x.a & y.a, x.b & y.b}; }
ASPERITY_PAIR PairMask<T> operator|(PairMask<T> x, PairMask<T> y) { return {x.a | y.a, x.b | y.b}; }
ASPERITY_PAIR PairMask<T> operator^(PairMask<T> x, PairMask<T> y) { return {x.a ^ y.a, x.b ^ y.b}; }
ASPERITY_PAIR PairMask<T> operator!(PairMask<T> x) { return {!x.a, !x.b}; }
ASPERITY_PAIR bool any(PairMask<T> x) { return any(x.a) || any(x.b); }
ASPERITY_PAIR unsigned bitsOf(PairMask<T> x) { return bitsOf(x.a) | bitsOf(x.b) << T::kLanes; }
#undef ASPERITY_PAIR
// clang-format on

// Two interleaved vectors are 1.2 to 1.5 times as fast as one if lanes are full; single numbers
// gain nothing.
#if HWY_TARGET == HWY_SCALAR
using Wide = One;
#else
using Wide = Pair<One>;
#endif
using WideMask = Wide::Mask;

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
