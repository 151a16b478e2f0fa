#include "core/base/text_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/text_number.h"
#include "core/base/units.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Words for units in addition to those of units.h and the lengths, in lower case.
constexpr std::array kOtherWords{
    "a"sv,          "c"sv,       "h"sv,       "k"sv,       "%"sv,       "-"sv,       "1"sv,
    "px"sv,         "pixel"sv,   "pixels"sv,  "percent"sv, "counts"sv,  "a.u."sv,    "arb"sv,
    "arb. units"sv, "seconds"sv, "rad"sv,     "rad/s"sv,   "rad s-1"sv, "rad*s-1"sv, "rad/sec"sv,
    "deg c"sv,      "deg. c"sv,  "\u00B0k"sv, "n/m"sv,     "pa.s"sv,    "pa s"sv,    "pa\u00B7s"sv};

/// Symbols in lower case that may have a prefix, in any case: "KHZ", "MM/S".
constexpr std::array kSymbols{"m"sv,   "s"sv, "hz"sv,    "pa"sv,   "n"sv,
                              "m/s"sv, "v"sv, "m/sec"sv, "m.s-1"sv};
constexpr std::array kLowerCasePrefixes{""sv,       "f"sv, "p"sv, "n"sv, "u"sv, "\u00B5"sv,
                                        "\u03BC"sv, "m"sv, "c"sv, "d"sv, "k"sv, "g"sv};

struct NamedLength {
  std::string_view name;
  double metres;
};

/// Units of length in addition to those of units.h, in lower case of ASCII, without an "s" at the
/// end.
constexpr std::array kLengths{NamedLength{"meter"sv, 1},
                              NamedLength{"metre"sv, 1},
                              NamedLength{"kilometer"sv, 1e3},
                              NamedLength{"kilometre"sv, 1e3},
                              NamedLength{"centimeter"sv, 1e-2},
                              NamedLength{"centimetre"sv, 1e-2},
                              NamedLength{"millimeter"sv, 1e-3},
                              NamedLength{"millimetre"sv, 1e-3},
                              NamedLength{"micrometer"sv, 1e-6},
                              NamedLength{"micrometre"sv, 1e-6},
                              NamedLength{"mikrometer"sv, 1e-6},
                              NamedLength{"mum"sv, 1e-6},
                              NamedLength{"mkm"sv, 1e-6},
                              NamedLength{"\u043C\u043A\u043C"sv, 1e-6},
                              NamedLength{"\u00B5"sv, 1e-6},
                              NamedLength{"\u03BC"sv, 1e-6},
                              NamedLength{"nanometer"sv, 1e-9},
                              NamedLength{"nanometre"sv, 1e-9},
                              NamedLength{"\u339A"sv, 1e-9},
                              NamedLength{"\u339B"sv, 1e-6},
                              NamedLength{"\u339C"sv, 1e-3},
                              NamedLength{"\u339D"sv, 1e-2},
                              NamedLength{"a"sv, 1e-10},
                              NamedLength{"\u212B"sv, 1e-10},
                              NamedLength{"angstrom"sv, 1e-10},
                              NamedLength{"\u00E5ngstr\u00F6m"sv, 1e-10},
                              NamedLength{"inche"sv, 0.0254},
                              NamedLength{"zoll"sv, 0.0254},
                              NamedLength{"\""sv, 0.0254},
                              NamedLength{"thou"sv, 2.54e-5},
                              NamedLength{"uin"sv, 2.54e-8},
                              NamedLength{"\u00B5in"sv, 2.54e-8},
                              NamedLength{"\u03BCin"sv, 2.54e-8},
                              NamedLength{"microinch"sv, 2.54e-8},
                              NamedLength{"microinche"sv, 2.54e-8},
                              NamedLength{"foot"sv, 0.3048},
                              NamedLength{"feet"sv, 0.3048},
                              NamedLength{"yd"sv, 0.9144}};

std::optional<double> namedLength(std::string_view unit) {
  std::string word = lowerCase(unit);
  for (int plural = 0; plural < 2; ++plural) {
    // "HM" is a hardness; hectometres are not in use.
    if (const auto known = findUnit(word, "m"); known && word != "hm") return known->toSi(1);
    for (const NamedLength& one : kLengths)
      if (one.name == word) return one.metres;
    if (word.size() < 4 || !word.ends_with('s')) return {};
    word.pop_back();
  }
  return {};
}

/// Reads a power of ten: "1e-6", "100", "10^-6", "\u00D710\u207B\u2076", "x10-6"; empty where the
/// text is none.
std::optional<double> powerOfTenIn(std::string_view text) {
  constexpr std::string_view kTimes = "\u00D7";
  constexpr std::array kRaised{"\u2070"sv, "\u00B9"sv, "\u00B2"sv, "\u00B3"sv, "\u2074"sv,
                               "\u2075"sv, "\u2076"sv, "\u2077"sv, "\u2078"sv, "\u2079"sv};
  text = trimmedBlanks(text);
  if (text.starts_with(kTimes)) text.remove_prefix(kTimes.size());
  if (text.starts_with('x') || text.starts_with('*')) text.remove_prefix(1);
  text = trimmedBlanks(text);
  double number = 0;
  if (readTextNumber(text, '.', number)) {
    if (!(number > 0)) return {};
    // Any other number is a length: "59.00 um" is no unit.
    const double exponent = std::log10(number);
    return std::abs(exponent - std::round(exponent)) < 1e-9 ? std::optional(number) : std::nullopt;
  }
  if (!text.starts_with("10")) return {};
  std::string exponent(text.substr(2));
  for (const auto& [raised, plain] :
       {std::pair{"\u207B"sv, "-"sv}, {"^"sv, ""sv}, {"\u2212"sv, "-"sv}})
    replaceAll(exponent, raised, plain);
  for (std::size_t digit = 0; digit < kRaised.size(); ++digit)
    replaceAll(exponent, kRaised[digit], std::to_string(digit));
  constexpr double kLargest = 30;
  if (!readTextNumber(exponent, '.', number) || std::abs(number) > kLargest) return {};
  return std::pow(10.0, number);
}

