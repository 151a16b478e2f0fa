#include "core/base/text_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Words for units in addition to those of findUnit and the lengths, in lower case.
constexpr WordList kOtherWords(
    "a, c, h, k, %, -, 1, px, pixel, pixels, percent, counts, a.u., arb, arb. units, seconds, rad, "
    "rad/s, rad s-1, rad*s-1, rad/sec, deg c, deg. c, deg f, deg. f, \u00B0k, n/m, pa.s, pa s, "
    "pa\u00B7s",
    ',');

/// Symbols in lower case that may have a prefix, in any case: "KHZ", "MM/S".
constexpr WordList kSymbols("m s hz pa n m/s v m/sec m.s-1");
constexpr WordList kLowerCasePrefixes("f p n u \u00B5 \u03BC m c d k g");

struct NamedLength {
  WordList names;
  double metres;
};

/// Units of length beside those of findUnit, in lower case of ASCII, without an "s" at the end.
constexpr std::array kLengths{
    NamedLength{"meter metre m\u00E8tre \u043C \u7C73", 1}, NamedLength{"kilometer kilometre", 1e3},
    NamedLength{"centimeter centimetre centim\u00E8tre \u0441\u043C \u5398\u7C73 \u339D", 1e-2},
    NamedLength{"millimeter millimetre millim\u00E8tre \u043C\u043C \u6BEB\u7C73 \u339C", 1e-3},
    // The last but one is "\u03BCm" in Shift-JIS, read as Latin-1.
    NamedLength{"micrometer micrometre microm\u00E8tre mikrometer mum mkm \u043C\u043A\u043C "
                "\u5FAE\u7C73 \u00B5 \u03BC \u0192\u00CAm \u339B",
                1e-6},
    NamedLength{"nanometer nanometre nanom\u00E8tre \u043D\u043C \u7EB3\u7C73 \u339A", 1e-9},
    NamedLength{"a \u212B angstrom \u00E5ngstr\u00F6m", 1e-10},
    NamedLength{"inche zoll \"", 0.0254}, NamedLength{"thou", 2.54e-5},
    NamedLength{"uin \u00B5in \u03BCin microinch microinche uinch uinche \u00B5inch \u00B5inche "
                "\u03BCinch \u03BCinche",
                2.54e-8},
    NamedLength{"foot feet", 0.3048}, NamedLength{"yd", 0.9144}};

std::optional<double> namedLength(std::string_view unit) {
  std::string word = lowerCase(unit);
  for (int plural = 0; plural < 2; ++plural) {
    // "HM" is a hardness; hectometres are not in use.
    if (const auto known = findUnit(word, "m"); known && word != "hm") return known->toSi(1);
    for (const NamedLength& one : kLengths)
      if (isOneOf(word, one.names)) return one.metres;
    if (word.size() < 4 || !word.ends_with('s')) return {};
    word.pop_back();
  }
  return {};
}

}  // namespace

bool isUnitWord(std::string_view text) {
  constexpr std::size_t kLongest = 14;
  if (text.empty() || text.size() > kLongest || isFemtoUnit(text)) return false;
  // Letters of Greek and of the ring stay as they are.
  const std::string word = lowerCase(text);
  if (isOneOf(word, kOtherWords)) return true;
  if (text.size() > 1 && (findUnit(text) || metresPer(text))) return true;
  if (text.find_first_of("/1\u207B") != text.npos && frequencySize(text, true)) return true;
  // "1/MPa" of a compliance
  if (text.starts_with("1/") && findUnit(text.substr(2), "Pa")) return true;
  // "1/nm" and "um^3" are units; a letter with a digit, such as "A2", is more likely a name than a
  // square.
  if (const auto length = parseLengthPower(text); length && length->power != 1)
    return word.find('m') != std::string::npos;
  return std::ranges::any_of(kSymbols, [&word](std::string_view symbol) {
    if (!word.ends_with(symbol)) return false;
    const std::string_view prefix = std::string_view(word).substr(0, word.size() - symbol.size());
    return prefix.empty() || isOneOf(prefix, kLowerCasePrefixes);
  });
}

bool isKnownUnit(std::string_view text) {
  text = withoutBrackets(text);
  const auto scaled = scaledUnit(text);
  return isUnitWord(text) || (scaled && isUnitWord(scaled->unit));
}

std::optional<double> metresPer(std::string_view unit) {
  unit = withoutBrackets(unit);
  if (unit.ends_with('.')) unit.remove_suffix(1);  // "in."
  if (const auto metres = namedLength(unit)) return metres;
  const auto scaled = scaledUnit(unit);
  const auto metres = scaled ? namedLength(scaled->unit) : std::nullopt;
  return metres ? std::optional(*metres * scaled->power.value) : std::nullopt;
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
  constexpr std::pair<std::string_view, int> kPowers[] = {{"\u207B\u00B9", -1},
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
                                                          {"", 1}};
  text = withoutBrackets(text);
  int sign = 1;
  for (const std::string_view front : WordList("1/ rad/ cycles/ cycle/ cyc/"))
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
