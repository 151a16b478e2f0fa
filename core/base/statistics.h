// Means and medians of a few numbers, and Student's distribution. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace asperity {

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

/// Returns the probability that a value deviates by less than t standard errors, which were
/// estimated from residuals with this many degrees of freedom (Student's distribution; Abramowitz
/// and Stegun, 26.7.3 and 26.7.4). freedom: at least 1.
inline double studentProbability(double t, int freedom) {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const bool isOdd = freedom % 2 == 1;
  double sum = 0, term = isOdd ? cosine : 1;
  for (int k = isOdd ? 1 : 0; k <= freedom - 2; k += 2) {
    sum += term;
    term *= cosine * cosine * (k + 1.0) / (k + 2.0);
  }
  return isOdd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

/// Returns how many such standard errors are as rare as `deviations` of a known error: 235.8 for 3
/// with one degree of freedom, and toward 3 with many. deviations: 0 to 6.
inline double studentDeviations(double deviations, int freedom) {
  const double probability = std::erf(deviations / std::numbers::sqrt2);
  double low = deviations, high = 2 * deviations + 1;
  while (studentProbability(high, freedom) < probability) high *= 2;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (studentProbability(middle, freedom) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace asperity
