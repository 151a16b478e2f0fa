#include "core/material/text_quantities.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

/// Returns whether a unit goes on as that of a rate: "/min", " / s", " per minute".
bool goesOnAsRate(std::string_view text) {
  text = trimmedBlanks(text);
  const std::size_t over = text.starts_with('/') ? 1 : text.starts_with("per ") ? 4 : 0;
  if (over == 0) return text.starts_with("min-1") || text.starts_with("min^-1");
  text = trimmedBlanks(text.substr(over));
  std::size_t end = 0;
  while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
  return isOneOf(lowerCase(text.substr(0, end)), "min minute s sec second h hr hour mm m");
}

/// Returns the length of a sign with the spaces after it that begins here, 0 where there is none:
/// "-", "\u2212", an en dash, "minus". A dash before a blank is a sign at the beginning, after a
/// key and after "at"; elsewhere it separates, as in "NR 60 - 20 \u00B0C".
std::size_t signLength(std::string_view text, std::size_t begin, bool& isMinus) {
  const std::string_view rest = text.substr(begin);
  const std::string_view before = trimmedBlanks(text.substr(0, begin));
  isMinus = true;
  if (lowerCase(rest.substr(0, 6)) == "minus ")
    return before.ends_with('/') || lowerCase(before).ends_with("plus") ? 0 : 6;
  for (const std::string_view sign : {"-", "+", "\u2212", "\u2013"}) {
    if (!rest.starts_with(sign)) continue;
    isMinus = sign != "+";
    // "20 +/-0.5" and "20 +-0.5" are tolerances.
    if (before.ends_with('+') || before.ends_with('/')) return 0;
    if (!rest.substr(sign.size()).starts_with(' ')) return sign.size();
    const std::size_t word = before.find_last_of(" \t");
    const bool isBehindKey =
        before.empty() || std::string_view(":=(@[").find(before.back()) != before.npos ||
        isOneOf(lowerCase(before.substr(word == before.npos ? 0 : word + 1)), "at bei");
    return isBehindKey ? sign.size() + 1 : 0;
  }
  return 0;
}

/// Returns the digits and marks from `at` on, with decimal points, and moves `at` behind them.
std::string takeDigits(std::string_view text, std::size_t& at) {
  std::string number;
  for (; at < text.size() && (isDigit(text[at]) || text[at] == '.' || text[at] == ','); ++at)
    number += text[at] == ',' ? '.' : text[at];
  return number;
}

/// Returns the temperature with its unit that begins at this position.
std::optional<TextTemperature> temperatureAt(std::string_view text, std::size_t begin) {
  bool isMinus = false;
  const std::size_t sign = signLength(text, begin, isMinus);
  std::size_t end = begin + sign;
  if (end == text.size() || !isDigit(text[end])) return {};
  const std::string number = (sign > 0 && isMinus ? "-" : "") + takeDigits(text, end);
  double value = 0;
  if (!readTextNumber(number, '.', value)) return {};
  while (end < text.size() && (text[end] == ' ' || text[end] == '_')) ++end;
  // The longest unit is tried first; a letter after it belongs to another word.
  constexpr WordList kUnits(
      "Grad Celsius, grad Celsius, degrees Celsius, degrees C, \u00B0Celsius, \u00B0 Celsius, "
      "Grad C, deg. C, \u00B0C, \u00BAC, \u02DAC, oC, \u2103, degC, deg C, \u00B0 C, \u00B0F, "
      "degF, Celsius, "
      "celsius, Kelvin, kelvin, C, K, F",
      ',');
  for (const std::string_view written : kUnits) {
    if (!text.substr(end).starts_with(written)) continue;
    const std::size_t behind = end + written.size();
    if (behind < text.size() && std::isalnum(static_cast<unsigned char>(text[behind]))) continue;
    if (goesOnAsRate(text.substr(behind))) return {};
    const std::string_view unit = written.ends_with('F')            ? "F"
                                  : beginsWithOneOf(written, "K k") ? "K"
                                                                    : "C";
    const bool isLetter = written == "C" || written == "F";
    return TextTemperature{
        temperatureUnit(unit)->toSi(value), begin, behind, value, unit, isLetter};
  }
  return {};
}

}  // namespace

