#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// The quantity of an SI unit, and an example of its use in scenes.
struct Dimension {
  std::string_view si;
  const char* words;
  std::string_view example{};
};

constexpr std::array kDimensions{Dimension{"m"sv, "a length", "20 mm"sv},
                                 Dimension{"Pa"sv, "a modulus or pressure", "10 MPa"sv},
                                 Dimension{"N"sv, "a force", "3.4 mN"sv},
                                 Dimension{"m/s"sv, "a velocity", "1 m/s"sv},
                                 Dimension{"s"sv, "a time", "1 ms"sv},
                                 Dimension{"K"sv, "a temperature", "300 K"sv},
                                 Dimension{"Hz"sv, "a frequency", "10 Hz"sv},
                                 Dimension{"N/m"sv, "a force on a length", "100 N/m"sv},
                                 Dimension{"Pa s"sv, "a viscosity", "10 kPa s"sv},
                                 Dimension{"J/mol"sv, "an energy of a mole", "80 kJ/mol"sv},
                                 Dimension{"g"sv, "a mass"},
                                 Dimension{"t"sv, "a mass"},
                                 Dimension{"J"sv, "an energy"},
                                 Dimension{"W"sv, "a power"},
                                 Dimension{"V"sv, "a voltage"},
                                 Dimension{"rad"sv, "an angle"},
                                 Dimension{"m\u00B2"sv, "an area"},
                                 Dimension{"1/m"sv, "a wave number"}};

struct Prefix {
  std::string_view letter;
  int exponent;
};

/// There are two letters for mu: the micro sign and the Greek one.
constexpr std::array kPrefixes{
    Prefix{""sv, 0},   Prefix{"f"sv, -15},     Prefix{"p"sv, -12},     Prefix{"n"sv, -9},
    Prefix{"u"sv, -6}, Prefix{"\u00B5"sv, -6}, Prefix{"\u03BC"sv, -6}, Prefix{"m"sv, -3},
    Prefix{"c"sv, -2}, Prefix{"d"sv, -1},      Prefix{"h"sv, 2},       Prefix{"k"sv, 3},
    Prefix{"M"sv, 6},  Prefix{"G"sv, 9},       Prefix{"T"sv, 12},      Prefix{"P"sv, 15}};

/// Units that are not an SI unit with a prefix. Names of three letters and more are found in any
/// case.
struct OtherUnit {
  std::string_view name;
  Unit unit;
};

constexpr double kPoundForce = 4.4482216152605;  // N
constexpr double kDegree = std::numbers::pi / 180;

