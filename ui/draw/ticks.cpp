#include "ui/draw/ticks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "ui/draw/fonts.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

/// Returns whether a unit can have a prefix. It cannot before a power (km² is not 1000 m²), a
/// kilogram or a unit that is not a letter.
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

/// Returns whether a unit gets a power of ten: where it has no prefix and plain numbers would be
/// long, and outside the range of prefixes.
bool takesPower(double magnitude, std::string_view unit) {
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return false;
  if (!takesPrefix(unit)) return !(magnitude >= 1e-2 && magnitude < 1e5);
  const double shown = magnitude / prefixFor(magnitude).size;
  return shown < 1 - 1e-9 || shown >= 1e3 * (1 + 1e-9);
}

/// Returns the unit of an axis up to `magnitude`, with a prefix where possible.
AxisUnit axisUnit(double magnitude, std::string_view unit) {
  if (!takesPrefix(unit)) return {std::string(unit), 1};
  const UnitPrefix prefix = prefixFor(magnitude);
  return {std::string(prefix.text) + std::string(unit), prefix.size};
}

/// Returns "10⁻⁴" or "10⁶ 1/m", chosen so that the largest tick has one digit before its point.
AxisUnit powerUnit(double largestTick, std::string_view unit) {
  const int power = static_cast<int>(std::floor(std::log10(largestTick) + 1e-9));
  return {powerOfTen(power) + (unit.empty() ? "" : " ") + std::string(unit), std::pow(10.0, power)};
}

double nextMultiple(std::initializer_list<double> factors, double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : factors)
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

constexpr double kRounding = 1e-9;   // of a decade: a tick at the very end belongs to the axis
constexpr double kMaxDecades = 700;  // the range of a double
constexpr int kMaxTicks = 12;

/// Returns the multiples of every decade inside [from, to].
std::vector<Tick> multiples(double from, double to, const std::vector<int>& factors) {
  std::vector<Tick> ticks;
  const int last = static_cast<int>(std::floor(to + kRounding));
  for (int exponent = static_cast<int>(std::floor(from)); exponent <= last; ++exponent)
    for (const int factor : factors) {
      const double decade = exponent + std::log10(factor);
      if (decade < from - kRounding || decade > to + kRounding) continue;
      const std::string power = powerOfTen(exponent);
      ticks.push_back({decade, factor == 1 ? power : std::to_string(factor) + "×" + power});
    }
  return ticks;
}

std::vector<Tick> decades(double from, double to, int most) {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::ceil(from - kRounding));
  const int last = static_cast<int>(std::floor(to + kRounding));
  int step = 1;  // ticks are at its multiples
  const auto count = [&] {
    return std::floor(static_cast<double>(last) / step) -
           std::ceil(static_cast<double>(first) / step) + 1;
  };
  while (count() > most) ++step;
  const int fromFirst = (last - first) / step + 1;
  const bool beginsAtFirst = count() < kFewTicks && fromFirst >= kFewTicks && fromFirst <= most;
  for (int exponent = first; exponent <= last; ++exponent)
    if ((beginsAtFirst ? exponent - first : exponent) % step == 0)
      ticks.push_back({static_cast<double>(exponent), powerOfTen(exponent)});
  return ticks;
}

/// Writes multiples of powers of ten that are neither large nor small as plain numbers: "0.1",
/// "0.2" and "0.5" are read at once, "2×10⁻¹" is not.
std::vector<Tick> withPlainNumbers(std::vector<Tick> ticks) {
  constexpr double kFrom = -2, kTo = 3;  // decimal logarithms; 1000 would have a separator
  const auto isUsual = [](const Tick& tick) {
    return tick.value > kFrom - kRounding && tick.value < kTo - kRounding;
  };
  if (!std::ranges::all_of(ticks, isUsual)) return ticks;
  for (Tick& tick : ticks) {
    const int decimals = -static_cast<int>(std::floor(tick.value + kRounding));
    tick.label =
        readingInLanguage(printedDecimals(std::pow(10.0, tick.value), std::max(decimals, 0)));
  }
  return ticks;
}

int tickCount(float pixels, float each) {
  return std::clamp(static_cast<int>(pixels / each), 2, kMaxTicks);
}

}  // namespace

