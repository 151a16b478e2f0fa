#include "core/material/temperature_drift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/number_text.h"
#include "core/base/statistics.h"

namespace asperity {
namespace {

/// Returns the drift of a sweep: its temperatures follow a straight line over the logarithm of
/// frequency, which spans more than the tolerance and whose slope is far above its standard error.
std::optional<TemperatureDrift> driftOf(const MeasuredSweep& sweep, double tolerance) {
  constexpr double kClearSlope = 4;  // standard errors
  const std::vector<DynamicModulus>& points = sweep.isotherm.points;
  const auto [coldest, warmest] = std::ranges::minmax(sweep.temperatures);
  if (points.size() < 3 || !(warmest - coldest > tolerance)) return {};
  std::vector<double> xs;
  for (const DynamicModulus& point : points) xs.push_back(std::log10(point.frequency));
  const double x = mean(xs), y = mean(sweep.temperatures);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    xx += (xs[i] - x) * (xs[i] - x);
    xy += (xs[i] - x) * (sweep.temperatures[i] - y);
    yy += (sweep.temperatures[i] - y) * (sweep.temperatures[i] - y);
  }
  const double slope = xy / xx;
  const double residual = std::max(0.0, yy - slope * xy);
  const double error = std::sqrt(residual / (static_cast<double>(xs.size() - 2) * xx));
  const double span = std::abs(slope) * (xs.back() - xs.front());
  if (!(span > tolerance && std::abs(slope) > kClearSlope * error)) return {};
  return TemperatureDrift{coldest, warmest, slope > 0, false};
}

/// One frequency in all sweeps that have it, by rising temperature.
struct AlongTemperature {
  std::vector<double> temperatures;   // K
  std::vector<double> storage, loss;  // natural logarithms
};

AlongTemperature atFrequency(const std::vector<MeasuredSweep>& sweeps, double frequency) {
  AlongTemperature found;
  for (const MeasuredSweep& sweep : sweeps) {
    const std::vector<DynamicModulus>& points = sweep.isotherm.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::abs(points[i].frequency - frequency) > kSameFrequency * frequency) continue;
      found.temperatures.push_back(sweep.temperatures[i]);
      found.storage.push_back(std::log(points[i].storage));
      found.loss.push_back(std::log(points[i].loss));
      break;
    }
  }
  return found;
}

/// Returns the value at x of the polynomial through the two points to each side of x, or through
/// those that there are. xs: rising, and x lies within them.
double alongTemperature(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::ranges::upper_bound(xs, x) - xs.begin();
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, above - 2);
  const std::ptrdiff_t end = std::min<std::ptrdiff_t>(std::ssize(xs), above + 2);
  double sum = 0;
  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
    double weight = 1;
    for (auto j = static_cast<std::size_t>(begin); j < static_cast<std::size_t>(end); ++j)
      if (j != i) weight *= (x - xs[j]) / (xs[i] - xs[j]);
    sum += weight * ys[i];
  }
  return sum;
}

/// Returns the sweep at one temperature; nothing where some frequency would have to be
/// extrapolated.
std::optional<Isotherm> atOneTemperature(const std::vector<MeasuredSweep>& sweeps,
                                         const Isotherm& measured) {
  std::vector<AlongTemperature> curves;
  double lowest = 0, highest = std::numeric_limits<double>::infinity();
  for (const DynamicModulus& point : measured.points) {
    curves.push_back(atFrequency(sweeps, point.frequency));
    lowest = std::max(lowest, curves.back().temperatures.front());
    highest = std::min(highest, curves.back().temperatures.back());
  }
  if (lowest > highest) return {};
  Isotherm isotherm = measured;
  isotherm.temperature = std::clamp(measured.temperature, lowest, highest);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const AlongTemperature& curve = curves[i];
    const auto value = [&](const std::vector<double>& logarithms) {
      return std::exp(alongTemperature(curve.temperatures, logarithms, isotherm.temperature));
    };
    isotherm.points[i].storage = value(curve.storage);
    isotherm.points[i].loss = value(curve.loss);
  }
  isotherm.drift->isRemoved = true;
  return isotherm;
}

}  // namespace

void removeDrift(std::vector<MeasuredSweep>& sweeps, double tolerance) {
  for (MeasuredSweep& sweep : sweeps) sweep.isotherm.drift = driftOf(sweep, tolerance);
  // All are interpolated between sweeps as they were measured.
  std::vector<std::optional<Isotherm>> interpolations;
  for (const MeasuredSweep& sweep : sweeps)
    interpolations.push_back(sweep.isotherm.drift ? atOneTemperature(sweeps, sweep.isotherm)
                                                  : std::nullopt);
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    if (interpolations[i]) sweeps[i].isotherm = std::move(*interpolations[i]);
}

std::vector<Message> describeDrift(const std::vector<Isotherm>& isotherms) {
  std::vector<Message> lines;
  for (const bool isRemoved : {true, false}) {
    const Isotherm* widest = nullptr;
    std::size_t count = 0;
    const auto width = [](const Isotherm& isotherm) {
      return isotherm.drift->to - isotherm.drift->from;
    };
    for (const Isotherm& isotherm : isotherms) {
      if (!isotherm.drift || isotherm.drift->isRemoved != isRemoved) continue;
      ++count;
      if (widest == nullptr || width(isotherm) > width(*widest)) widest = &isotherm;
    }
    if (widest == nullptr) continue;
    const Message direction(widest->drift->isRising ? "rises" : "falls");
    const Message from = celsius(widest->drift->from), to = celsius(widest->drift->to);
    const PrintedNumber span{printedDecimals(width(*widest), 2)};
    lines.push_back(
        isRemoved
            ? message("temperature {} with frequency within {} of {} sweeps, by up to {} K ({} to "
                      "{}, now the isotherm at {}): their moduli are interpolated at each "
                      "frequency between neighbouring sweeps to one temperature",
                      direction, count, isotherms.size(), span, from, to,
                      celsius(widest->temperature))
            : message("temperature {} with frequency within {} of {} sweeps, by up to {} K ({} to "
                      "{}, taken for {}), which distorts their moduli and shifts; wait for a "
                      "steady temperature, or measure the same frequencies at temperatures below "
                      "and above, between which they can be interpolated",
                      direction, count, isotherms.size(), span, from, to,
                      celsius(widest->temperature)));
  }
  return lines;
}

}  // namespace asperity
