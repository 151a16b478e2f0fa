#include "ui/draw/ticks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/language/language.h"

namespace asperity {
namespace {

/// A prefix would be wrong before a power (km² is not 1000 m²), a kilogram or what is no letter.
bool takesPrefix(std::string_view unit) {
  if (unit.empty() || unit.starts_with("kg")) return false;
  const std::string_view first =
      unit.substr(0, std::min(unit.find_first_of("/ "), unit.find("\u00B7")));
  const bool letter = (unit[0] >= 'a' && unit[0] <= 'z') || (unit[0] >= 'A' && unit[0] <= 'Z');
  return letter && first.find("\u00B2") == first.npos && first.find("\u00B3") == first.npos;
}

struct AxisUnit {
  std::string text;
  double size;
};

/// Whether a unit counts in a power of ten: where it takes no prefix and plain numbers would be
/// long, and beyond all prefixes.
bool takesPower(double magnitude, std::string_view unit) {
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return false;
  if (!takesPrefix(unit)) return !(magnitude >= 1e-2 && magnitude < 1e5);
  const double shown = magnitude / prefixFor(magnitude).size;
  return shown < 1 - 1e-9 || shown >= 1e3 * (1 + 1e-9);
}

/// The unit that an axis up to `magnitude` counts in, with a prefix where it takes one.
AxisUnit axisUnit(double magnitude, std::string_view unit) {
  if (!takesPrefix(unit)) return {std::string(unit), 1};
  const UnitPrefix prefix = prefixFor(magnitude);
  return {std::string(prefix.text) + std::string(unit), prefix.size};
}

/// "10⁻⁴", "10⁶ 1/m": so that the largest tick has one digit before its point.
AxisUnit powerUnit(double largestTick, std::string_view unit) {
  const int power = static_cast<int>(std::floor(std::log10(largestTick) + 1e-9));
  return {powerOfTen(power) + (unit.empty() ? "" : " ") + std::string(unit), std::pow(10.0, power)};
}

double nextOf(std::initializer_list<double> factors, double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : factors)
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

}  // namespace

double roundUp125(double value) {
  return nextOf({1, 2, 5}, value);
}

double roundUp(double value) {
  return nextOf({1, 1.5, 2, 2.5, 3, 4, 5, 6, 8}, value);
}

AxisTicks linearTicks(double from, double to, int most, std::string_view unit) {
  const double magnitude = std::max(std::abs(from), std::abs(to));
  AxisUnit counted = axisUnit(magnitude, unit);
  AxisTicks axis{{}, counted.text, counted.size};
  if (!(from < to) || !std::isfinite(to - from) || most < 1) return axis;
  double step = roundUp125((to - from) / most);
  // 1-2-5 steps may place one tick more than asked for.
  const auto count = [&] {
    return std::floor(to / step + 1e-9) - std::ceil(from / step - 1e-9) + 1;
  };
  while (count() > most) step = roundUp125(step * 1.5);
  const double first = std::ceil(from / step - 1e-9);
  const double last = std::floor(to / step + 1e-9);
  if (std::abs(first) > 1e12 || std::abs(last) > 1e12) return axis;
  const double largest = std::max(std::abs(first), std::abs(last)) * step;
  if (first <= last && largest > 0 && takesPower(magnitude, unit)) {
    counted = powerUnit(largest, unit);
    axis.unit = counted.text;
    axis.unitSize = counted.size;
  }
  const int decimals = -static_cast<int>(std::floor(std::log10(step / counted.size) + 1e-9));
  for (double k = first; k <= last; ++k)
    axis.ticks.push_back(
        {k * step, inLanguage(printedDecimals(k * (step / counted.size), decimals))});
  return axis;
}

std::vector<double> minorTicks(const AxisTicks& axis, double from, double to) {
  std::vector<double> minor;
  if (axis.ticks.size() < 2) return minor;
  const double step = axis.ticks[1].value - axis.ticks[0].value;
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const int parts = std::abs(mantissa - 2) < 0.1 ? 4 : 5;
  const double part = step / parts, slack = 1e-9 * step;
  const auto below = static_cast<int>((axis.ticks.front().value - from + slack) / part);
  const auto above = static_cast<int>((to - axis.ticks.front().value + slack) / part);
  for (int k = -below; k <= above; ++k)
    if (k % parts != 0) minor.push_back(axis.ticks.front().value + k * part);
  return minor;
}

std::string shortNumber(double value, int digits, Zeros zeros) {
  return inLanguage(printedNumber(value, digits, zeros));
}

std::string quantity(double value, std::string_view unit, int digits, Zeros zeros) {
  return inLanguage(printedQuantity(value, unit, digits, zeros));
}

}  // namespace asperity
