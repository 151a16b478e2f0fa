// Cubic polynomials on [0, 1], including Hermite's, Lagrange's polynomial, and the bracketed roots
// that the contact kernels need. Pure functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity {

/// The polynomial c0 + c1 t + c2 t^2 + c3 t^3.
struct Cubic {
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0;

  double operator()(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  double derivative(double t) const { return c1 + t * (2 * c2 + t * 3 * c3); }

  /// Returns the same polynomial in t - origin: differences over short pieces then do not cancel.
  Cubic about(double origin) const {
    return {(*this)(origin), derivative(origin), c2 + 3 * c3 * origin, c3};
  }
  /// Returns the integral from 0 to t.
  double integral(double t) const { return t * (c0 + t * (c1 / 2 + t * (c2 / 3 + t * c3 / 4))); }
  /// Returns the integral of the derivative squared from 0 to t.
  double integralOfSlopeSquared(double t) const {
    const double b = 2 * c2, c = 3 * c3;
    return t * (c1 * c1 + t * (c1 * b + t * ((b * b + 2 * c1 * c) * (1.0 / 3) +
                                             t * (b * c * 0.5 + t * c * c * 0.2))));
  }
};

/// Returns Hermite's cubic over t in [0, 1]: from value0 to value1 with these end slopes d/dt.
inline Cubic hermiteCubic(double value0, double value1, double slope0, double slope1) {
  const double step = value1 - value0;
  return {value0, slope0, 3 * step - 2 * slope0 - slope1, slope0 + slope1 - 2 * step};
}

/// Returns the rise of Hermite's cubic at t above its first value; `step` is its rise over the
/// whole interval, and the end slopes are per unit of the interval.
inline double hermiteRise(double t, double step, double interval, double slope0, double slope1) {
  return t * t * (3 - 2 * t) * step + interval * t * (1 - t) * ((1 - t) * slope0 - t * slope1);
}

/// The same as weights of the two end values and end slopes, for many cubics at one t.
struct HermiteWeights {
  double value0, value1, slope0, slope1;
};
inline HermiteWeights hermiteWeights(double t, double interval) {
  const double second = t * t * (3 - 2 * t);
  return {1 - second, second, interval * t * (1 - t) * (1 - t), -interval * t * t * (1 - t)};
}
/// Weights of the cubic's own slope: of the mean slope over the interval and of the end slopes.
struct HermiteSlopeWeights {
  double mean, slope0, slope1;
};
inline HermiteSlopeWeights hermiteSlopeWeights(double t) {
  return {6 * t * (1 - t), (1 - t) * (1 - 3 * t), t * (3 * t - 2)};
}

/// Returns the value at a place of Lagrange's polynomial through points of different x.
inline double lagrangePolynomial(std::span<const double> x, std::span<const double> y, double at) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double term = y[i];
    for (std::size_t k = 0; k < x.size(); ++k)
      if (k != i) term *= (at - x[k]) / (x[i] - x[k]);
    sum += term;
  }
  return sum;
}

/// A vector of at most `Capacity` numbers, here in ascending order, without allocation.
template <int Capacity>
struct StaticVector {
  std::array<double, Capacity> values{};
  int count = 0;
  void add(double value) { values[static_cast<std::size_t>(count++)] = value; }
  const double* begin() const { return values.data(); }
  const double* end() const { return values.data() + count; }
};

/// Returns the zeros of the derivative of `cubic` inside (0, 1), ascending.
inline StaticVector<2> stationaryPoints(const Cubic& cubic) {
  const double a = 3 * cubic.c3, b = cubic.c2, c = cubic.c1;  // a t^2 + 2 b t + c
  StaticVector<2> points;
  const auto addInside = [&points](double t) {
    if (t > 0 && t < 1) points.add(t);
  };
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return points;
  // The sum without cancellation gives one zero by division by a; their product gives the other.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double first = a != 0 ? q / a : 2.0, second = q != 0 ? c / q : 2.0;
  addInside(std::min(first, second));
  if (first != second) addInside(std::max(first, second));
  return points;
}

