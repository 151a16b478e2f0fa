#include "core/material/temperature_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/material/element_law.h"

namespace asperity {
namespace {

/// The rms of the rows about factor * basis(T), with the best factor that is not below 0.
struct LinearFit {
  double factor = 0, rms = 0;
};

template <class Basis>
LinearFit bestFactor(std::span<const ShiftPoint> table, const Basis& basis) {
  double products = 0, squares = 0;
  for (const ShiftPoint& row : table) {
    const double value = basis(row.temperature);
    products += value * row.log10Shift;
    squares += value * value;
  }
  LinearFit fit;
  fit.factor = squares > 0 ? std::max(0.0, products / squares) : 0;
  for (const ShiftPoint& row : table)
    fit.rms += std::pow(row.log10Shift - fit.factor * basis(row.temperature), 2);
  fit.rms = std::sqrt(fit.rms / static_cast<double>(table.size()));
  return fit;
}

}  // namespace

TemperatureFit fitWlf(std::span<const ShiftPoint> table, double referenceTemperature) {
  TemperatureFit fit;
  fit.shift.kind = ShiftKind::Wlf;
  fit.shift.referenceTemperature = referenceTemperature;
  if (table.size() < 3) return fit;
  const auto fitAt = [&](double c2) {
    return bestFactor(table, [&](double temperature) {
      const double above = temperature - referenceTemperature;
      return -above / (c2 + above);
    });
  };
  // c1 is linear; c2 is sought on a grid of its logarithm and then by the golden section.
  constexpr double kMostC2 = 1e4, kLeastC2 = 1;  // K, the first as the table of parameters has it
  constexpr int kGrid = 400;
  const double coldest = referenceTemperature - table.front().temperature;
  const double from = std::log(std::max(kLeastC2, 1.02 * coldest + 0.1)), to = std::log(kMostC2);
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
  fit.shift.c2 = std::min(kMostC2, std::exp(0.5 * (low + high)));
  const LinearFit linear = fitAt(fit.shift.c2);
  fit.shift.c1 = linear.factor;
  fit.rms = linear.rms;
  fit.isDefined = true;
  return fit;
}

TemperatureFit fitArrhenius(std::span<const ShiftPoint> table, double referenceTemperature) {
  TemperatureFit fit;
  fit.shift.kind = ShiftKind::Arrhenius;
  fit.shift.referenceTemperature = referenceTemperature;
  if (table.size() < 2) return fit;
  const LinearFit linear = bestFactor(table, [&](double temperature) {
    return std::numbers::log10e / kGasConstant * (1 / temperature - 1 / referenceTemperature);
  });
  fit.shift.activationEnergy = linear.factor;
  fit.rms = linear.rms;
  fit.isDefined = true;
  return fit;
}

TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature) {
  // A formula that has as many constants as there are shifts goes through any of them.
  const auto isGood = [&](const TemperatureFit& fit, std::size_t constants) {
    return fit.isDefined && fit.rms <= kGoodShiftFit && table.size() > constants + 1;
  };
  const TemperatureFit wlf = fitWlf(table, referenceTemperature);
  if (isGood(wlf, 2) && wlf.shift.c1 <= 1000) return wlf.shift;
  const TemperatureFit arrhenius = fitArrhenius(table, referenceTemperature);
  if (isGood(arrhenius, 1)) return arrhenius.shift;
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.referenceTemperature = referenceTemperature;
  shift.table.assign(table.begin(), table.end());
  return shift;
}

}  // namespace asperity