float widestLabel(const std::vector<Tick>& ticks, float size) {
  float widest = 0;
  for (const Tick& tick : ticks) widest = std::max(widest, textWidth(tick.label, size));
  return widest;
}

double roundUp125(double value) {
  return nextMultiple({1, 2, 5}, value);
}

double roundUp(double value) {
  return nextMultiple({1, 1.5, 2, 2.5, 3, 4, 5, 6, 8}, value);
}

AxisTicks linearTicks(double from, double to, int most, std::string_view unit) {
  const double magnitude = std::max(std::abs(from), std::abs(to));
  AxisUnit counted = axisUnit(magnitude, unit);
  AxisTicks axis{{}, counted.text, counted.size};
  if (!(from < to) || !std::isfinite(to - from) || most < 1) return axis;
  double step = roundUp125((to - from) / most);
  // Steps of 1, 2 and 5 may give one tick more than requested.
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
        {k * step, readingInLanguage(printedDecimals(k * (step / counted.size), decimals))});
  return axis;
}

std::vector<double> minorTicks(const AxisTicks& axis, double from, double to) {
  std::vector<double> minor;
  if (axis.ticks.size() < 2) return minor;
  const double step = axis.ticks[1].value - axis.ticks[0].value;
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const auto isStep = [mantissa](double round) { return std::abs(mantissa - round) < 0.1; };
  if (!isStep(1) && !isStep(2) && !isStep(5)) return minor;
  const int parts = isStep(2) ? 4 : 5;
  const double part = step / parts, slack = 1e-9 * step;
  const auto below = static_cast<int>((axis.ticks.front().value - from + slack) / part);
  const auto above = static_cast<int>((to - axis.ticks.front().value + slack) / part);
  for (int k = -below; k <= above; ++k)
    if (k % parts != 0) minor.push_back(axis.ticks.front().value + k * part);
  return minor;
}

void keepOutermost(std::vector<Tick>& ticks) {
  if (ticks.size() > 2) ticks.erase(ticks.begin() + 1, ticks.end() - 1);
}

AxisTicks sparseTicks(double from, double to, float pixels, float size, std::string_view unit) {
  const auto isSparse = [&](const AxisTicks& axis) {
    const double share = (axis.ticks[1].value - axis.ticks[0].value) / (to - from);
    return widestLabel(axis.ticks, size) + size < share * pixels;
  };
  const int usual = tickCount(pixels, size * 4);
  AxisTicks few;
  for (int most = usual; most > 1; --most) {
    few = linearTicks(from, to, most, unit);
    if (few.ticks.size() < 2 || isSparse(few)) break;
  }
  if (std::ssize(few.ticks) >= kFewTicks) return few;
  for (int most = usual + 1; most <= kMaxTicks; ++most)
    if (AxisTicks closer = linearTicks(from, to, most, unit);
        std::ssize(closer.ticks) >= kFewTicks && isSparse(closer))
      return closer;
  if (few.ticks.size() > 1 && isSparse(few)) return few;
  // One tick gives no scale: with steps of 1, 2 and 5 more of them may fit, or the outermost two.
  AxisTicks single;
  for (int most = 1; most <= kMaxTicks; ++most) {
    AxisTicks axis = linearTicks(from, to, most, unit);
    if (single.ticks.empty()) single = axis;
    if (axis.ticks.size() < 2) continue;
    if (isSparse(axis)) return axis;
    keepOutermost(axis.ticks);
    if (isSparse(axis)) return axis;
  }
  if (single.ticks.size() > 1) single.ticks.resize(1);
  return single;
}

AxisTicks yTicks(double from, double to, float pixels, float each, float size,
                 std::string_view unit) {
  int most = tickCount(pixels, each);
  AxisTicks axis = linearTicks(from, to, most, unit);
  const auto isApart = [&](const AxisTicks& ticks, double letters) {
    const double apart = (ticks.ticks[1].value - ticks.ticks[0].value) / (to - from);
    return apart * static_cast<double>(pixels) >= letters * static_cast<double>(size);
  };
  // With steps of 1, 2 and 5 the next number of ticks is up to five times as large.
  for (int count = most; std::ssize(axis.ticks) < kFewTicks && count <= kMaxTicks; ++count)
    if (AxisTicks closer = linearTicks(from, to, count, unit);
        std::ssize(closer.ticks) >= kFewTicks && isApart(closer, 1.6))
      return closer;
  while (axis.ticks.size() < 2 && most < kMaxTicks) {
    AxisTicks closer = linearTicks(from, to, ++most, unit);
    if (closer.ticks.size() < 2) continue;
    const auto ticksFit = [&] { return isApart(closer, 1.1); };
    // The outermost two give a scale where not all fit; finer steps have them farther apart.
    if (!ticksFit()) keepOutermost(closer.ticks);
    if (ticksFit()) return closer;
  }
  return axis;
}