std::optional<TextTemperature> firstTemperature(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i > 0 && (isDigit(text[i - 1]) || text[i - 1] == '.')) continue;
    if (const auto found = temperatureAt(text, i)) return found;
  }
  return {};
}

std::optional<double> findTemperature(std::string_view text) {
  const auto found = firstTemperature(text);
  return found ? std::optional(found->kelvin) : std::nullopt;
}

std::vector<double> findTemperatures(std::string_view text) {
  std::vector<double> all;
  while (const auto found = firstTemperature(text)) {
    all.push_back(found->kelvin);
    text.remove_prefix(found->end);
  }
  return all;
}

std::optional<double> parseTemperature(std::string_view text) {
  const auto quantity = parseQuantity(text);
  if (!quantity) return {};
  if (quantity->unit.empty()) return quantity->number;
  const auto unit = temperatureUnit(quantity->unit);
  return unit ? std::optional(unit->toSi(quantity->number)) : std::nullopt;
}

std::optional<Unit> temperatureUnit(std::string_view unit) {
  std::string word = lowerCase(unit);
  for (const std::string_view mark : {"\u00B0", "\u00BA", "deg", ".", " "})
    replaceAll(word, mark, "");
  if (word == "\u0441") word = "c";  // of Russian
  return unitInAnyCase(word, "K");
}

std::optional<double> frequencyUnit(std::string_view unit, bool isAngular) {
  return frequencySize(unit.empty() ? std::string_view(isAngular ? "rad/s" : "Hz") : unit,
                       isAngular);
}

std::optional<double> strainUnit(std::string_view unit) {
  std::string word = compactName(unit);
  for (const std::string_view micro : {"\u00B5", "\u03BC"}) replaceAll(word, micro, "u");
  if (word.empty() || isOneOf(word, "1 m/m mm/mm um/um strain ratio")) return 1;
  if (isOneOf(word, "% percent pct")) return 1e-2;
  if (isOneOf(word, "\u2030 mm/m")) return 1e-3;
  if (isOneOf(word, "ppm um/m ustrain microstrain")) return 1e-6;
  return {};
}

std::optional<double> parseStrain(std::string_view text) {
  const auto quantity = parseQuantity(text);
  if (!quantity || !(quantity->unit.empty() || quantity->unit == "%")) return {};
  const double strain = quantity->unit.empty() ? quantity->number : quantity->number / 100;
  return strain > 0 && std::isfinite(strain) ? std::optional(strain) : std::nullopt;
}

std::optional<double> viscosityUnit(std::string unit) {
  replaceAll(unit, ".", " ");  // "Pa.s"
  if (unit.ends_with("Pas")) unit.insert(unit.size() - 1, " ");
  return unitSize(unit, "Pa s");
}

std::optional<double> complianceUnit(std::string_view unit) {
  std::string inverse;
  if (const std::size_t stroke = unit.find('/'); stroke != unit.npos) {
    const std::string_view above = trimmedBlanks(unit.substr(0, stroke));
    inverse = withoutBrackets(unit.substr(stroke + 1));
    if (above != "1") inverse += "/" + std::string(above);
  } else {
    for (const std::string_view power : WordList("^-1 ^(-1) -1 \u207B\u00B9"))
      if (unit.ends_with(power)) {
        inverse = trimmedBlanks(unit.substr(0, unit.size() - power.size()));
        break;
      }
  }
  const auto size = unitSize(inverse, "Pa");
  return size ? std::optional(1 / *size) : std::nullopt;
}

std::optional<double> angleUnit(std::string_view unit) {
  if (lowerCase(unit) == "grad") return std::numbers::pi / 180;
  return unitSize(unit, "rad");
}

