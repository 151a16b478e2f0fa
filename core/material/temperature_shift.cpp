#include "core/material/temperature_shift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/input_error.h"
#include "core/base/number_text.h"

namespace asperity {
namespace {

PrintedNumber degrees(double kelvin) {
  constexpr int kDigits = 8;
  return plain(roundedToDigits(kelvin, kDigits));
}

double wlfDecades(const TemperatureShift& shift, double temperature) {
  const double above = temperature - shift.referenceTemperature;
  if (above == 0) return 0;
  if (!(above > -shift.c2))
    throw InputError("", "elastomer.temperature",
                     message("{} K is not above {} K, reference_temperature - c2, where the "
                             "shift ends",
                             degrees(temperature), degrees(shift.referenceTemperature - shift.c2)));
  return -shift.c1 * above / (shift.c2 + above);
}

double arrheniusDecades(const TemperatureShift& shift, double temperature) {
  if (temperature == shift.referenceTemperature) return 0;
  return shift.activationEnergy / kGasConstant * std::numbers::log10e *
         (1 / temperature - 1 / shift.referenceTemperature);
}

/// Degrees that were converted to kelvins differ in the last digit.
constexpr double kRounding = 1e-9;  // K

bool isWithinTable(const TemperatureShift& shift, double temperature) {
  return !shift.table.empty() && temperature >= shift.table.front().temperature - kRounding &&
         temperature <= shift.table.back().temperature + kRounding;
}

double tableDecades(const TemperatureShift& shift, double temperature) {
  const std::vector<ShiftPoint>& table = shift.table;
  if (table.empty()) throw InputError("", "elastomer.shift.table", "has no rows");
  if (!isWithinTable(shift, temperature))
    throw InputError(
        "", "elastomer.temperature",
        message("{} K is outside the shift table, {} to {} K", degrees(temperature),
                degrees(table.front().temperature), degrees(table.back().temperature)));
  temperature = std::clamp(temperature, table.front().temperature, table.back().temperature);
  const auto above = std::ranges::lower_bound(table, temperature, {}, &ShiftPoint::temperature);
  if (above->temperature == temperature) return above->log10Shift;
  const ShiftPoint &low = *std::prev(above), &high = *above;
  const double part = (temperature - low.temperature) / (high.temperature - low.temperature);
  return low.log10Shift + part * (high.log10Shift - low.log10Shift);
}

}  // namespace

double log10ShiftFactor(const TemperatureShift& shift, double temperature) {
  const double decades = shift.kind == ShiftKind::Table       ? tableDecades(shift, temperature)
                         : shift.kind == ShiftKind::Arrhenius ? arrheniusDecades(shift, temperature)
                                                              : wlfDecades(shift, temperature);
  if (!(std::abs(decades) <= kMaxDecades))
    throw InputError("", "elastomer.temperature",
                     message("{} K shifts the times by {:.3g} decades; allowed is {}",
                             degrees(temperature), decades, kMaxDecades));
  return decades;
}

double shiftFactor(const TemperatureShift& shift, double temperature) {
  const double decades = log10ShiftFactor(shift, temperature);
  return decades == 0 ? 1 : std::pow(10, decades);
}

bool shiftsTimes(const Elastomer& elastomer) {
  const TemperatureShift& shift = elastomer.shift;
  if (shift.kind != ShiftKind::Table) return elastomer.temperature != shift.referenceTemperature;
  return !isWithinTable(shift, elastomer.temperature) ||
         tableDecades(shift, elastomer.temperature) != 0;
}

double temperatureShift(const Elastomer& elastomer) {
  return elastomer.rheology == Rheology::Elastic
             ? 1
             : shiftFactor(elastomer.shift, elastomer.temperature);
}

double temperatureShift(Elastomer elastomer, double from, double to) {
  elastomer.temperature = to;
  const double there = temperatureShift(elastomer);
  elastomer.temperature = from;
  return temperatureShift(elastomer) / there;
}

// ---- Fits --------------------------------------------------------------------------------------

namespace {

/// A formula with a smaller rms may replace the table: overlaps are hardly more accurate.
constexpr double kGoodFit = 0.05;  // decades

struct LinearFit {
  double factor = 0, rms = 0, offset = 0;
};

/// Fits offset + factor * basis(T) to the rows, with a factor that is not negative, and returns it
/// with the rms of the rows about it.
template <class Basis>
LinearFit bestFactor(std::span<const ShiftPoint> table, bool isOffsetFree, const Basis& basis) {
  double meanValue = 0, meanShift = 0;
  if (isOffsetFree)
    for (const ShiftPoint& row : table) {
      meanValue += basis(row.temperature) / static_cast<double>(table.size());
      meanShift += row.log10Shift / static_cast<double>(table.size());
    }
  double products = 0, squares = 0;
  for (const ShiftPoint& row : table) {
    const double value = basis(row.temperature) - meanValue;
    products += value * (row.log10Shift - meanShift);
    squares += value * value;
  }
  LinearFit fit;
  fit.factor = squares > 0 ? std::max(0.0, products / squares) : 0;
  fit.offset = meanShift - fit.factor * meanValue;
  for (const ShiftPoint& row : table)
    fit.rms += std::pow(row.log10Shift - fit.offset - fit.factor * basis(row.temperature), 2);
  fit.rms = std::sqrt(fit.rms / static_cast<double>(table.size()));
  return fit;
}

}  // namespace

TemperatureFit fitWlf(std::span<const ShiftPoint> table, double referenceTemperature,
                      bool isOffsetFree) {
  TemperatureFit fit;
  fit.shift.kind = ShiftKind::Wlf;
  fit.shift.referenceTemperature = referenceTemperature;
  if (table.size() < 3) return fit;
  const auto fitAt = [&](double c2) {
    return bestFactor(table, isOffsetFree, [&](double temperature) {
      const double above = temperature - referenceTemperature;
      return -above / (c2 + above);
    });
  };
  // The formula is linear in c1; c2 is searched on a grid of its logarithm and then by golden
  // section.
  constexpr double kMin = 1;  // K
  constexpr int kGrid = 400;
  const double coldest = referenceTemperature - table.front().temperature;
  const double from = std::log(std::max(kMin, 1.02 * coldest + 0.1)), to = std::log(kMaxC2);
  const auto gridAt = [&](int i) { return from + (to - from) * i / kGrid; };
  int best = 0;
  for (int i = 1; i <= kGrid; ++i)
    if (fitAt(std::exp(gridAt(i))).rms < fitAt(std::exp(gridAt(best))).rms) best = i;
  double low = gridAt(std::max(0, best - 1)), high = gridAt(std::min(kGrid, best + 1));
  constexpr int kSections = 80;
  for (int i = 0; i < kSections; ++i) {
    const double part = (std::numbers::phi - 1) * (high - low);
    if (fitAt(std::exp(high - part)).rms < fitAt(std::exp(low + part)).rms)
      high = low + part;
    else
      low = high - part;
  }
  fit.shift.c2 = std::min(kMaxC2, std::exp(0.5 * (low + high)));
  const LinearFit linear = fitAt(fit.shift.c2);
  fit.shift.c1 = linear.factor;
  fit.rms = linear.rms;
  fit.offset = linear.offset;
  fit.isDefined = true;
  return fit;
}

TemperatureFit fitArrhenius(std::span<const ShiftPoint> table, double referenceTemperature,
                            bool isOffsetFree) {
  TemperatureFit fit;
  fit.shift.kind = ShiftKind::Arrhenius;
  fit.shift.referenceTemperature = referenceTemperature;
  if (table.size() < 2) return fit;
  const LinearFit linear = bestFactor(table, isOffsetFree, [&](double temperature) {
    return std::numbers::log10e / kGasConstant * (1 / temperature - 1 / referenceTemperature);
  });
  fit.shift.activationEnergy = linear.factor;
  fit.rms = linear.rms;
  fit.offset = linear.offset;
  fit.isDefined = true;
  return fit;
}

namespace {

/// Returns the first formula that is good enough, Wlf or else Arrhenius. A formula with as many
/// constants as there are shifts beside the reference would fit any of them.
std::optional<TemperatureFit> goodFit(std::span<const ShiftPoint> table, double reference,
                                      bool isOffsetFree) {
  const auto isGood = [&](const TemperatureFit& fit, std::size_t constants) {
    return fit.isDefined && fit.rms <= kGoodFit && table.size() > constants + 1;
  };
  const TemperatureFit wlf = fitWlf(table, reference, isOffsetFree);
  if (isGood(wlf, 2) && wlf.shift.c1 <= kMaxC1) return wlf;
  const TemperatureFit arrhenius = fitArrhenius(table, reference, isOffsetFree);
  if (isGood(arrhenius, 1)) return arrhenius;
  return {};
}

}  // namespace

std::optional<TemperatureFit> interpolatingFormula(std::span<const ShiftPoint> table,
                                                   double temperature) {
  return goodFit(table, temperature, true);
}

TemperatureShift tableShift(std::span<const ShiftPoint> table, double referenceTemperature) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.referenceTemperature = referenceTemperature;
  shift.table.assign(table.begin(), table.end());
  const auto above =
      std::ranges::lower_bound(shift.table, referenceTemperature, {}, &ShiftPoint::temperature);
  if (above == shift.table.end()) return shift;
  constexpr double kNoShift = 1e-9;  // decades
  if (above->temperature == referenceTemperature)
    above->log10Shift = 0;
  else if (above != shift.table.begin() &&
           std::abs(tableDecades(shift, referenceTemperature)) > kNoShift)
    shift.table.insert(above, {referenceTemperature, 0});
  return shift;
}

TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature) {
  const auto fit = goodFit(table, referenceTemperature, false);
  return fit ? fit->shift : tableShift(table, referenceTemperature);
}

}  // namespace asperity