std::vector<Tick> logTicks(double from, double to, int most) {
  if (!(from < to) || !(std::abs(from) < kMaxDecades) || !(std::abs(to) < kMaxDecades) || most < 1)
    return {};
  std::vector<Tick> ticks = decades(from, to, most);
  if (std::ssize(ticks) >= kFewTicks || most < 2) return ticks;
  // Uses multiples that give a scale and fit, otherwise the outermost of them.
  const std::vector<int> choices[] = {{1, 2, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 3}, {1, 5}};
  for (const int least : {kFewTicks, 2}) {
    if (std::ssize(ticks) >= least) return ticks;
    for (const std::vector<int>& factors : choices) {
      std::vector<Tick> finer = multiples(from, to, factors);
      if (std::ssize(finer) >= least && std::ssize(finer) <= most) return withPlainNumbers(finer);
    }
  }
  const std::vector<Tick> coarse = multiples(from, to, {1, 2, 5});
  if (coarse.size() > 1) return withPlainNumbers({coarse.front(), coarse.back()});
  return ticks;
}

std::vector<double> minorLogTicks(double from, double to, const std::vector<Tick>& ticks,
                                  double decadePixels, double apart) {
  std::vector<double> minor;
  if (!(from < to) || !(std::abs(from) < kMaxDecades) || !(std::abs(to) < kMaxDecades))
    return minor;
  std::vector<int> factors{1};
  if (decadePixels >= 12 * apart)
    factors = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  else if (decadePixels >= 5 * apart)
    factors = {1, 2, 5};
  else if (decadePixels < apart)
    return minor;
  for (const Tick& candidate : multiples(from, to, factors))
    if (std::none_of(ticks.begin(), ticks.end(), [&](const Tick& tick) {
          return std::abs(tick.value - candidate.value) < kRounding;
        }))
      minor.push_back(candidate.value);
  return minor;
}

std::string shortNumber(double value, int digits, Zeros zeros) {
  return readingInLanguage(printedNumber(value, digits, zeros));
}

std::string shortPercent(double part) {
  return std::isfinite(part) ? shortNumber(100 * part) + " %" : shortNumber(part);
}

std::string factorText(double factor) {
  constexpr double kMinGrouped = 1000, kLongest = 1e12;
  const double rounded = roundedToDigits(factor, 3);
  if (!(rounded >= kMinGrouped && rounded < kLongest)) return shortNumber(factor);
  return readingInLanguage(std::to_string(std::llround(rounded)));
}

std::string quantity(double value, std::string_view unit, int digits, Zeros zeros) {
  return readingInLanguage(printedQuantity(value, unit, digits, zeros));
}

std::string numberWithError(double value, double error, Zeros zeros) {
  const bool hasError = std::isfinite(value) && std::isfinite(error) && error > 0;
  if (!hasError) return shortNumber(value, 3, zeros);
  constexpr int kMaxDecimals = 15;
  const double larger = std::max(std::abs(value), error);
  const auto decade = [](double number) {
    return static_cast<int>(std::floor(std::log10(number)));
  };
  const std::string printed = printedNumber(larger);
  const bool isPower =
      printed.find("10\u207B") != std::string::npos || printed.find("\u00D7") != std::string::npos;
  const int power = isPower ? decade(larger) : 0;
  const int last = std::min(decade(error) - 1, decade(larger) - 2) - power;
  const auto text = [&](double number) {
    return readingInLanguage(
        printedDecimals(number / std::pow(10, power), std::clamp(-last, 0, kMaxDecimals)));
  };
  const std::string both = text(value) + " \u00B1 " + text(error);
  return isPower ? "(" + both + ")\u00D7" + powerOfTen(power) : both;
}

QString readingLabel(double value, int digits, Zeros zeros) {
  return QString::fromStdString(shortNumber(value, digits, zeros));
}

}  // namespace asperity