constexpr std::array kOthers{
    OtherUnit{"%"sv, {"", -2}},
    OtherUnit{"\u00B0C"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"\u00BAC"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"\u2103"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"degC"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"C"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"celsius"sv, {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"\u00B0F"sv, {"K", 0, 5.0 / 9, 459.67}},
    OtherUnit{"degF"sv, {"K", 0, 5.0 / 9, 459.67}},
    OtherUnit{"F"sv, {"K", 0, 5.0 / 9, 459.67}},
    OtherUnit{"fahrenheit"sv, {"K", 0, 5.0 / 9, 459.67}},
    OtherUnit{"kelvin"sv, {"K"}},
    OtherUnit{"micron"sv, {"m", -6}},
    OtherUnit{"microns"sv, {"m", -6}},
    OtherUnit{"\u00C5"sv, {"m", -10}},
    OtherUnit{"in"sv, {"m", 0, 0.0254}},
    OtherUnit{"inch"sv, {"m", 0, 0.0254}},
    OtherUnit{"mil"sv, {"m", 0, 2.54e-5}},
    OtherUnit{"ft"sv, {"m", 0, 0.3048}},
    OtherUnit{"sec"sv, {"s"}},
    OtherUnit{"min"sv, {"s", 0, 60}},
    OtherUnit{"h"sv, {"s", 0, 3600}},
    OtherUnit{"km/h"sv, {"m/s", 0, 1 / 3.6}},
    OtherUnit{"kmh"sv, {"m/s", 0, 1 / 3.6}},
    OtherUnit{"kph"sv, {"m/s", 0, 1 / 3.6}},
    OtherUnit{"mph"sv, {"m/s", 0, 0.44704}},
    OtherUnit{"in/s"sv, {"m/s", 0, 0.0254}},
    OtherUnit{"ft/s"sv, {"m/s", 0, 0.3048}},
    OtherUnit{"m/min"sv, {"m/s", 0, 1.0 / 60}},
    OtherUnit{"mm/min"sv, {"m/s", -3, 1.0 / 60}},
    OtherUnit{"1/s"sv, {"Hz"}},
    OtherUnit{"s-1"sv, {"Hz"}},
    OtherUnit{"hertz"sv, {"Hz"}},
    OtherUnit{"cps"sv, {"Hz"}},
    OtherUnit{"rpm"sv, {"Hz", 0, 1.0 / 60}},
    OtherUnit{"kgf"sv, {"N", 0, 9.80665}},
    OtherUnit{"kp"sv, {"N", 0, 9.80665}},
    OtherUnit{"gf"sv, {"N", -3, 9.80665}},
    OtherUnit{"lbf"sv, {"N", 0, kPoundForce}},
    OtherUnit{"N/m2"sv, {"Pa"}},
    OtherUnit{"N/mm2"sv, {"Pa", 6}},
    OtherUnit{"N/cm2"sv, {"Pa", 4}},
    OtherUnit{"kN/m2"sv, {"Pa", 3}},
    OtherUnit{"MN/m2"sv, {"Pa", 6}},
    OtherUnit{"kgf/cm2"sv, {"Pa", 0, 98066.5}},
    OtherUnit{"kg/cm2"sv, {"Pa", 0, 98066.5}},
    OtherUnit{"kp/cm2"sv, {"Pa", 0, 98066.5}},
    OtherUnit{"dyn/cm2"sv, {"Pa", -1}},
    OtherUnit{"dyne/cm2"sv, {"Pa", -1}},
    OtherUnit{"dynes/cm2"sv, {"Pa", -1}},
    OtherUnit{"Torr"sv, {"Pa", 0, 101325.0 / 760}},
    OtherUnit{"pascal"sv, {"Pa"}},
    OtherUnit{"kilopascal"sv, {"Pa", 3}},
    OtherUnit{"megapascal"sv, {"Pa", 6}},
    OtherUnit{"gigapascal"sv, {"Pa", 9}},
    OtherUnit{"bar"sv, {"Pa", 5}},
    OtherUnit{"mbar"sv, {"Pa", 2}},
    OtherUnit{"atm"sv, {"Pa", 0, 101325}},
    OtherUnit{"psi"sv, {"Pa", 0, 6894.757293168361}},
    OtherUnit{"ksi"sv, {"Pa", 3, 6894.757293168361}},
    OtherUnit{"N/mm"sv, {"N/m", 3}},
    OtherUnit{"P"sv, {"Pa s", -1}},
    OtherUnit{"cP"sv, {"Pa s", -3}},
    OtherUnit{"m2"sv, {"m\u00B2"}},
    OtherUnit{"\u00B0"sv, {"rad", 0, kDegree}},
    OtherUnit{"deg"sv, {"rad", 0, kDegree}},
    OtherUnit{"degree"sv, {"rad", 0, kDegree}},
    OtherUnit{"degrees"sv, {"rad", 0, kDegree}},
    OtherUnit{"radian"sv, {"rad"}},
    OtherUnit{"radians"sv, {"rad"}},
};

/// Returns the usual spelling of products and powers: "Pa s" for "Pa\u00B7s" and "Pa*s", "m/s" for
/// "m s-1", "N/mm2" for "N/mm\u00B2" and "N/mm^2".
std::string usualSpelling(std::string_view name) {
  std::string text(trimmedBlanks(name));
  for (const std::string_view times : {"\u00B7"sv, "\u22C5"sv, "*"sv}) replaceAll(text, times, " ");
  replaceAll(text, "\u207B\u00B9", "-1");
  replaceAll(text, "^", "");
  if (text != "m\u00B2") replaceAll(text, "\u00B2", "2");
  if (text.size() > 4 && text.ends_with(" s-1")) text = text.substr(0, text.size() - 4) + "/s";
  if (text.ends_with("/sec")) text.resize(text.size() - 2);
  return text;
}

std::optional<Unit> withPrefix(std::string_view text, std::string_view si) {
  if (!text.ends_with(si)) return {};
  const std::string_view letter = text.substr(0, text.size() - si.size());
  const auto found = std::ranges::find(kPrefixes, letter, &Prefix::letter);
  if (found == kPrefixes.end()) return {};
  return Unit{si, found->exponent, 1, 0};
}

std::optional<Unit> other(const std::string& text) {
  constexpr std::size_t kShort = 3;  // bytes; shorter names differ by their case
  for (const OtherUnit& one : kOthers)
    if (one.name == text || (one.name.size() >= kShort && lowerCase(one.name) == lowerCase(text)))
      return one.unit;
  return {};
}

const Dimension* dimensionOf(std::string_view si) {
  const auto found = std::ranges::find(kDimensions, si, &Dimension::si);
  return found == kDimensions.end() ? nullptr : &*found;
}

/// A number at the beginning of a text, and the rest of the text.
struct Parts {
  std::string mantissa;
  int exponent = 0;
  double number = 0;
  bool isTooLarge = false;
  std::string unit;
};

std::optional<Parts> partsOf(std::string_view text) {
  text = trimmedBlanks(text);
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && isDigit(text[at])) ++at;
    return at > begin;
  };
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  const bool hasDigitsBefore = digits();
  bool hasDigitsBehind = false;
  if (at < text.size() && text[at] == '.') {
    ++at;
    hasDigitsBehind = digits();
  }
  if (!hasDigitsBefore && !hasDigitsBehind) return {};
  Parts parts;
  parts.mantissa = text.substr(text.front() == '+' ? 1 : 0, at - (text.front() == '+' ? 1 : 0));
  // An "e" without digits behind it begins a unit.
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t end = at;
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t begin = at;
    const bool isExponent = digits() && at - begin < 6;
    if (isExponent)
      parts.exponent = std::stoi(std::string(text.substr(end + 1, at - end - 1)));
    else
      at = end;
  }
  parts.unit = trimmedBlanks(text.substr(at));
  const std::string number = fmt::format("{}e{}", parts.mantissa, parts.exponent);
  const auto [end, error] =
      std::from_chars(number.data(), number.data() + number.size(), parts.number);
  parts.isTooLarge = error == std::errc::result_out_of_range;
  return parts;
}

