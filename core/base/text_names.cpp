// Names and units of columns in the lines above a block.
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"

namespace asperity {

bool isRule(std::string_view line) {
  return line.find_first_not_of("-=_+*|;, \t") == line.npos;
}

namespace {

using Separator = TextDialect::Separator;

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
/// before it. joinsPhrases: whether a text after "of" or "at" does so, too.
std::vector<std::string> splitAtBlanks(std::string_view line, bool joinsPhrases) {
  constexpr WordList kTemperatures("t temp temp. temperature temperatur t/k t/\u00B0c t_k t_c");
  const std::vector<std::string_view> words = splitWords(line);
  std::vector<std::string> fields;
  bool open = false, joined = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const bool isUnit = (word.front() == '(' || word.front() == '[' || word.front() == '{');
    // Shift factors may be called "at", beside their temperatures.
    const bool isName = word == "at" && (fields.empty() || fields.back().ends_with(')') ||
                                         fields.back().ends_with(']') ||
                                         isOneOf(lowerCase(fields.back()), kTemperatures));
    const bool isPhrase =
        joinsPhrases && i + 1 < words.size() && isOneOf(word, "at bei of") && !isName;
    const bool isStroke = word == "/" || isPhrase || isOneOf(word, kBeforeUnits);
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
  if (!isSeparated) {
    ways.push_back(splitAtBlanks(line, true));
    // "COF at load (N)" is no three names.
    if (!dialect.isExact() || ways.back().size() > 1) ways.push_back(splitAtBlanks(line, false));
  }
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
  // "Speed 0.25 mm/s" above one column is a statement, and "Profile 1 (um)" a name.
  if (columns == 1 && statesQuantity(text) && text.find_first_of("([{") == text.npos) return {};
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
  // Behind "v;mu" in "1;0.5;ok" the column without a name is the last one.
  constexpr WordList kOfFlags(
      "status state quality valid validity flag ok check result remark comment note qualit\u00E4t "
      "zustand g\u00FCltig bewertung bemerkung kommentar");
  if (names && first.back().kind == FieldKind::Flag && names->front().empty() &&
      !isOneOf(lowerCase(names->back()), kOfFlags))
    names = nullptr;
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
