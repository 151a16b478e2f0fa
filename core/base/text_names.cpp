#include "core/base/text_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/length_unit.h"
#include "core/base/text_number.h"
#include "core/base/units.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Units with a spelling of their own, beside those made of a prefix and a symbol.
constexpr std::array kUnits{"micron"sv,     "microns"sv,   "mum"sv,
                            "mkm"sv,        "inch"sv,      "inches"sv,
                            "in"sv,         "mil"sv,       "mils"sv,
                            "thou"sv,       "ft"sv,        "feet"sv,
                            "\u00C5"sv,     "\u212B"sv,    "a"sv,
                            "angstrom"sv,   "angstroms"sv, "\u03BC"sv,
                            "\u00B5"sv,     "\u339A"sv,    "\u339B"sv,
                            "\u339C"sv,     "\u339D"sv,    "px"sv,
                            "pixel"sv,      "pixels"sv,    "min"sv,
                            "h"sv,          "sec"sv,       "seconds"sv,
                            "rad/s"sv,      "rad s-1"sv,   "rad*s-1"sv,
                            "rad"sv,        "1/s"sv,       "s-1"sv,
                            "s^-1"sv,       "hertz"sv,     "rad/sec"sv,
                            "deg"sv,        "\u00B0"sv,    "degrees"sv,
                            "\u00B0c"sv,    "\u00BAc"sv,   "degc"sv,
                            "deg c"sv,      "deg. c"sv,    "celsius"sv,
                            "c"sv,          "k"sv,         "kelvin"sv,
                            "\u2103"sv,     "\u00B0f"sv,   "\u00B0k"sv,
                            "%"sv,          "percent"sv,   "-"sv,
                            "1"sv,          "psi"sv,       "bar"sv,
                            "mbar"sv,       "n/mm2"sv,     "n/mm\u00B2"sv,
                            "n/mm^2"sv,     "n/m2"sv,      "n/m\u00B2"sv,
                            "n/m^2"sv,      "dyn/cm2"sv,   "dyn/cm\u00B2"sv,
                            "dyn/cm^2"sv,   "rpm"sv,       "km/h"sv,
                            "kph"sv,        "m s-1"sv,     "m/min"sv,
                            "n/m"sv,        "pa.s"sv,      "pa s"sv,
                            "pa\u00B7s"sv,  "a.u."sv,      "arb"sv,
                            "arb. units"sv, "counts"sv};

/// Symbols that take a prefix; the long words as they are spelt.
constexpr std::array kSymbols{"m"sv,      "s"sv,     "hz"sv,    "pa"sv,     "n"sv,
                              "m/s"sv,    "v"sv,     "metre"sv, "metres"sv, "meter"sv,
                              "meters"sv, "m/sec"sv, "m.s-1"sv};
constexpr std::array kPrefixes{""sv,       "f"sv,     "p"sv,    "n"sv,     "u"sv,    "\u00B5"sv,
                               "\u03BC"sv, "m"sv,     "c"sv,    "d"sv,     "k"sv,    "g"sv,
                               "micro"sv,  "milli"sv, "nano"sv, "centi"sv, "kilo"sv, "mega"sv};

/// Letters of Greek and of the ring in their lower-case form stay as they are.
bool isUnitWord(std::string_view text) {
  if (text.empty() || text.size() > 14) return false;
  const std::string word = lowerCase(text);
  if (std::ranges::find(kUnits, word) != kUnits.end()) return true;
  if (text.size() > 1 && (unitNamed(text) || metresPer(text))) return true;
  // "1/nm", "um^3"; a letter with a digit, such as "A2", is rather a name than square angstroms.
  if (const auto length = lengthPowerNamed(text); length && length->power != 1)
    return word.find('m') != std::string::npos;
  return std::ranges::any_of(kSymbols, [&word](std::string_view symbol) {
    if (!word.ends_with(symbol)) return false;
    const std::string_view prefix = std::string_view(word).substr(0, word.size() - symbol.size());
    return std::ranges::find(kPrefixes, prefix) != kPrefixes.end();
  });
}

/// "1e-6 m", "10^-9 m", "\u00D710\u207B\u2076 m": a power of ten and a unit. "59.00 um" is a
/// length.
bool isScaledUnit(std::string_view text) {
  const std::size_t blank = text.find_last_of(" *");
  if (blank == std::string_view::npos || !isUnitWord(text.substr(blank + 1))) return false;
  std::string_view factor = trimmedBlanks(text.substr(0, blank));
  for (const std::string_view times : {"\u00D7"sv, "x"sv, "*"sv})
    if (factor.starts_with(times)) factor.remove_prefix(times.size());
  double number = 0;
  if (!readTextNumber(factor, '.', number)) return factor.starts_with("10") && factor.size() > 2;
  return number > 0 && std::abs(std::log10(number) - std::round(std::log10(number))) < 1e-9;
}

/// Letters that are also symbols of quantities: behind "_" or a blank they are units of these
/// alone.
bool suitsLetter(std::string_view name, std::string_view unit) {
  if (unit.size() > 1) return lowerCase(unit) != "in" || name.size() <= 2;
  const char first = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  switch (unit.front()) {
    case 'm':
      return true;
    case 's':
      return first == 't';
    case 'K':
    case 'C':
      return first == 't';
    case 'N':
      return first == 'f' || first == 'l' || first == 'n';
    case '%':
      return true;
    default:
      return false;
  }
}

