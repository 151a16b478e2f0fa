#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

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

/// A unit that is not an SI unit with a prefix, and its names; the first one is shown. Names of
/// three letters and more are found in any case.
struct OtherUnit {
  WordList names;
  Unit unit;
};

constexpr double kPoundForce = 4.4482216152605;  // N
constexpr double kDegree = std::numbers::pi / 180;

constexpr std::array kOthers{
    OtherUnit{"%", {"", -2}},
    OtherUnit{"\u2030", {"", -3}},
    OtherUnit{"\u00B0C \u00BAC \u02DAC \u2103 degC oC C celsius", {"K", 0, 1, kZeroCelsius}},
    OtherUnit{"\u00B0F degF F fahrenheit", {"K", 0, 5.0 / 9, 459.67}},
    OtherUnit{"kelvin", {"K"}},
    OtherUnit{"micron microns", {"m", -6}},
    OtherUnit{"\u00C5", {"m", -10}},
    OtherUnit{"in inch", {"m", 0, 0.0254}},
    OtherUnit{"mil", {"m", 0, 2.54e-5}},
    OtherUnit{"ft", {"m", 0, 0.3048}},
    OtherUnit{"sec sek", {"s"}},
    OtherUnit{"min", {"s", 0, 60}},
    OtherUnit{"h", {"s", 0, 3600}},
    OtherUnit{"km/h kmh kph", {"m/s", 0, 1 / 3.6}},
    OtherUnit{"mph", {"m/s", 0, 0.44704}},
    OtherUnit{"in/s", {"m/s", 0, 0.0254}},
    OtherUnit{"ft/s", {"m/s", 0, 0.3048}},
    OtherUnit{"knots knot kts", {"m/s", 0, 1852.0 / 3600}},
    OtherUnit{"m/min", {"m/s", 0, 1.0 / 60}},
    OtherUnit{"cm/min", {"m/s", -2, 1.0 / 60}},
    OtherUnit{"mm/min", {"m/s", -3, 1.0 / 60}},
    OtherUnit{"in/min ipm", {"m/s", 0, 0.0254 / 60}},
    OtherUnit{"ft/min fpm", {"m/s", 0, 0.3048 / 60}},
    OtherUnit{"1/s s-1 hertz cps", {"Hz"}},
    OtherUnit{"rpm cpm", {"Hz", 0, 1.0 / 60}},
    OtherUnit{"daN", {"N", 1}},
    OtherUnit{"kgf kp", {"N", 0, 9.80665}},
    OtherUnit{"gf", {"N", -3, 9.80665}},
    OtherUnit{"lbf lbs", {"N", 0, kPoundForce}},
    OtherUnit{"N/m2 pascal", {"Pa"}},
    OtherUnit{"N/mm2 MN/m2 megapascal", {"Pa", 6}},
    OtherUnit{"N/cm2", {"Pa", 4}},
    OtherUnit{"kN/m2 kilopascal", {"Pa", 3}},
    OtherUnit{"daN/cm2", {"Pa", 5}},
    OtherUnit{"daN/mm2", {"Pa", 7}},
    OtherUnit{"kgf/cm2 kg/cm2 kp/cm2", {"Pa", 0, 98066.5}},
    OtherUnit{"kgf/mm2 kg/mm2 kp/mm2", {"Pa", 0, 9806650}},
    OtherUnit{"dyn/cm2 dyne/cm2 dynes/cm2", {"Pa", -1}},
    OtherUnit{"Torr", {"Pa", 0, 101325.0 / 760}},
    OtherUnit{"gigapascal", {"Pa", 9}},
    OtherUnit{"bar", {"Pa", 5}},
    OtherUnit{"mbar", {"Pa", 2}},
    OtherUnit{"atm", {"Pa", 0, 101325}},
    OtherUnit{"psi lbf/in2 lb/in2", {"Pa", 0, 6894.757293168361}},
    OtherUnit{"ksi", {"Pa", 3, 6894.757293168361}},
    OtherUnit{"N/mm", {"N/m", 3}},
    OtherUnit{"P", {"Pa s", -1}},
    OtherUnit{"cP", {"Pa s", -3}},
    OtherUnit{"m2", {"m\u00B2"}},
    OtherUnit{"kcal/mol", {"J/mol", 3, 4.184}},
    OtherUnit{"\u00B0 deg degree degrees", {"rad", 0, kDegree}},
    OtherUnit{"radian radians", {"rad"}},
};