/// A unit and the power of ten in front of it.
struct ScaledUnit {
  double factor = 1;
  std::string_view unit;
};

/// Reads "1e-6 m", "10^-9*m", "x 10^3 Pa s". Empty where there is no power of ten in front.
std::optional<ScaledUnit> scaledUnit(std::string_view text) {
  constexpr std::string_view kMarks = " *";
  for (std::size_t at = 0; (at = text.find_first_of(kMarks, at)) != std::string_view::npos; ++at)
    if (const auto factor = powerOfTenIn(text.substr(0, at))) {
      const std::size_t unit = std::min(text.find_first_not_of(kMarks, at), text.size());
      return ScaledUnit{*factor, text.substr(unit)};
    }
  return {};
}

}  // namespace

bool isUnitWord(std::string_view text) {
  constexpr std::size_t kLongest = 14;
  if (text.empty() || text.size() > kLongest || isFemto(text)) return false;
  // Letters of Greek and of the ring stay as they are.
  const std::string word = lowerCase(text);
  if (std::ranges::find(kOtherWords, word) != kOtherWords.end()) return true;
  if (text.size() > 1 && (findUnit(text) || metresPer(text))) return true;
  // "1/nm" and "um^3" are units; a letter with a digit, such as "A2", is more likely a name than a
  // square.
  if (const auto length = parseLengthPower(text); length && length->power != 1)
    return word.find('m') != std::string::npos;
  return std::ranges::any_of(kSymbols, [&word](std::string_view symbol) {
    if (!word.ends_with(symbol)) return false;
    const std::string_view prefix = std::string_view(word).substr(0, word.size() - symbol.size());
    return std::ranges::find(kLowerCasePrefixes, prefix) != kLowerCasePrefixes.end();
  });
}

bool isKnownUnit(std::string_view text) {
  text = withoutBrackets(text);
  const auto scaled = scaledUnit(text);
  return isUnitWord(text) || (scaled && isUnitWord(scaled->unit));
}

std::optional<double> metresPer(std::string_view unit) {
  unit = withoutBrackets(unit);
  if (const auto metres = namedLength(unit)) return metres;
  const auto scaled = scaledUnit(unit);
  const auto metres = scaled ? namedLength(scaled->unit) : std::nullopt;
  return metres ? std::optional(*metres * scaled->factor) : std::nullopt;
}

namespace {

/// Reads "um^2 mm", "\u00B5m\u00B2\u00B7mm", "m^2/(1/m)": a square, as of heights, times or over
/// another power.
std::optional<LengthPower> productNamed(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) return {};
  for (const std::string_view mark : {"/("sv, " "sv, "*"sv, "\u00B7"sv, "\u22C5"sv}) {
    const std::size_t at = text.find(mark);
    if (at == std::string_view::npos) continue;
    const bool isOver = mark == "/(";
    const auto square = parseLengthPower(trimmedBlanks(text.substr(0, at)));
    // The bracket of a quotient stays with its content.
    const std::string_view rest = text.substr(isOver ? at + 1 : at + mark.size());
    const auto other = parseLengthPower(trimmedBlanks(rest));
    if (!square || square->power != 2 || !other) return {};
    const int otherPower = isOver ? -other->power : other->power, power = 2 + otherPower;
    if (power <= 0) return {};
    const double size = std::pow(square->metres, 2) * std::pow(other->metres, otherPower);
    return LengthPower{std::pow(size, 1.0 / power), power};
  }
  return {};
}

}  // namespace

std::optional<LengthPower> parseLengthPower(std::string_view text) {
  // Longer endings come first, because "-1" also ends with a digit.
  constexpr std::array<std::pair<std::string_view, int>, 14> kPowers{{{"\u207B\u00B9", -1},
                                                                      {"{-1}", -1},
                                                                      {"-1", -1},
                                                                      {"{2}", 2},
                                                                      {"{3}", 3},
                                                                      {"{4}", 4},
                                                                      {"\u00B2", 2},
                                                                      {"\u00B3", 3},
                                                                      {"\u2074", 4},
                                                                      {"2", 2},
                                                                      {"3", 3},
                                                                      {"4", 4},
                                                                      {"1", 1},
                                                                      {"", 1}}};
  text = withoutBrackets(text);
  int sign = 1;
  for (const std::string_view front : {"1/", "rad/", "cycles/", "cycle/", "cyc/"})
    if (text.starts_with(front)) {
      sign = -1;
      text.remove_prefix(front.size());
      break;
    }
  for (const auto& [ending, power] : kPowers) {
    if (!text.ends_with(ending)) continue;
    std::string_view length = text.substr(0, text.size() - ending.size());
    if (length.ends_with('^')) length.remove_suffix(1);
    if (const auto metres = metresPer(length)) return LengthPower{*metres, sign * power};
  }
  return sign > 0 ? productNamed(text) : std::nullopt;
}

}  // namespace asperity
