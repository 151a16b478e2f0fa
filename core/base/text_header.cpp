#include "core/base/text_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Returns whether a unit that is also a letter fits the name: after "_" or a blank such letters
/// are units only of certain quantities.
bool suitsLetter(std::string_view name, std::string_view unit) {
  const char first = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  // "mu_min" is a smallest value, "time_min" a time.
  if (lowerCase(unit) == "min") return first == 't' || first == 'z' || first == 'd';
  // "Reibwert \u00B5" names the friction, and "z \u00B5" a height.
  if (unit.size() > 1) return !isOneOf(lowerCase(unit), "in \u00B5 \u03BC") || name.size() <= 2;
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

/// Makes a column without what stands between a name and its unit.
TextColumn makeColumn(std::string_view name, std::string_view unit) {
  while (!name.empty() &&
         (name.back() == '_' || name.back() == ',' || name.back() == ' ' || name.back() == '/'))
    name.remove_suffix(1);
  if (const std::size_t at = name.find_last_of(" _");
      at != name.npos && isOneOf(name.substr(at + 1), kBeforeUnits))
    name = name.substr(0, at);
  return {std::string(trimmedField(name)), std::string(trimmedBlanks(unit))};
}

/// Names without special letters, as data frames have them, spell a quotient: "v_mm_s", "v_mm_s-1"
/// and "v_mm_per_s" are in mm/s, "p_N_mm2" in N/mm2, "eta_Pa_s" in Pa s. Empty where a name has
/// none.
std::optional<TextColumn> splitSpelledUnit(std::string_view text) {
  // "tau in min" is no speed.
  if (const std::size_t at = text.find_last_of(' '); at != text.npos)
    if (const std::size_t before = text.substr(0, at).find_last_of(' '); before != text.npos)
      if (isOneOf(text.substr(before + 1, at - before - 1), kBeforeUnits)) return {};
  const auto takeWord = [&text] {
    const std::size_t at = text.find_last_of("_ ");
    if (at == text.npos) return std::string_view();
    const std::string_view word = text.substr(at + 1);
    text = text.substr(0, at);
    return word;
  };
  const std::string_view divisor = takeWord();
  std::string_view dividend = takeWord();
  if (dividend == "per") dividend = takeWord();
  if (dividend.empty() || text.empty()) return {};
  const bool isViscosity = lowerCase(dividend).ends_with("pa");
  const bool isInverse = divisor.ends_with("-1");
  const std::string unit =
      fmt::format("{}{}{}", dividend, isViscosity || isInverse ? " " : "/", divisor);
  if (!isUnitWord(unit)) return {};
  return makeColumn(text, unit);
}

/// Makes a column of a name with a unit after a slash or a space. A power of ten in front of the
/// unit belongs to the unit: "v / 10^-3 m/s".
TextColumn makeScaledColumn(std::string_view name, std::string_view unit) {
  const std::string_view front = trimmedBlanks(name);
  const std::size_t at = front.find_last_of(" /_");
  const std::size_t begin = at == front.npos ? 0 : at + 1;
  const std::string_view word = front.substr(begin);
  if (begin == 0 || word.empty() || !isDigit(word.front()) || !isWrittenPower(word))
    return makeColumn(name, unit);
  return makeColumn(front.substr(0, begin), fmt::format("{} {}", word, trimmedBlanks(unit)));
}

}  // namespace