Message refusalOf(std::string_view text, const std::string& unit, const QuantityRule& rule) {
  const Dimension* known = rule.unit.empty() ? nullptr : dimensionOf(rule.unit);
  const bool isDifference = rule.unit == "K" && !rule.isTemperature;
  const Message wanted = !known         ? Message("a pure number")
                         : isDifference ? Message("a difference of temperatures")
                                        : Message(known->words);
  const PrintedNumber example{std::string(known ? known->example : "0.5"sv)};
  const std::optional<Unit> given = findUnit(unit);
  const Dimension* other = given && !given->si.empty() ? dimensionOf(given->si) : nullptr;
  if (other)
    return message("{} is {}; wanted is {}, such as {}", PrintedNumber{shortened(text)},
                   Message(other->words), wanted, example);
  if (given)
    return message("{} is {}; wanted is {}, such as {}", PrintedNumber{shortened(text)},
                   Message("a share"), wanted, example);
  return message("'{}' is not a known unit; wanted is {}, such as {}", shortened(unit), wanted,
                 example);
}

/// Rounds a converted number: the last digits of the product are rounding errors.
double roundedProduct(double value) {
  double rounded = value;
  readNumber(fmt::format("{:.14e}", value), rounded);
  return rounded;
}

}  // namespace

double Unit::toSi(double number) const {
  return (number + offset) * size * std::pow(10.0, exponent);
}