ColumnName parts(std::string_view name, std::string_view unit) {
  while (!name.empty() &&
         (name.back() == '_' || name.back() == ',' || name.back() == ' ' || name.back() == '/'))
    name.remove_suffix(1);
  if (name.ends_with(" in")) name.remove_suffix(3);  // "v in m/s"
  return {std::string(trimmedField(name)), std::string(trimmedBlanks(unit))};
}

/// Fields between tabs or runs of at least two blanks.
std::vector<std::string> splitAtWideBlanks(std::string_view line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool isWide = i == line.size() || line[i] == '\t' || line.substr(i).starts_with("  ");
    if (!isWide) continue;
    const std::string_view field = trimmedField(line.substr(begin, i - begin));
    if (!field.empty()) fields.emplace_back(field);
    begin = i;
    if (i < line.size()) ++begin;
  }
  return fields;
}

/// Fields between single blanks; a unit, and what stands in brackets or behind a stroke, belongs to
/// the name before.
std::vector<std::string> splitAtBlanks(std::string_view line) {
  std::vector<std::string_view> words;
  splitFields(line, TextDialect::Separator::Blanks, words);
  std::vector<std::string> fields;
  bool open = false, joined = false;
  for (const std::string_view word : words) {
    const bool isUnit = (word.front() == '(' || word.front() == '[' || word.front() == '{');
    const bool isStroke = word == "/" || word == "in";
    if (!fields.empty() && (open || joined || isUnit || isStroke))
      fields.back() += " " + std::string(word);
    else
      fields.emplace_back(trimmedField(word));
    open = (open || isUnit) && word.find_first_of(")]}") == std::string_view::npos;
    joined = isStroke;
  }
  return fields;
}

std::vector<std::string> splitAt(std::string_view line, TextDialect::Separator separator) {
  std::vector<std::string_view> fields;
  splitFields(line, separator, fields);
  std::vector<std::string> names;
  for (const std::string_view field : fields) names.emplace_back(trimmedField(field));
  while (names.size() > 1 && names.back().empty()) names.pop_back();
  return names;
}

}  // namespace

std::string_view withoutBrackets(std::string_view text) {
  text = trimmedField(text);
  constexpr std::string_view opening = "([{<", closing = ")]}>";
  if (text.size() < 2) return text;
  const std::size_t kind = opening.find(text.front());
  if (kind == std::string_view::npos || text.back() != closing[kind]) return text;
  return trimmedBlanks(text.substr(1, text.size() - 2));
}

bool isKnownUnit(std::string_view text) {
  text = withoutBrackets(text);
  return isUnitWord(text) || isScaledUnit(text);
}

ColumnName columnName(std::string_view text) {
  text = trimmedField(text);
  if (text.empty()) return {};

  // In brackets.
  constexpr std::string_view opening = "([{", closing = ")]}";
  for (std::size_t at = 0; (at = text.find_first_of(opening, at)) != std::string_view::npos; ++at) {
    const std::size_t end = text.find(closing[opening.find(text[at])], at);
    if (end == std::string_view::npos) break;
    const std::string_view unit = text.substr(at + 1, end - at - 1);
    const bool isLast = end + 1 == text.size();
    if (isKnownUnit(unit) || (text[at] == '[' && isLast && at > 0 && !trimmedBlanks(unit).empty()))
      return parts(text.substr(0, at), unit);
  }

  // "v_m/s", "v m/s".
  if (const std::size_t at = text.find_last_of("_ ");
      at != std::string_view::npos && at > 0 && text.find('/', at) != std::string_view::npos &&
      isUnitWord(text.substr(at + 1)))
    return parts(text.substr(0, at), text.substr(at + 1));

  // Behind a stroke, which may stand in the unit, too: "v / m/s".
  for (std::size_t at = 0; (at = text.find('/', at)) != std::string_view::npos; ++at)
    if (at > 0 && isKnownUnit(text.substr(at + 1)))
      return parts(text.substr(0, at), text.substr(at + 1));

  // Behind a comma, " in ", a blank or "_".
  for (const std::string_view between : {", "sv, ","sv, " in "sv, " "sv, "_"sv}) {
    const std::size_t at = text.rfind(between);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = text.substr(at + between.size());
    const bool isLoose = between == " " || between == "_";
    if (isUnitWord(unit) && (!isLoose || suitsLetter(text.substr(0, at), unit)))
      return parts(text.substr(0, at), unit);
  }
  return {std::string(text), {}};
}

std::vector<std::string> splitNames(std::string_view line, const TextDialect& dialect,
                                    std::size_t columns) {
  using Separator = TextDialect::Separator;
  const bool hasPairs =
      dialect.separator == Separator::CommaBlank || dialect.separator == Separator::CommaPair;
  std::vector<std::vector<std::string>> ways;
  if (dialect.isExact())
    ways.push_back(splitAt(line, hasPairs ? Separator::Comma : dialect.separator));
  const bool isSeparated = !ways.empty() && ways.front().size() > 1;
  if (line.find('\t') != std::string_view::npos) ways.push_back(splitAt(line, Separator::Tab));
  ways.push_back(splitAtWideBlanks(line));
  // Where the mark of the rows separates names, blanks stand within them.
  if (!isSeparated) ways.push_back(splitAtBlanks(line));
  for (const Separator separator : {Separator::Semicolon, Separator::Comma})
    ways.push_back(splitAt(line, separator));
  if (!isSeparated) ways.push_back(splitAt(line, Separator::Blanks));
  for (std::vector<std::string>& way : ways)
    if (way.size() == columns) return std::move(way);
  return {};
}

}  // namespace asperity