/// Returns the zero of a function between `low` and `high`, where its values have different signs:
/// by Newton's method where that stays inside and converges fast enough, else by bisection.
/// `value(t, &derivative)`.
template <class Function>
double zeroBetween(double low, double high, double valueLow, const Function& value) {
  const bool rising = valueLow < 0;
  double t = 0.5 * (low + high), derivative = 0, lastStep = high - low;
  for (int i = 0; i < 200; ++i) {
    const double f = value(t, derivative);
    if (f == 0) return t;
    (((f < 0) == rising) ? low : high) = t;
    double next = derivative != 0 ? t - f / derivative : low;
    const bool inside = next > low && next < high;
    if (!inside || std::abs(next - t) > 0.5 * std::abs(lastStep)) next = 0.5 * (low + high);
    if (next == t || next == low || next == high) return next;
    lastStep = next - t;
    t = next;
    if (std::abs(lastStep) <= 2e-16 * std::abs(t)) return t;
  }
  return t;
}

/// A value and its derivative.
struct ValueAndSlope {
  double value, slope;
};

/// Returned by firstZero() where there is no zero; beyond [0, 1].
inline constexpr double kNoZero = 2;

/// Returns the first place of [0, 1] from `from` towards `to`, which may lie below it, where a
/// smooth function that begins at or above 0 ends to be positive, or kNoZero. `function(t)` returns
/// a ValueAndSlope. `zeroIn(from, first, to, last)` finds the zero where there is only one. The
/// interval is halved until the Bezier ordinates of Hermite's cubic through its ends are positive,
/// so that the cubic is, or fall, so that it has one zero.
template <class Function, class ZeroIn>
double firstZero(double from, ValueAndSlope first, double to, ValueAndSlope last,
                 const Function& function, const ZeroIn& zeroIn) {
  constexpr double kShortest = 1e-9;
  // Only a function that is 0 to rounding over a whole interval needs more; it counts as positive.
  constexpr int kMaxHalvings = 200;
  struct End {
    double at;
    ValueAndSlope value;
  };
  std::array<End, 32> ends;  // of the intervals from `from` on, the nearest last
  std::size_t count = 0;
  ends[count++] = {to, last};
  for (int halvings = 0; count > 0;) {
    const End& end = ends[count - 1];
    const double width = end.at - from, third = width / 3;
    const double next = first.value + third * first.slope;
    const double previous = end.value.value - third * end.value.slope;
    if (std::isnan(next + previous)) return kNoZero;  // halving would not end before the limit
    const bool isPositive = next > 0 && previous > 0 && end.value.value > 0;
    const bool falls = first.value >= next && next >= previous && previous >= end.value.value;
    const bool isShort = std::abs(width) <= kShortest || halvings == kMaxHalvings;
    if (end.value.value <= 0 && (falls || isShort)) return zeroIn(from, first, end.at, end.value);
    if (isPositive || isShort) {
      from = end.at;
      first = end.value;
      --count;
    } else {
      const double middle = from + 0.5 * width;
      ends[count++] = {middle, function(middle)};
      ++halvings;
    }
  }
  return kNoZero;
}

/// Returns the zeros of `cubic` inside (0, 1), ascending; a double zero may be left out.
inline StaticVector<3> zerosInside(const Cubic& cubic) {
  StaticVector<3> zeros;
  double from = 0, valueFrom = cubic.c0;
  const auto search = [&](double to) {
    const double valueTo = cubic(to);
    if ((valueFrom < 0) != (valueTo < 0))
      zeros.add(zeroBetween(from, to, valueFrom, [&cubic](double t, double& derivative) {
        derivative = cubic.derivative(t);
        return cubic(t);
      }));
    from = to;
    valueFrom = valueTo;
  };
  for (const double point : stationaryPoints(cubic)) search(point);
  search(1);
  return zeros;
}

}  // namespace asperity
