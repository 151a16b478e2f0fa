#include "core/base/text_names.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "core/base/text_number.h"
#include "core/base/text_units.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Returns whether a unit that is also a letter fits the name: behind "_" or a blank such letters
/// are units only of certain quantities.
bool suitsLetter(std::string_view name, std::string_view unit) {
  const char first = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  // "mu_min" is a smallest value, "time_min" a time.
  if (lowerCase(unit) == "min") return first == 't' || first == 'z' || first == 'd';
  if (unit.size() > 1) return lowerCase(unit) != "in" || name.size() <= 2;
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

/// F is a unit of temperatures alone; elsewhere it is a letter of a force or a frequency.
bool isFahrenheit(std::string_view name, std::string_view unit) {
  if (trimmedBlanks(unit) != "F") return false;
  const std::string word = lowerCase(trimmedField(name));
  return word == "t" || word.starts_with("t_") || word.find("temp") != std::string::npos;
}

ColumnName parts(std::string_view name, std::string_view unit) {
  while (!name.empty() &&
         (name.back() == '_' || name.back() == ',' || name.back() == ' ' || name.back() == '/'))
    name.remove_suffix(1);
  if (name.ends_with(" in")) name.remove_suffix(3);  // "v in m/s"
  return {std::string(trimmedField(name)), std::string(trimmedBlanks(unit))};
}

/// Splits at tabs and at runs of at least two blanks.
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

/// Splits at single blanks; a unit, and a text in brackets or behind a stroke, stays with the name
/// before it.
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
    if (isKnownUnit(unit) || isFahrenheit(text.substr(0, at), unit) ||
        (text[at] == '[' && isLast && at > 0 && !trimmedBlanks(unit).empty())) {
      // Words behind the unit belong to the name: "G' (MPa) std" is no modulus.
      ColumnName found = parts(text.substr(0, at), unit);
      const std::string_view rest = trimmedBlanks(text.substr(end + 1));
      const bool hasWords = std::ranges::any_of(rest, [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0;
      });
      if (hasWords) found.name += (found.name.empty() ? "" : " ") + std::string(rest);
      return found;
    }
  }

  // "v_m/s", "v m/s".
  if (const std::size_t at = text.find_last_of("_ ");
      at != std::string_view::npos && at > 0 && text.find('/', at) != std::string_view::npos &&
      isUnitWord(text.substr(at + 1)))
    return parts(text.substr(0, at), text.substr(at + 1));

  // The unit may be behind a stroke, which may also be part of it: "v / m/s".
  for (std::size_t at = 0; (at = text.find('/', at)) != std::string_view::npos; ++at)
    if (at > 0 &&
        (isKnownUnit(text.substr(at + 1)) || isFahrenheit(text.substr(0, at), text.substr(at + 1))))
      return parts(text.substr(0, at), text.substr(at + 1));

  // Behind a comma, " in ", a blank or "_".
  for (const std::string_view between : {", "sv, ","sv, " in "sv, " "sv, "_"sv}) {
    const std::size_t at = text.rfind(between);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = text.substr(at + between.size());
    const bool isLoose = between == " " || between == "_";
    if (isFahrenheit(text.substr(0, at), unit)) return parts(text.substr(0, at), unit);
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
  // Where the separator of the rows separates the names as well, blanks are part of the names.
  if (!isSeparated) ways.push_back(splitAtBlanks(line));
  for (const Separator separator : {Separator::Semicolon, Separator::Comma})
    ways.push_back(splitAt(line, separator));
  // A unit in brackets is no name of its own among others.
  if (std::vector<std::string> words = splitAt(line, Separator::Blanks); !isSeparated) {
    const auto isBracketed = [](const std::string& word) {
      return word.starts_with('(') || word.starts_with('[');
    };
    const auto units = std::ranges::count_if(words, isBracketed);
    if (units == 0 || units == std::ssize(words)) ways.push_back(std::move(words));
  }
  for (std::vector<std::string>& way : ways)
    if (way.size() == columns) return std::move(way);
  return {};
}

}  // namespace asperity
