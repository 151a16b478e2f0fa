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

/// Returns one frequency of ramps by rising temperature. rows: of this frequency.
AlongTemperature alongRamp(std::vector<MeasuredModulus> rows, double tolerance) {
  std::ranges::stable_sort(rows, {}, &MeasuredModulus::temperature);
  AlongTemperature found;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    double temperature = 0, storage = 0, loss = 0;
    for (; end < rows.size() && rows[end].temperature - rows[begin].temperature <= tolerance;
         ++end) {
      temperature += rows[end].temperature;
      storage += std::log(rows[end].modulus.storage);
      loss += std::log(rows[end].modulus.loss);
    }
    const auto count = static_cast<double>(end - begin);
    found.temperatures.push_back(temperature / count);
    found.storage.push_back(storage / count);
    found.loss.push_back(loss / count);
  }
  return found;
}

/// Returns the widest gap (K) between temperatures that touch a range.
double widestGap(const std::vector<double>& temperatures, double from, double to) {
  double widest = 0;
  for (std::size_t i = 1; i < temperatures.size(); ++i)
    if (temperatures[i] > from && temperatures[i - 1] < to)
      widest = std::max(widest, temperatures[i] - temperatures[i - 1]);
  return widest;
}

constexpr double kNominal = 0.01;  // by which instruments miss a frequency
constexpr double kWidestGap = 6;   // K, between neighbours in a ramp

/// Returns whether rows are at least two isotherms, each of at least two frequencies.
bool areIsotherms(std::vector<MeasuredModulus> rows, double tolerance) {
  std::ranges::stable_sort(rows, {}, &MeasuredModulus::temperature);
  const auto sweeps = sweepsOf(rows, tolerance);
  return sweeps.size() > 1 && std::ranges::all_of(sweeps, [&](const auto& sweep) {
           const auto [lowest, highest] = std::ranges::minmax(
               sweep, {}, [](const MeasuredModulus& row) { return row.modulus.frequency; });
           const double width = sweep.back().temperature - sweep.front().temperature;
           return width <= kWideSweep * tolerance &&
                  highest.modulus.frequency > (1 + kNominal) * lowest.modulus.frequency;
         });
}

}  // namespace

std::size_t leaveOutRamps(std::vector<MeasuredModulus>& rows, double tolerance) {
  constexpr std::ptrdiff_t kMin = 5;
  std::vector<MeasuredModulus> rest;
  for (auto begin = rows.begin(), end = begin; begin != rows.end(); begin = end) {
    const double frequency = begin->modulus.frequency;
    for (++end; end != rows.end() &&
                std::abs(end->modulus.frequency - frequency) <= kNominal * frequency &&
                std::abs(end->temperature - (end - 1)->temperature) <= kWidestGap;)
      ++end;
    const auto [coldest, warmest] =
        std::minmax_element(begin, end, [](const MeasuredModulus& a, const MeasuredModulus& b) {
          return a.temperature < b.temperature;
        });
    const bool isRamp =
        end - begin >= kMin && warmest->temperature - coldest->temperature > kWideSweep * tolerance;
    if (!isRamp) rest.insert(rest.end(), begin, end);
  }
  const std::size_t left = rows.size() - rest.size();
  if (left == 0 || !areIsotherms(rest, tolerance)) return 0;
  rows = std::move(rest);
  return left;
}

std::vector<Isotherm> isothermsOfRamp(const std::vector<MeasuredModulus>& rows, double tolerance) {
  constexpr double kUsualStep = 3;  // K
  constexpr std::size_t kMin = 4;   // temperatures of one frequency
  std::vector<MeasuredModulus> byFrequency = rows;
  std::ranges::stable_sort(byFrequency, {},
                           [](const MeasuredModulus& row) { return row.modulus.frequency; });
  std::vector<double> frequencies;
  std::vector<AlongTemperature> curves;
  double lowest = 0, highest = std::numeric_limits<double>::infinity(), step = kUsualStep;
  for (auto begin = byFrequency.begin(), end = begin; begin != byFrequency.end(); begin = end) {
    const double most = begin->modulus.frequency * (1 + kNominal);
    double logarithms = 0;
    for (; end != byFrequency.end() && end->modulus.frequency <= most; ++end)
      logarithms += std::log(end->modulus.frequency);
    curves.push_back(alongRamp({begin, end}, tolerance));
    const std::vector<double>& temperatures = curves.back().temperatures;
    if (temperatures.size() < kMin) return {};
    frequencies.push_back(std::exp(logarithms / static_cast<double>(end - begin)));
    lowest = std::max(lowest, temperatures.front());
    highest = std::min(highest, temperatures.back());
    step = std::max(step, (temperatures.back() - temperatures.front()) /
                              static_cast<double>(temperatures.size() - 1));
  }
  if (curves.size() < 2 || !(highest - lowest >= step)) return {};
  for (const AlongTemperature& curve : curves)
    if (widestGap(curve.temperatures, lowest, highest) > kWidestGap) return {};
  const double count = std::floor((highest - lowest) / step);
  std::vector<Isotherm> isotherms;
  for (double i = 0; i <= count; ++i) {
    Isotherm isotherm;
    isotherm.isOfRamp = true;
    isotherm.temperature = std::min(lowest + (highest - lowest) * i / count, highest);
    for (std::size_t j = 0; j < curves.size(); ++j) {
      const auto value = [&](const std::vector<double>& logarithms) {
        return std::exp(alongTemperature(curves[j].temperatures, logarithms, isotherm.temperature));
      };
      isotherm.points.push_back({frequencies[j], value(curves[j].storage), value(curves[j].loss)});
    }
    isotherms.push_back(std::move(isotherm));
  }
  return isotherms;
}

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
  if (isotherms.size() > 1 && isotherms.front().isOfRamp)
    lines.push_back(
        message("the temperature rises or falls slowly at each of {} frequencies: their moduli are "
                "interpolated to isotherms {} K apart",
                isotherms.front().points.size(),
                PrintedNumber{
                    printedDecimals(isotherms[1].temperature - isotherms.front().temperature, 2)}));
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