std::optional<Unit> findUnit(std::string_view name, std::string_view si) {
  const std::string text = usualSpelling(name);
  if (const auto found = other(text); found && found->si == si) return found;
  const Dimension* dimension = dimensionOf(si);
  return dimension ? withPrefix(text, dimension->si) : std::nullopt;
}

std::optional<Unit> findUnit(std::string_view name) {
  const std::string text = usualSpelling(name);
  if (const auto found = other(text)) return found;
  for (const Dimension& dimension : kDimensions)
    if (const auto found = withPrefix(text, dimension.si)) return found;
  return {};
}

bool isFemto(std::string_view name) {
  const std::string text = lowerCase(usualSpelling(name));
  return isOneOf(text, {"fn"sv, "fpa"sv, "fm/s"sv});
}

std::optional<Unit> unitInAnyCase(std::string_view name, std::string_view si) {
  if (isFemto(name)) return {};
  if (const auto exact = findUnit(name, si)) return exact;
  const std::string text = lowerCase(usualSpelling(name));
  for (const OtherUnit& one : kOthers)
    if (one.unit.si == si && lowerCase(one.name) == text) return one.unit;
  const Dimension* dimension = dimensionOf(si);
  if (!dimension) return {};
  // Lower-case letters stand for two prefixes, as m does for milli and mega.
  std::optional<Unit> smaller, larger;
  for (const Prefix& prefix : kPrefixes) {
    if (lowerCase(prefix.letter) + lowerCase(si) != text) continue;
    const Unit unit{dimension->si, prefix.exponent};
    if (!smaller || unit.exponent < smaller->exponent) smaller = unit;
    if (!larger || unit.exponent > larger->exponent) larger = unit;
  }
  if (!smaller || smaller->exponent == larger->exponent || si == "s") return smaller;
  return si == "Pa" ? larger : std::nullopt;
}

std::optional<double> unitSize(std::string_view name, std::string_view si) {
  const auto unit = unitInAnyCase(name, si);
  return unit && unit->offset == 0 ? std::optional(unit->toSi(1)) : std::nullopt;
}

std::string unitNames(std::string_view si) {
  std::string list(si);
  for (const std::string_view prefix : {"k"sv, "M"sv, "G"sv})
    if (si == "Pa") list += fmt::format(", {}{}", prefix, si);
  for (const std::string_view prefix : {"c"sv, "m"sv, "\u00B5"sv})
    if (si == "m" || si == "m/s") list += fmt::format(", {}{}", prefix, si);
  if (si == "Hz") list += ", kHz";
  for (const OtherUnit* one = kOthers.begin(); one != kOthers.end(); ++one) {
    const auto isSame = [one](const OtherUnit& other) {
      return other.unit.si == one->unit.si && other.unit.size == one->unit.size &&
             other.unit.offset == one->unit.offset && other.unit.exponent == one->unit.exponent;
    };
    // Words are for those who write them.
    if (one->unit.si == si && !one->name.ends_with("pascal") &&
        std::none_of(kOthers.begin(), one, isSame))
      list += fmt::format(", {}", one->name);
  }
  return list;
}

TypedQuantity typedQuantity(std::string_view text, const QuantityRule& rule) {
  const std::optional<Parts> parts = partsOf(text);
  if (!parts) return {};
  if (parts->isTooLarge) return {{}, {}, true};
  if (parts->unit.empty()) return {parts->number, {}};
  const std::optional<Unit> unit = findUnit(parts->unit, rule.unit);
  // A pure number with a word behind it that is no unit is no number.
  if (!unit && rule.unit.empty() && !findUnit(parts->unit)) return {};
  if (!unit || (unit->offset != 0 && !rule.isTemperature) || (rule.unit.empty() && rule.isWhole))
    return {{}, refusalOf(trimmedBlanks(text), parts->unit, rule)};
  if (unit->size != 1 || unit->offset != 0) return {roundedProduct(unit->toSi(parts->number)), {}};
  double value = 0;
  if (!readNumber(fmt::format("{}e{}", parts->mantissa, parts->exponent + unit->exponent), value))
    return {{}, {}, true};
  return {value, {}};
}

}  // namespace asperity