/// Writes a unit in Russian letters in Latin ones: "MPa", "Hz", "mm/s", "rad/s", "C".
void spellInLatin(std::string& text) {
  if (text.find_first_of("\xD0\xD1") == text.npos) return;
  constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
      {"\u0413\u0446", "Hz"},                      // Gts
      {"\u043E\u0431/\u043C\u0438\u043D", "rpm"},  // ob/min
      {"\u043A\u0433\u0441", "kgf"},
      {"\u043C\u043A\u043C", "um"},
      {"\u0441\u043C", "cm"},
      {"\u041F", "P"},
      {"\u0430", "a"},
      {"\u041C", "M"},
      {"\u043C", "m"},
      {"\u041A", "K"},
      {"\u043A", "k"},
      {"\u0413", "G"},
      {"\u0421", "C"},
      {"\u0441", "s"},
      {"\u0435", "e"},
      {"\u041D", "N"},
      {"\u043D", "n"},
      {"\u0440", "r"},
      {"\u0434", "d"},
      {"\u0438", "i"},
      {"\u0447", "h"}};
  for (const auto& [letters, latin] : kSpellings) replaceAll(text, letters, latin);
}

/// Returns the usual spelling of products and powers: "Pa s" for "Pa\u00B7s" and "Pa*s", "m/s" for
/// "m s-1", "N/mm2" for "N/mm\u00B2" and "N/mm^2".
std::string usualSpelling(std::string_view name) {
  std::string text(trimmedBlanks(name));
  spellInLatin(text);
  for (const std::string_view times : {"\u00B7"sv, "\u22C5"sv, "*"sv}) replaceAll(text, times, " ");
  for (const std::string_view minus : {"\u207B"sv, "\u2212"sv}) replaceAll(text, minus, "-");
  replaceAll(text, "\u00B9", "1");
  replaceAll(text, "^", "");
  if (text != "m\u00B2") replaceAll(text, "\u00B2", "2");
  if (text.size() > 4 && text.ends_with(" s-1")) text = text.substr(0, text.size() - 4) + "/s";
  for (const std::string_view area : WordList("mm-2 cm-2 m-2"))  // "N mm-2"
    if (text.size() > area.size() + 1 && text.ends_with(area) &&
        text[text.size() - area.size() - 1] == ' ') {
      text[text.size() - area.size() - 1] = '/';
      text.erase(text.size() - 2, 1);
    }
  if (text.ends_with("/sec")) text.resize(text.size() - 2);
  if (text == "mps") return "m/s";
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
  const std::string inLowerCase = lowerCase(text);
  for (const OtherUnit& one : kOthers)
    for (const std::string_view name : one.names)
      if (name.size() == text.size() &&
          (name == text || (name.size() >= kShort && lowerCase(name) == inLowerCase)))
        return one.unit;
  return {};
}