TextColumn parseColumnName(std::string_view text) {
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
      // Words after the unit belong to the name: "G' (MPa) std" is no modulus.
      TextColumn found = makeColumn(text.substr(0, at), unit);
      const std::string_view rest = trimmedBlanks(text.substr(end + 1));
      const bool hasWords = std::ranges::any_of(rest, [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0;
      });
      if (hasWords) appendItem(found.name, rest, " ");
      return found;
    }
  }

  // "v_m/s", "v m/s", "v,m/s".
  if (const std::size_t at = text.find_last_of("_ ,");
      at != std::string_view::npos && at > 0 && text.find('/', at) != std::string_view::npos &&
      isUnitWord(text.substr(at + 1)))
    return makeScaledColumn(text.substr(0, at), text.substr(at + 1));

  // The unit may be after a slash, which may also be part of it: "v / m/s".
  for (std::size_t at = 0; (at = text.find('/', at)) != std::string_view::npos; ++at)
    if (at > 0 &&
        (isKnownUnit(text.substr(at + 1)) || isFahrenheit(text.substr(0, at), text.substr(at + 1))))
      return makeColumn(text.substr(0, at), text.substr(at + 1));

  if (auto spelled = splitSpelledUnit(text)) return std::move(*spelled);

  // After a comma, " in " in one of several languages, a blank or "_".
  for (const std::string_view between :
       {", "sv, ","sv, " in "sv, " en "sv, " em "sv, " "sv, "_"sv}) {
    const std::size_t at = text.rfind(between);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = text.substr(at + between.size());
    const bool isLoose = between == " " || between == "_";
    if (isFahrenheit(text.substr(0, at), unit)) return makeColumn(text.substr(0, at), unit);
    if (isUnitWord(unit) && (!isLoose || suitsLetter(text.substr(0, at), unit)))
      return makeScaledColumn(text.substr(0, at), unit);
  }
  return {std::string(text), {}};
}

TextColumn quantityOfHeads(TextColumn& corner, const std::vector<TextEntry>& header,
                           const std::function<bool(const TextColumn&)>& isQuantity) {
  const std::string name = corner.name;
  if (const std::size_t stroke = name.find('\\'); stroke != name.npos) {
    TextColumn rows = parseColumnName(name.substr(0, stroke)),
               heads = parseColumnName(name.substr(stroke + 1));
    if (heads.unit.empty() && isQuantity({heads.name, corner.unit}))
      heads.unit = corner.unit;
    else if (rows.unit.empty())
      rows.unit = corner.unit;
    corner = std::move(rows);
    return isQuantity(heads) ? heads : TextColumn{};
  }
  for (const TextEntry& entry : header) {
    const std::string_view line = withoutEnd(entry.written, ":;, ");
    if (line.find_first_of("0123456789") != line.npos) continue;
    // "COF at load (N)" names friction in front of it.
    std::string fields(line);
    std::ranges::replace_if(
        fields, [](char letter) { return letter == ';' || letter == '|'; }, ' ');
    const std::vector<std::string_view> words = splitWords(fields);
    std::string last;
    for (auto word = words.rbegin(); word != words.rend(); ++word) {
      last = std::string(*word) + (last.empty() ? "" : " ") + last;
      const std::size_t begin = std::min(last.find_first_not_of(";, "), last.size());
      if (const TextColumn heads = parseColumnName(last.substr(begin)); isQuantity(heads))
        return heads;
    }
  }
  return {};
}

bool isLineOfNames(const TextEntry& entry, const std::vector<TextColumn>& columns) {
  std::string names, withUnits, inUnits;  // "x", "x (mm)", "x in mm"
  for (const TextColumn& column : columns) {
    names += column.name;
    withUnits += column.name + column.unit;
    inUnits += column.name + (column.unit.empty() ? "" : "in" + column.unit);
  }
  // The letters are sorted, because a unit may stand within the name: "v (mm/s) sliding".
  const auto letters = [](const std::string& text) {
    std::string word = plainWord(text);
    std::ranges::sort(word);
    return word;
  };
  const std::string line = letters(entry.written);
  return line == letters(names) || line == letters(withUnits) || line == letters(inUnits);
}

void eraseLinesOfNames(std::vector<TextEntry>& header, const std::vector<TextColumn>& columns) {
  std::erase_if(header,
                [&columns](const TextEntry& entry) { return isLineOfNames(entry, columns); });
}

}  // namespace asperity
