#include "ui/picture/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>

#include "ui/language/language.h"
#include "ui/picture/log_ticks.h"

namespace asperity {
namespace {

constexpr std::string_view kMinus = "\u2212";
constexpr std::array<std::string_view, 11> kPrefixes = {"f", "p", "n", "\u00B5", "m", "",
                                                        "k", "M", "G", "T",      "P"};
constexpr int kSmallestPrefix = -15;  // power of ten of the first

struct Prefix {
  std::string_view text;
  double size;
};

/// The prefix that leaves 1 to 999.
Prefix prefixFor(double magnitude) {
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return {"", 1};
  // A little upwards: 0.001 is 1 m, whatever its logarithm rounds to.
  const int power = static_cast<int>(std::floor((std::log10(magnitude) + 1e-12) / 3));
  const int last = static_cast<int>(kPrefixes.size()) - 1;
  const int index = std::clamp(power - kSmallestPrefix / 3, 0, last);
  return {kPrefixes[static_cast<std::size_t>(index)], std::pow(10.0, kSmallestPrefix + 3 * index)};
}

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

/// The unit that an axis up to `magnitude` counts in: with a prefix where it takes one, otherwise a
/// power of ten where plain numbers would be long ("10⁻⁶", "10³ 1/m").
AxisUnit axisUnit(double magnitude, std::string_view unit) {
  if (takesPrefix(unit)) {
    const Prefix prefix = prefixFor(magnitude);
    return {std::string(prefix.text) + std::string(unit), prefix.size};
  }
  if (!(magnitude > 0) || !std::isfinite(magnitude) || (magnitude >= 1e-2 && magnitude < 1e5))
    return {std::string(unit), 1};
  const int power = 3 * static_cast<int>(std::floor((std::log10(magnitude) + 1e-12) / 3));
  return {powerOfTen(power) + (unit.empty() ? "" : " ") + std::string(unit), std::pow(10.0, power)};
}

/// With a point; "-0" is "0"; the minus is a true minus sign.
std::string fixed(double value, int decimals) {
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, std::max(decimals, 0));
  std::string text(buffer.data(), end.ptr);
  if (text.find_first_of("123456789") == std::string::npos && text[0] == '-') text.erase(0, 1);
  if (text[0] == '-') text.replace(0, 1, kMinus);
  return text;
}

std::string withoutTrailingZeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Power of ten of the first digit after rounding to `digits` digits.
int leadingPower(double value, int digits) {
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                 std::chars_format::scientific, digits - 1);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const std::size_t e = text.find('e');
  const std::size_t number = e + (text[e + 1] == '+' ? 2 : 1);
  int power = 0;
  std::from_chars(text.data() + number, text.data() + text.size(), power);
  return power;
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
  const AxisUnit counted = axisUnit(std::max(std::abs(from), std::abs(to)), unit);
  AxisTicks axis{{}, counted.text, counted.size};
  if (!(from < to) || !std::isfinite(to - from) || most < 1) return axis;
  double step = roundUp125((to - from) / most);
  // 1-2-5 steps may place one tick more than asked for.
  const auto count = [&] {
    return std::floor(to / step + 1e-9) - std::ceil(from / step - 1e-9) + 1;
  };
  while (count() > most) step = roundUp125(step * 1.5);
  const double first = std::ceil(from / step - 1e-9);
  if (std::abs(first) > 1e12 || std::abs(to / step) > 1e12) return axis;
  const int decimals = -static_cast<int>(std::floor(std::log10(step / counted.size) + 1e-9));
  for (double k = first; k <= to / step + 1e-9; ++k)
    axis.ticks.push_back({k * step, inLanguage(fixed(k * (step / counted.size), decimals))});
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
  if (!std::isfinite(value)) return "\u2013";
  if (value == 0) return "0";
  const int power = leadingPower(value, digits);
  const auto tidy = [&](const std::string& t) {
    return inLanguage(zeros == Zeros::Drop ? withoutTrailingZeros(t) : t);
  };
  if (power >= digits && power < 6) {  // whole numbers are rounded as well
    const double unit = std::pow(10.0, power - digits + 1);
    return fixed(std::round(value / unit) * unit, 0);
  }
  if (power >= -4 && power < 6) return tidy(fixed(value, digits - 1 - power));
  const double mantissa = value / std::pow(10.0, power);
  return tidy(fixed(mantissa, digits - 1)) + "\u00D7" + powerOfTen(power);
}

std::string quantity(double value, std::string_view unit, int digits, Zeros zeros) {
  if (!std::isfinite(value)) return "\u2013";
  const double rounding = 1 + 0.5 * std::pow(10.0, -digits);  // 999.9 mm is 1 m
  const Prefix prefix = prefixFor(std::abs(value) * rounding);
  return shortNumber(value / prefix.size, digits, zeros) + " " + std::string(prefix.text) +
         std::string(unit);
}

}  // namespace asperity
