// Numbers with errors, and numbers that are not known; means, medians and quantiles of a few
// numbers, and the distributions of Gauss and Student. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace asperity {

/// A number that is not known, or does not apply.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A number with its standard error; NaN where it is not known.
struct Estimate {
  double value = kNaN;
  double standardError = kNaN;
};

/// Returns the arithmetic mean; NaN of no values.
inline double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the middle value, or the mean of the two middle ones; 0 of no values.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Returns the middle value, or the upper one of the two middle ones, so that the result is one of
/// the values. Needs at least one value.
inline double upperMedian(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Returns the indices of the values in ascending order, those of equal values as they are. No
/// value is NaN.
template <class Values>
std::vector<std::size_t> ascendingOrder(const Values& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&values](std::size_t i) { return values[i]; });
  return order;
}

/// Returns the root mean square; NaN of no values.
inline double rms(std::span<const double> values) {
  if (values.empty()) return kNaN;
  double squares = 0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Returns a quantile of ascending values by linear interpolation between them, as R's type 7. It
/// needs at least one value. part: 0 to 1.
inline double quantile(std::span<const double> ascending, double part) {
  const double rank = part * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return std::lerp(ascending[below], ascending[above], rank - static_cast<double>(below));
}

/// Returns the density of the standard normal distribution.
inline double normalDensity(double x) {
  return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

/// Returns the probability that a standard normal quantity is below x.
inline double normalProbability(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Returns the upper median of ratios of two statements of one quantity where they contradict each
/// other: it differs from 1 by more than a tenth. Nothing otherwise, and of no ratios.
inline std::optional<double> contradictingRatio(std::vector<double> ratios) {
  constexpr double kSame = 0.1;
  if (ratios.empty()) return {};
  const double ratio = upperMedian(std::move(ratios));
  return std::abs(ratio - 1) > kSame ? std::optional(ratio) : std::nullopt;
}

/// Returns the probability that a value deviates by less than t standard errors, which were
/// estimated from residuals with this many degrees of freedom (Student's distribution). For a whole
/// number of them it is a sum of few terms (Abramowitz and Stegun, 26.7.3 and 26.7.4); for any
/// other number it is 1 minus the sum of the terms that follow, which are many for a small t.
/// degreesOfFreedom: above 0; where it is not a whole number, t is 0.1 or more.
inline double studentProbability(double t, double degreesOfFreedom) {
  const double angle = std::atan(t / std::sqrt(degreesOfFreedom));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  if (degreesOfFreedom != std::floor(degreesOfFreedom)) {
    constexpr double kNegligible = 1e-17;
    double term = std::exp(std::lgamma(0.5 * degreesOfFreedom + 0.5) -
                           std::lgamma(0.5 * degreesOfFreedom + 1)) *
                  std::numbers::inv_sqrtpi * sine * std::pow(cosine, degreesOfFreedom);
    double rest = 0;
    for (double k = degreesOfFreedom; term > kNegligible * rest; k += 2) {
      rest += term;
      term *= cosine * cosine * (k + 1) / (k + 2);
    }
    return 1 - rest;
  }
  const bool isOdd = std::fmod(degreesOfFreedom, 2) == 1;
  double sum = 0, term = isOdd ? cosine : 1;
  for (double k = isOdd ? 1 : 0; k <= degreesOfFreedom - 2; k += 2) {
    sum += term;
    term *= cosine * cosine * (k + 1) / (k + 2);
  }
  return isOdd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

/// Returns how many such standard errors are as rare as `deviations` of a known error: 235.8 for 3
/// with one degree of freedom, and toward 3 with many. deviations: 0.1 to 6; degreesOfFreedom:
/// above 0.
inline double studentDeviations(double deviations, double degreesOfFreedom) {
  const double probability = std::erf(deviations / std::numbers::sqrt2);
  double low = deviations, high = 2 * deviations + 1;
  while (studentProbability(high, degreesOfFreedom) < probability) high *= 2;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (studentProbability(middle, degreesOfFreedom) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Returns quantile 0.975 of Student's distribution: a 95 % interval is so many standard errors to
/// each side. Few degrees of freedom have the exact one; from 7 on the expansion for many (26.7.5)
/// is right to 0.03 %. degreesOfFreedom: above 0.
inline double studentQuantile(double degreesOfFreedom) {
  constexpr double kMany = 7;
  constexpr double z = 1.959963984540054;
  if (degreesOfFreedom < kMany) return studentDeviations(z, degreesOfFreedom);
  constexpr double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * degreesOfFreedom) +
         (5 * z5 + 16 * z3 + 3 * z) / (96 * degreesOfFreedom * degreesOfFreedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) /
             (384 * degreesOfFreedom * degreesOfFreedom * degreesOfFreedom);
}

}  // namespace asperity
