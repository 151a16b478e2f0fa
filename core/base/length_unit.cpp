#include "core/base/length_unit.h"

#include <array>
#include <cmath>
#include <string>

#include "core/base/text_names.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

struct NamedUnit {
  std::string_view name;
  double metres;
};

/// In lower case of ASCII.
constexpr std::array kLengths{NamedUnit{"m"sv, 1},
                              NamedUnit{"meter"sv, 1},
                              NamedUnit{"metre"sv, 1},
                              NamedUnit{"dm"sv, 1e-1},
                              NamedUnit{"cm"sv, 1e-2},
                              NamedUnit{"centimeter"sv, 1e-2},
                              NamedUnit{"centimetre"sv, 1e-2},
                              NamedUnit{"mm"sv, 1e-3},
                              NamedUnit{"millimeter"sv, 1e-3},
                              NamedUnit{"millimetre"sv, 1e-3},
                              NamedUnit{"um"sv, 1e-6},
                              NamedUnit{"\u00B5m"sv, 1e-6},
                              NamedUnit{"\u03BCm"sv, 1e-6},
                              NamedUnit{"\u339B"sv, 1e-6},
                              NamedUnit{"mum"sv, 1e-6},
                              NamedUnit{"mkm"sv, 1e-6},
                              NamedUnit{"\u043C\u043A\u043C"sv, 1e-6},
                              NamedUnit{"\u00B5"sv, 1e-6},
                              NamedUnit{"\u03BC"sv, 1e-6},
                              NamedUnit{"micron"sv, 1e-6},
                              NamedUnit{"micrometer"sv, 1e-6},
                              NamedUnit{"micrometre"sv, 1e-6},
                              NamedUnit{"mikrometer"sv, 1e-6},
                              NamedUnit{"nm"sv, 1e-9},
                              NamedUnit{"\u339A"sv, 1e-9},
                              NamedUnit{"nanometer"sv, 1e-9},
                              NamedUnit{"nanometre"sv, 1e-9},
                              NamedUnit{"pm"sv, 1e-12},
                              NamedUnit{"fm"sv, 1e-15},
                              NamedUnit{"\u339C"sv, 1e-3},
                              NamedUnit{"\u339D"sv, 1e-2},
                              NamedUnit{"a"sv, 1e-10},
                              NamedUnit{"\u00C5"sv, 1e-10},
                              NamedUnit{"\u212B"sv, 1e-10},
                              NamedUnit{"angstrom"sv, 1e-10},
                              NamedUnit{"\u00E5ngstr\u00F6m"sv, 1e-10},
                              NamedUnit{"km"sv, 1e3},
                              NamedUnit{"in"sv, 0.0254},
                              NamedUnit{"inch"sv, 0.0254},
                              NamedUnit{"inche"sv, 0.0254},
                              NamedUnit{"zoll"sv, 0.0254},
                              NamedUnit{"\""sv, 0.0254},
                              NamedUnit{"mil"sv, 2.54e-5},
                              NamedUnit{"thou"sv, 2.54e-5},
                              NamedUnit{"uin"sv, 2.54e-8},
                              NamedUnit{"\u00B5in"sv, 2.54e-8},
                              NamedUnit{"\u03BCin"sv, 2.54e-8},
                              NamedUnit{"microinch"sv, 2.54e-8},
                              NamedUnit{"microinche"sv, 2.54e-8},
                              NamedUnit{"ft"sv, 0.3048},
                              NamedUnit{"foot"sv, 0.3048},
                              NamedUnit{"feet"sv, 0.3048},
                              NamedUnit{"yd"sv, 0.9144}};

std::optional<double> named(std::string_view unit) {
  std::string word = lowerCase(unit);
  for (int plural = 0; plural < 2; ++plural) {
    for (const NamedUnit& one : kLengths)
      if (one.name == word) return one.metres;
    if (word.size() < 4 || !word.ends_with('s')) return {};
    word.pop_back();
  }
  return {};
}

/// "1e-6", "10^-6", "\u00D710\u207B\u2076", "x10-6"; empty where it is none of these.
std::optional<double> factorIn(std::string_view text) {
  constexpr std::string_view kTimes = "\u00D7";
  constexpr std::array kRaised{"\u2070"sv, "\u00B9"sv, "\u00B2"sv, "\u00B3"sv, "\u2074"sv,
                               "\u2075"sv, "\u2076"sv, "\u2077"sv, "\u2078"sv, "\u2079"sv};
  text = trimmedBlanks(text);
  if (text.ends_with('*')) text.remove_suffix(1);
  if (text.starts_with(kTimes)) text.remove_prefix(kTimes.size());
  if (text.starts_with('x') || text.starts_with('*')) text.remove_prefix(1);
  text = trimmedBlanks(text);
  double number = 0;
  if (!text.starts_with("10") || text.size() == 2) {
    if (!readTextNumber(text, '.', number) || !(number > 0)) return {};
    // Any other number is a length: "59.00 um" is no unit.
    const double exponent = std::log10(number);
    return std::abs(exponent - std::round(exponent)) < 1e-9 ? std::optional(number) : std::nullopt;
  }
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

}  // namespace

std::optional<double> metresPer(std::string_view unit) {
  unit = withoutBrackets(unit);
  if (const auto metres = named(unit)) return metres;
  const std::size_t between = unit.find_last_of(" *");
  if (between == std::string_view::npos) return {};
  const auto metres = named(unit.substr(between + 1));
  const auto factor = factorIn(unit.substr(0, between + 1));
  if (!metres || !factor || !(*factor > 0)) return {};
  return *metres * *factor;
}

std::optional<LengthPower> lengthPowerNamed(std::string_view text) {
  // Longer endings first, for "-1" ends in a digit, too.
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
  for (const std::string_view front : {"1/", "rad/"})
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
  return {};
}

}  // namespace asperity