std::optional<double> timeSize(std::string_view unit) {
  const std::string word(withoutEnd(lowerCase(unit), "."));
  if (isOneOf(word, "second seconds sekunde sekunden")) return 1;
  if (isOneOf(word, "msec millisecond milliseconds")) return 1e-3;
  if (isOneOf(word, "usec \u00B5sec \u03BCsec microsecond microseconds")) return 1e-6;
  if (isOneOf(word, "min minute minutes minuten")) return 60;
  if (isOneOf(word, "hr hrs hour hours stunde stunden")) return 3600;
  if (isOneOf(word, "d day days tag tage")) return 86400;
  return unitSize(withoutEnd(unit, "."), "s");
}

double modulusSize(const std::string& unit, const std::string& name, const std::string& key) {
  for (const std::string_view text :
       {std::string_view(unit), withoutBrackets(unit),
        std::string_view(unit).substr(0, unit.find_first_of(" ,;(["))})
    if (const auto size = unitSize(text, "Pa")) return *size;
  throw InputError(
      name, key,
      message("has the unit {}, which is not one of {}", shortened(unit), unitNames("Pa")));
}

std::optional<TextFrequency> firstFrequency(std::string_view text) {
  constexpr WordList kUnits("rad/s mHz kHz MHz Hz HZ hz");
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!isDigit(text[begin])) continue;
    const std::size_t digits = begin;
    const std::string number = takeDigits(text, begin);
    std::size_t unit = begin;
    while (unit < text.size() && (text[unit] == ' ' || text[unit] == '_')) ++unit;
    double value = 0;
    // "G1 Hz" and "run3 Hz" are names.
    const bool isOfWord =
        digits > 0 && std::isalnum(static_cast<unsigned char>(text[digits - 1])) != 0;
    if (isOfWord || !readTextNumber(number, '.', value)) continue;
    for (const std::string_view name : kUnits) {
      const std::size_t after = unit + name.size();
      if (!text.substr(unit).starts_with(name) ||
          (after < text.size() && std::isalnum(static_cast<unsigned char>(text[after])) != 0))
        continue;
      if (const auto size = frequencyUnit(name, false); size && value > 0)
        return TextFrequency{value * *size, digits, after};
    }
  }
  return {};
}

namespace {

/// Returns whether the text in front of a frequency is about a ramp at it, and not about a range:
/// "Temperature sweep at 10 Hz", but not "Frequency sweep 0.1 - 100 Hz".
bool saysFrequencyOfRamp(std::string_view text) {
  const std::vector<std::string> words = wordsIn(text);
  const bool hasNumbers =
      std::ranges::any_of(words, [](const std::string& word) { return isDigit(word.front()); });
  return hasOneOf(words, "sweep ramp temperatursweep temperaturrampe dma") &&
         (!hasNumbers || isOneOf(words.back(), "at bei f freq frequency frequenz"));
}

}  // namespace

std::optional<double> statedFrequency(const TextBlock& block) {
  std::optional<double> found;
  for (const TextEntry& entry : block.header) {
    const std::string line = joinEntry(entry);
    for (const std::string_view clause : splitClauses(line)) {
      std::optional<double> size;
      double number = 0;
      if (const auto statement = parseStatement(clause)) {
        const DmaColumn key = dmaColumn(statement->name.name, {});
        if (key.quantity != DmaQuantity::Frequency || statement->unit().empty() ||
            containsOneOf(lowerCase(statement->key), "sampl abtast natural eigen reson filter"))
          continue;
        size = frequencyUnit(statement->unit(), key.isAngular);
        number = statement->quantity.number;
      } else if (const auto alone = parseQuantity(clause); alone && !alone->unit.empty()) {
        size = frequencyUnit(alone->unit, false);
        number = alone->number;
      } else if (const auto inText = firstFrequency(clause);
                 inText && saysFrequencyOfRamp(clause.substr(0, inText->begin))) {
        size = 1;
        number = inText->hertz;
      }
      if (!size || !(number > 0)) continue;
      if (found && *found != number * *size) return {};
      found = number * *size;
    }
  }
  return found;
}

}  // namespace asperity
