#include "core/base/number_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

#include "core/base/units.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, 11> kSiPrefixes = {"f", "p", "n", "\u00B5", "m", "",
                                                          "k", "M", "G", "T",      "P"};
constexpr int kSmallestPrefix = -15;             // power of ten of the first prefix
constexpr int kFirstPower = -4, kLastPower = 6;  // plain decimals from 10^-4 to below 10^6

std::string withoutTrailingZeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Returns the power of ten of the first digit after rounding to `digits` digits.
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

/// Returns "2.3×10⁵"; a 1 before the power of ten is left out.
std::string withPower(double value, int power, int digits, Zeros zeros) {
  std::string mantissa = printedDecimals(value / std::pow(10.0, power), digits - 1);
  if (zeros == Zeros::Drop) mantissa = withoutTrailingZeros(std::move(mantissa));
  if (mantissa == "1") return powerOfTen(power);
  if (mantissa == std::string(kMinusSign) + "1") return std::string(kMinusSign) + powerOfTen(power);
  return mantissa + "\u00D7" + powerOfTen(power);
}

bool hasNoLargePrefix(std::string_view unit) {
  return unit == "m" || unit == "s" || unit == "m/s";
}

}  // namespace

std::string powerOfTen(int exponent) {
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaisedDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string printedDecimals(double value, int decimals) {
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, std::max(decimals, 0));
  std::string text(buffer.data(), end.ptr);
  if (text.find_first_of("123456789") == std::string::npos && text[0] == '-') text.erase(0, 1);
  if (text[0] == '-') text.replace(0, 1, kMinusSign);
  return text;
}

Message celsius(double kelvin) {
  return message("{} \u00B0C", PrintedNumber{printedDecimals(kelvin - kZeroCelsius, 1)});
}

UnitPrefix prefixFor(double magnitude) {
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return {"", 1};
  // The logarithm is rounded up a little: 0.001 gives 1 m, whatever the rounding error.
  const int power = static_cast<int>(std::floor((std::log10(magnitude) + 1e-12) / 3));
  const int last = static_cast<int>(kSiPrefixes.size()) - 1;
  const int index = std::clamp(power - kSmallestPrefix / 3, 0, last);
  return {kSiPrefixes[static_cast<std::size_t>(index)],
          std::pow(10.0, kSmallestPrefix + 3 * index)};
}

std::string printedNumber(double value, int digits, Zeros zeros) {
  if (!std::isfinite(value)) return "\u2013";
  if (value == 0) return "0";
  const int power = leadingPower(value, digits);
  if (power >= digits && power < kLastPower) {  // integers are rounded, too
    const double unit = std::pow(10.0, power - digits + 1);
    return printedDecimals(std::round(value / unit) * unit, 0);
  }
  if (power < kFirstPower || power >= kLastPower) return withPower(value, power, digits, zeros);
  std::string text = printedDecimals(value, digits - 1 - power);
  return zeros == Zeros::Drop ? withoutTrailingZeros(std::move(text)) : text;
}

std::string printedPower(double value, int digits) {
  return withPower(value, leadingPower(value, digits), digits, Zeros::Drop);
}

std::string printedQuantity(double value, std::string_view unit, int digits, Zeros zeros) {
  if (!std::isfinite(value)) return "\u2013";
  if (unit.empty()) return printedNumber(value, digits, zeros);
  const double magnitude = std::abs(value) * (1 + 0.5 * std::pow(10.0, -digits));  // 999.9 mm: 1 m
  UnitPrefix prefix = unit == "K" ? UnitPrefix{} : prefixFor(magnitude);
  if (prefix.size > 1 && hasNoLargePrefix(unit)) prefix = {};
  const double shown = magnitude / prefix.size;
  if (value != 0 && (shown < 1 || shown >= 1e6)) prefix = {};  // outside the range of prefixes
  return printedNumber(value / prefix.size, digits, zeros) + " " + std::string(prefix.text) +
         std::string(unit);
}

namespace {

/// Changes "1e-06" and "1e+15" into "1e-6" and "1e15".
std::string withoutPadding(std::string number) {
  const std::size_t e = number.find('e');
  if (e == number.npos) return number;
  if (number[e + 1] == '+') number.erase(e + 1, 1);
  const std::size_t digits = e + (number[e + 1] == '-' ? 2 : 1);
  while (number[digits] == '0' && digits + 1 < number.size()) number.erase(digits, 1);
  return number;
}

}  // namespace

double roundedToDigits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  char text[32];
  // The conversion uses decimal text, so that the result is exactly the number "0.0034", not a
  // neighbour.
  const auto end = std::to_chars(std::begin(text), std::end(text), value,
                                 std::chars_format::scientific, digits - 1);
  double rounded = value;
  std::from_chars(text, end.ptr, rounded);
  return rounded;
}

std::string plainNumber(double value) {
  return withoutPadding(fmt::format("{}", value));
}

std::string csvNumber(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

PrintedNumber plain(double value) {
  return {plainNumber(value)};
}

Message rangeText(double minimum, double maximum, std::string_view unit) {
  const auto end = [](double value) {
    return PrintedNumber{withoutPadding(fmt::format("{:g}", value))};
  };
  if (unit.empty()) return message("{} to {}", end(minimum), end(maximum));
  return message("{} to {} {}", end(minimum), end(maximum), unit);
}

}  // namespace asperity