/// Reads a velocity as a length over a time: "mm/h", "\u00B5m/min".
std::optional<Unit> lengthOverTime(std::string_view text) {
  const std::size_t stroke = text.find('/');
  if (stroke == text.npos) return {};
  const auto length = findUnit(text.substr(0, stroke), "m");
  const auto time = findUnit(text.substr(stroke + 1), "s");
  if (!length || !time) return {};
  return Unit{"m/s", length->exponent - time->exponent, length->size / time->size, 0};
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
  // An "e" without digits after it begins a unit.
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
    return message("{} is {}; expected {}, such as {}", PrintedNumber{shortened(text)},
                   Message(other->words), wanted, example);
  if (given)
    return message("{} is {}; expected {}, such as {}", PrintedNumber{shortened(text)},
                   Message("a share"), wanted, example);
  return message("'{}' is not a known unit; expected {}, such as {}", shortened(unit), wanted,
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
  const auto found = dimension ? withPrefix(text, dimension->si) : std::nullopt;
  return found || si != "m/s" ? found : lengthOverTime(text);
}

std::optional<Unit> findUnit(std::string_view name) {
  const std::string text = usualSpelling(name);
  if (const auto found = other(text)) return found;
  for (const Dimension& dimension : kDimensions)
    if (const auto found = withPrefix(text, dimension.si)) return found;
  return lengthOverTime(text);
}

bool isFemtoUnit(std::string_view name) {
  return isOneOf(lowerCase(usualSpelling(name)), "fn fpa fm/s");
}

std::optional<Unit> unitInAnyCase(std::string_view name, std::string_view si) {
  if (isFemtoUnit(name)) return {};
  if (const auto exact = findUnit(name, si)) return exact;
  if (const auto power = powerOfTenIn(name); power && power->isWritten && si.empty())
    return Unit{si, power->exponent};
  if (const auto scaled = scaledUnit(name); scaled && scaled->power.isWritten) {
    auto unit = unitInAnyCase(scaled->unit, si);
    if (!unit || unit->offset != 0) return {};
    unit->exponent += scaled->power.exponent;
    return unit;
  }
  const std::string text = lowerCase(usualSpelling(name));
  for (const OtherUnit& one : kOthers)
    for (const std::string_view known : one.names)
      if (one.unit.si == si && known.size() == text.size() && lowerCase(known) == text)
        return one.unit;
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
  const auto scaled = scaledUnit(name);
  const auto unit = unitInAnyCase(scaled ? scaled->unit : name, si);
  if (!unit || unit->offset != 0) return {};
  return unit->toSi(1) * (scaled ? scaled->power.value : 1);
}

std::optional<double> frequencySize(std::string_view unit, bool isAngular) {
  constexpr double kAngular = 0.5 / std::numbers::pi;
  if (const auto scaled = scaledUnit(unit)) {
    const auto size = frequencySize(scaled->unit, isAngular);
    return size ? std::optional(scaled->power.value * *size) : std::nullopt;
  }
  std::string written(unit);
  replaceAll(written, ".", " ");  // "rad.s-1", "rad/Sek."
  replaceAll(written, " per ", "/");
  const std::string text = usualSpelling(written);
  const std::size_t stroke = text.find('/');
  const bool isInverse = stroke == text.npos && text.ends_with("-1");  // "s-1", "min-1"
  std::string_view above = std::string_view(text).substr(0, stroke), below = "s";
  if (stroke != text.npos) below = std::string_view(text).substr(stroke + 1);
  if (isInverse) {
    std::tie(above, below) = std::pair("1"sv, std::string_view(text).substr(0, text.size() - 2));
    if (below.starts_with("rad")) std::tie(above, below) = std::pair("rad"sv, below.substr(3));
  }
  const std::string word = lowerCase(trimmedBlanks(above));
  const std::string time = lowerCase(trimmedBlanks(below));
  const auto seconds = isOneOf(time, "second seconds sekunde") ? std::optional(1.0)
                       : time == "minute"                      ? std::optional(60.0)
                                                               : unitSize(time, "s");
  if (!seconds) return {};
  if (isOneOf(word, "rad radian radians rads")) return kAngular / *seconds;
  if (isOneOf(word, "krad mrad"))
    return kAngular * (above.starts_with('m') ? 1e-3 : word == "krad" ? 1e3 : 1e6) / *seconds;
  if (stroke == text.npos && !isInverse) return unitSize(text, "Hz");
  if (word == "1") return (isAngular ? kAngular : 1) / *seconds;
  if (isOneOf(word, "cycle cycles cyc c rev u")) return 1 / *seconds;
  return isOneOf(word, "deg \u00B0") ? std::optional(1 / (360 * *seconds)) : std::nullopt;
}

std::string unitNames(std::string_view si) {
  std::string list(si);
  for (const std::string_view prefix : {"k"sv, "M"sv, "G"sv})
    if (si == "Pa") list += fmt::format(", {}{}", prefix, si);
  for (const std::string_view prefix : {"c"sv, "m"sv, "\u00B5"sv})
    if (si == "m" || si == "m/s") list += fmt::format(", {}{}", prefix, si);
  if (si == "Hz") list += ", kHz";
  for (const OtherUnit& one : kOthers)
    if (const std::string_view name = *one.names.begin(); one.unit.si == si && name != "gigapascal")
      list += fmt::format(", {}", name);
  return list;
}

TypedQuantity typedQuantity(std::string_view text, const QuantityRule& rule) {
  const std::optional<Parts> parts = partsOf(text);
  if (!parts) return {};
  if (parts->isTooLarge) return {{}, {}, true};
  if (parts->unit.empty()) return {parts->number, {}};
  const std::optional<Unit> unit = findUnit(parts->unit, rule.unit);
  // A pure number with a word after it that is no unit is no number.
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
