#include "core/friction/curve_features.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/statistics.h"

namespace asperity {
namespace {

/// A line is flat if it rises from its first x to its last by less than this part of the largest
/// value.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

/// Returns where values pass `level` between two velocities, by linear interpolation of logarithms;
/// NaN: never.
template <class Value>
double crossing(std::span<const double> velocities, std::size_t from, double level,
                const Value& value) {
  for (std::size_t i = from; i + 1 < velocities.size(); ++i) {
    const double a = std::log(value(i) / level), b = std::log(value(i + 1) / level);
    if (a == 0) return velocities[i];
    if ((a < 0) != (b < 0))
      return velocities[i] * std::pow(velocities[i + 1] / velocities[i], a / (a - b));
  }
  return kNaN;
}

std::size_t highest(std::span<const double> values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

/// The parabola through the highest point and its neighbours, over steps between points.
struct Peak {
  CurveMaximum maximum;
  double bend = 0;  // second difference, below 0; 0 at an end of the curve
  double step = 1;  // ratio of neighbouring x
};

Peak findPeak(std::span<const double> x, std::span<const double> values) {
  const std::size_t top = highest(values);
  if (top == 0 || top + 1 == values.size()) return {{x[top], values[top]}};
  const double bend = values[top - 1] - 2 * values[top] + values[top + 1];
  const double lean = values[top - 1] - values[top + 1];
  const double shift = bend < 0 ? 0.5 * lean / bend : 0;
  const double step = x[top + 1] / x[top];
  return {{x[top] * std::pow(step, shift), values[top] - 0.25 * lean * shift}, bend, step};
}

}  // namespace

LineFit fitLine(std::span<const double> x, std::span<const double> y) {
  const double meanX = mean(x), meanY = mean(y);
  double squaresOfX = 0, products = 0, largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    squaresOfX += (x[i] - meanX) * (x[i] - meanX);
    products += (x[i] - meanX) * (y[i] - meanY);
    largest = std::max(largest, std::abs(y[i]));
  }
  double slope = products / squaresOfX;
  const auto [first, last] = std::ranges::minmax(x);
  if (std::abs(slope * (last - first)) <= kRounding * largest) slope = 0;
  const double intercept = meanY - slope * meanX;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares += std::pow(y[i] - intercept - slope * x[i], 2);
  return {intercept, slope, std::sqrt(squares / static_cast<double>(x.size()))};
}

LineFit fitPower(std::span<const double> x, std::span<const double> y) {
  std::vector<double> logX, logY;
  for (const double value : x) logX.push_back(std::log(value));
  for (const double value : y) logY.push_back(std::log(value));
  return fitLine(logX, logY);
}

CurveMaximum curveMaximum(std::span<const double> x, std::span<const double> values) {
  return findPeak(x, values).maximum;
}

RegionBorders regionBorders(std::span<const double> velocities, std::span<const double> values,
                            const BorderRule& rule) {
  const double perVelocity = values[0] / velocities[0];
  const Peak peak = findPeak(velocities, values);
  const double reached = rule.ofMaximum * peak.maximum.value;
  const std::size_t top = highest(values);
  const auto overLine = [&](std::size_t i) { return values[i] / (perVelocity * velocities[i]); };
  const auto value = [&](std::size_t i) { return values[i]; };
  const double endOfLinear = crossing(velocities, 0, rule.ofLine, overLine);
  if (values[top] < reached) {
    const double steps = std::sqrt(2 * (peak.maximum.value - reached) / -peak.bend);
    const double factor = std::pow(peak.step, steps);
    return {endOfLinear, peak.maximum.x / factor, peak.maximum.x * factor};
  }
  return {endOfLinear, crossing(velocities, 0, reached, value),
          crossing(velocities, top, reached, value)};
}

std::size_t regionNumber(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(kRegionNames, name) - kRegionNames.begin());
}

std::vector<CurveRegion> regionsWithin(const RegionBorders& borders, double from, double to) {
  std::vector<CurveRegion> regions;
  std::size_t number = 0;
  for (const double border : {borders.endOfLinear, borders.toPlateau, borders.offPlateau, to}) {
    if (std::isfinite(border) && border > from) {
      regions.push_back({kRegionNames[number], from, border});
      from = border;
    }
    ++number;
  }
  return regions;
}

}  // namespace asperity
