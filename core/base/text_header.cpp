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
using Separator = TextDialect::Separator;

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

/// What stands before a unit in several languages: "v in m/s", "hauteur en \u00B5m".
constexpr WordList kBeforeUnits("in en em");

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

/// Splits at single blanks; a unit, and a text in brackets or after a slash, stays with the name
/// before it.
std::vector<std::string> splitAtBlanks(std::string_view line) {
  const std::vector<std::string_view> words = splitWords(line);
  std::vector<std::string> fields;
  bool open = false, joined = false;
  for (const std::string_view word : words) {
    const bool isUnit = (word.front() == '(' || word.front() == '[' || word.front() == '{');
    const bool isStroke = word == "/" || isOneOf(word, kBeforeUnits);
    if (!fields.empty() && (open || joined || isUnit || isStroke))
      fields.back() += " " + std::string(word);
    else
      fields.emplace_back(trimmedField(word));
    open = (open || isUnit) && word.find_first_of(")]}") == std::string_view::npos;
    joined = isStroke;
  }
  return fields;
}

std::vector<std::string> splitAt(std::string_view line, Separator separator) {
  const std::vector<std::string_view> fields = splitFields(line, separator);
  std::vector<std::string> names;
  for (const std::string_view field : fields) names.emplace_back(trimmedField(field));
  while (names.size() > 1 && names.back().empty()) names.pop_back();
  return names;
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
    const std::vector<std::string_view> words = splitWords(line);
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

std::vector<std::string> splitNames(std::string_view line, const TextDialect& dialect,
                                    std::size_t columns) {
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

namespace {

using Fields = std::vector<std::string>;

/// Returns a field of a row of units without "in": "in mm".
std::string_view withoutIn(std::string_view field) {
  field = trimmedField(field);
  return field.starts_with("in ") ? trimmedBlanks(field.substr(3)) : field;
}

bool isUnitField(std::string_view field) {
  field = withoutIn(field);
  return field == "1" || isKnownUnit(field) ||
         withoutBrackets(field).size() != trimmedField(field).size();
}

}  // namespace

bool areUnits(const std::vector<std::string>& fields) {
  std::size_t sure = 0, others = 0;
  std::optional<double> factor;  // in front of units
  for (const std::string& field : fields) {
    if (trimmedField(field).empty()) continue;
    const std::string_view inner = withoutBrackets(withoutIn(field));
    const bool inBrackets = inner.size() != withoutIn(field).size();
    // "1 Hz" and "10 Hz" are conditions, and "[Data]" is the head of a section.
    if (const auto scaled = scaledUnit(inner); scaled && !inBrackets && !scaled->power.isWritten) {
      if (factor && *factor != scaled->power.value) return false;
      factor = scaled->power.value;
    }
    if (!isUnitField(field) ||
        isOneOf(lowerCase(inner), WordList("data values daten werte profile")))
      ++others;
    else if (inBrackets || inner == "m" || (inner.size() > 1 && !isOneOf(inner, "\u00B5 \u03BC")))
      ++sure;
  }
  return others == 0 ? sure > 0 : others == 1 && sure >= 2;
}

namespace {

/// Returns whether fields can be the names of columns: no numbers, except that all names but the
/// first may be numbers, such as temperatures or positions along x.
bool areNames(const Fields& fields, const TextDialect& dialect) {
  std::ptrdiff_t numbers = 0, texts = 0;
  for (const std::string& field : fields) {
    const FieldKind kind = readField(field, dialect.decimal).kind;
    numbers += kind == FieldKind::Number ? 1 : 0;
    texts += kind == FieldKind::Text ? 1 : 0;
  }
  const std::ptrdiff_t columns = std::ssize(fields);
  // In a row of units, 1 is that of a pure number.
  if (numbers > 0 && std::ranges::count(fields, "1") == numbers && areUnits(fields)) return true;
  return texts > 0 && (numbers == 0 || (columns > 2 && numbers + 1 >= columns));
}

/// Returns the names or units after "units:", separated by commas or semicolons whatever separates
/// the numbers: "units: x in mm, z in nm". Empty where the line is none of so many columns.
Fields fieldsOfUnits(std::string_view line, std::size_t columns) {
  const std::size_t end = keyEnd(line);
  if (columns < 2 || end == std::string_view::npos) return {};
  const std::string key = lowerCase(trimmedBlanks(line.substr(0, end)));
  if (key != "units" && key != "einheiten") return {};
  for (const Separator separator : {Separator::Semicolon, Separator::Comma})
    if (Fields fields = splitAt(line.substr(end + 1), separator); fields.size() == columns)
      return fields;
  return {};
}

/// The first field of a row of units that has none for the number of a row; a field that is written
/// has no blank alone.
constexpr std::string_view kNotWritten = " ";

/// Returns the fields of a line that may be names, units or comments of the columns; empty where it
/// is none of these. mayCountRows: the first column may number the rows.
Fields namesIn(std::string_view line, const TextDialect& dialect, std::size_t columns,
               bool mayCountRows) {
  const std::string_view text = withoutCommentMark(line, dialect);
  if (Fields fields = fieldsOfUnits(text, columns); areNames(fields, dialect)) return fields;
  // A separator in front makes an unnamed column, also a tab where blanks separate; so does one at
  // the end.
  Fields fields = splitNames(text, dialect, columns);
  // Nor has the number of a row a unit.
  if (fields.empty() && columns > 2 && mayCountRows && !dialect.isExact()) {
    fields = splitNames(text, dialect, columns - 1);
    if (areUnits(fields))
      fields.insert(fields.begin(), std::string(kNotWritten));
    else
      fields.clear();
  }
  if (fields.empty() && dialect.isExact()) {
    const std::vector<std::string_view> whole =
        splitFields(isComment(line) ? text : line, dialect.separator);
    if (whole.size() == columns)
      for (const std::string_view field : whole) fields.emplace_back(trimmedField(field));
  }
  // Row numbers, which some programs write in the first column, have no name.
  if (fields.empty() && columns > 2 && mayCountRows &&
      (dialect.isExact() || text.starts_with('"'))) {
    fields = splitNames(text, dialect, columns - 1);
    if (!fields.empty()) fields.insert(fields.begin(), std::string());
  }
  const std::vector<std::string_view> exact = splitFields(text, dialect.separator);
  const bool isEntry = keyEnd(text) != std::string_view::npos &&
                       !(dialect.isExact() && columns > 1 && exact.size() >= columns);
  if (isEntry || !areNames(fields, dialect)) return {};
  return fields;
}

/// Returns whether fields are names with known units: one in brackets, or one in each of several
/// fields. "Load 30 N" states a load.
bool haveUnits(const Fields& fields) {
  bool inBrackets = false, inEach = fields.size() > 1;
  for (const std::string& field : fields) {
    const bool hasUnit = isKnownUnit(parseColumnName(field).unit);
    inBrackets = inBrackets || (hasUnit && field.find_last_of(")]}") + 1 == field.size());
    inEach = inEach && hasUnit && !statesQuantity(field);
  }
  return inBrackets || inEach;
}

/// Returns whether a line is empty, has separators alone or is drawn: ";;;", "-----", "+---+---+".
bool isRule(std::string_view line) {
  return line.find_first_not_of("-=_+|;, \t") == line.npos;
}

/// Returns the fields of the lines above a block that may be names, units and comments of its
/// columns, the nearest line first. Beyond a line of another kind, such as a comment or a damaged
/// row, only units and names with units certainly belong to the columns.
std::vector<Fields> rowsAbove(const std::vector<TextLine>& above, const TextDialect& dialect,
                              std::size_t columns, bool mayCountRows) {
  constexpr std::size_t kMaxRows = 4, kMaxLinesAbove = 12;
  std::vector<Fields> rows;
  std::size_t looked = 0;
  bool isFar = false, isNamed = false, belowAreUnits = false;
  for (auto line = above.rbegin();
       line != above.rend() && rows.size() < kMaxRows && looked < kMaxLinesAbove; ++line) {
    if (isRule(withoutCommentMark(line->text, dialect))) continue;
    ++looked;
    Fields fields = namesIn(line->text, dialect, columns, mayCountRows);
    isFar = isFar || fields.empty();
    if (isFar && isNamed && !belowAreUnits) break;
    const bool belongs =
        !fields.empty() && (!isFar || belowAreUnits || areUnits(fields) || haveUnits(fields));
    belowAreUnits = belongs && areUnits(fields);
    if (!belongs) continue;
    isNamed = isNamed || !isComment(line->text) || haveUnits(fields);
    rows.push_back(std::move(fields));
  }
  return rows;
}

/// Returns the names of the columns where numbered lines list them, "Sig1<tab>Time (min)" or
/// "# Column 2: z (um)"; empty where there is no such list of so many columns.
Fields listedNames(const std::vector<TextLine>& above, const TextDialect& dialect,
                   std::size_t columns) {
  constexpr WordList kOfColumns("sig signal column col spalte channel kanal colonne columna");
  Fields names, complete;
  std::size_t last = 0;
  for (const TextLine& line : above) {
    const TextEntry entry = parseEntry(line, dialect);
    const std::size_t digits = entry.key.find_last_not_of("0123456789") + 1;
    const std::string word = lowerCase(trimmedBlanks(entry.key.substr(0, digits)));
    std::size_t number = 0;
    if (entry.value.empty() || beginsAsNumber(entry.value) || !isOneOf(word, kOfColumns) ||
        !readNumber(std::string_view(entry.key).substr(digits), number))
      continue;
    const bool goesOn = !names.empty() && number == last + 1;
    if (!goesOn) names.clear();
    if (goesOn || number <= 1) names.push_back(entry.value);
    last = number;
    complete = names.size() == columns ? names : Fields{};
  }
  return complete;
}

}  // namespace

std::vector<TextColumn> namedColumns(const std::vector<TextLine>& above, const TextDialect& dialect,
                                     const std::vector<Field>& first) {
  const std::size_t columns = first.size();
  std::vector<TextColumn> named(columns);
  const bool mayCountRows =
      first[0].kind == FieldKind::Number && (first[0].value == 0 || first[0].value == 1);
  const auto rows = rowsAbove(above, dialect, columns, mayCountRows);
  auto units = std::ranges::find_if(rows, areUnits);
  // The column without a unit may be another one.
  if (units != rows.end() && units + 1 != rows.end() && units->front() == kNotWritten &&
      !isOneOf(lowerCase((units + 1)->front()),
               WordList("# n n. no no. nr nr. i id idx index pt point punkt messpunkt row zeile")))
    units = rows.end();
  // Names are above their units; without a row of units, they contain some, or are directly above
  // the numbers.
  const Fields* names = nullptr;
  const Fields listed = listedNames(above, dialect, columns);
  if (!listed.empty()) {
    names = &listed;
    units = rows.end();
  } else if (units == rows.end()) {
    const auto found = std::ranges::find_if(rows, haveUnits);
    if (!rows.empty()) names = found != rows.end() ? &*found : &rows.front();
  } else if (units + 1 != rows.end()) {
    names = &*(units + 1);
  } else if (units != rows.begin()) {
    names = &*(units - 1);
  }
  for (std::size_t i = 0; i < columns; ++i) {
    if (names != nullptr) {
      const TextColumn name = parseColumnName((*names)[i]);
      named[i].name = name.name;
      named[i].unit = name.unit;
    }
    if (units != rows.end())
      if (const std::string_view unit = withoutBrackets(withoutIn((*units)[i]));
          !unit.empty() && isUnitField((*units)[i]))
        named[i].unit = unit;
  }
  return named;
}

}  // namespace asperity
