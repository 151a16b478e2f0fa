// The lines `key: value` of a text table, in all their forms.
#include <algorithm>

#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_units.h"

namespace asperity {

std::string_view withoutRemarkMark(std::string_view line) {
  const std::size_t blank = std::min(line.find(' '), line.size());
  const std::string_view rest = trimmedBlanks(line.substr(blank));
  const std::string word = lowerCase(line.substr(0, blank));
  // Between two marks stands a quoted name, and among units "--" is that of a pure number.
  const bool isQuote = word == "'" && rest.find('\'') == std::string_view::npos;
  const bool isDash = word == "--" && !rest.starts_with('-') &&
                      !isKnownUnit(rest.substr(0, rest.find_first_of(" \t")));
  return word == "rem" || isDash || isQuote ? rest : line;
}

std::string_view withoutCommentMark(std::string_view line, const TextDialect& dialect) {
  line = trimmedBlanks(line);
  const bool orSemicolon = dialect.separator != TextDialect::Separator::Semicolon;
  while (line.starts_with('#') || line.starts_with('%') || line.starts_with('!') ||
         (orSemicolon && line.starts_with(';')))
    line = trimmedBlanks(line.substr(1));
  if (line.starts_with("//")) line = trimmedBlanks(line.substr(2));
  return withoutRemarkMark(line);
}

std::size_t keyEnd(std::string_view line) {
  constexpr std::string_view kWideColon = "\uFF1A";
  const std::size_t at = std::min(line.find_first_of(":="), line.find(kWideColon));
  return at == 0 ? std::string_view::npos : at;
}

bool statesQuantity(std::string_view text) {
  const std::size_t number = text.find_first_of("0123456789");
  if (number == 0 || number == std::string_view::npos || text[number - 1] != ' ') return false;
  const auto quantity = parseQuantity(text.substr(number));
  return quantity && !quantity->unit.empty() && isKnownUnit(quantity->unit);
}

namespace {

/// Returns whether a comma is the decimal mark of a number after a word: "cellsize 2,5".
bool isDecimalMark(std::string_view line, std::size_t comma) {
  const std::size_t begin = line.find_last_of(" \t", comma);
  const std::size_t end = std::min(line.find_first_of(" \t", comma), line.size());
  double number = 0;
  return begin != std::string_view::npos &&
         readTextNumber(line.substr(begin + 1, end - begin - 1), ',', number);
}

/// Returns whether the fields after a comma are a value in a file whose numbers have no separator:
/// a number or a unit.
bool statesAfterComma(std::string_view line, std::size_t comma, const TextDialect& dialect) {
  if (dialect.isExact() || comma == std::string_view::npos || line.find(", ") != line.npos ||
      isDecimalMark(line, comma))
    return false;
  const std::vector<std::string_view> fields = splitFields(line, TextDialect::Separator::Comma);
  // A comma between quotes separates nothing.
  return (fields.size() == 2 || fields.size() == 3) && !beginsAsNumber(trimmedField(fields[0])) &&
         (beginsAsNumber(trimmedField(fields[1])) || isKnownUnit(trimmedField(fields[1])));
}

}  // namespace

bool isUnitInFront(std::string_view key, std::string_view unit) {
  if (!isKnownUnit(unit)) return false;
  const std::string_view bare = withoutBrackets(unit);
  if ((bare.size() > 1 && bare != "PA") || bare == "%" || bare.size() != trimmedField(unit).size())
    return true;
  // "Sample;N;50" has a name, "Load;N;50" a unit.
  const std::string word = lowerCase(trimmedField(key));
  const std::string_view last = std::string_view(word).substr(word.find_last_of(" \t") + 1);
  if (bare == "N") return isOneOf(last, "load force last kraft normalkraft");
  if (bare == "K" || bare == "C") return isOneOf(last, "temperature temperatur");
  if (bare == "s") return isOneOf(last, "time zeit tau \u03C4 t");
  if (bare == "m") return isOneOf(last, "x y z position distance weg height h\u00F6he");
  return false;
}

TextEntry parseEntry(const TextLine& kept, const TextDialect& dialect) {
  std::string_view line = withoutCommentMark(kept.text, dialect);
  // "\Scan Size: 120 120 ~m" in quotes, as NanoScope writes it
  if (const std::string_view bare =
          trimmedField(line.substr(0, line.find_last_not_of(";, \t") + 1));
      line.find_first_of("\"'") == 0 && bare.find('"') == bare.npos)
    line = bare;
  TextEntry entry{{}, std::string(line), kept.number};
  entry.written = line.substr(0, line.find_last_not_of(";, \t") + 1);
  replaceAll(entry.written, "\t", " ");
  const std::vector<std::string_view> fields = splitFields(line, dialect.separator);
  const auto setKey = [&entry](std::string_view key, std::string_view value) {
    key = trimmedField(key);
    while (key.ends_with(':') || key.ends_with('='))
      key = trimmedBlanks(key.substr(0, key.size() - 1));
    if (key.empty()) return;
    entry.key = key;
    entry.value = trimmedField(value.substr(0, value.find_last_not_of(";, \t") + 1));
  };
  const std::size_t end = keyEnd(line);
  const std::size_t tab = line.find('\t');
  const bool isExact = dialect.isExact() && fields.size() > 1;
  if (end == std::string_view::npos &&
      statesQuantity(trimmedField(line.substr(0, line.find_first_of(",;\t"))))) {
    // "Load 30 N; T 23 C" has statements, but no key.
    return entry;
  }
  // "Master curve, Tref = 20 \u00B0C" has statements, too.
  if (isExact && end != std::string_view::npos && end >= fields.front().size() && line[end] == '=')
    return entry;
  if (isExact && end >= fields.front().size()) {
    // "Width;10;\u00B5m"
    std::vector<std::string_view> parts;
    for (std::size_t i = 1; i < fields.size(); ++i)
      if (const auto part = trimmedField(fields[i]); !part.empty()) parts.push_back(part);
    // "Width;\u00B5m;10"
    if (parts.size() == 2 && isUnitInFront(fields.front(), parts[0]) && beginsAsNumber(parts[1]))
      parts = {parts[1], withoutBrackets(parts[0])};
    std::string value;
    for (const std::string_view part : parts) appendItem(value, part, " ");
    setKey(fields.front(), value);
  } else if (end != std::string_view::npos) {
    constexpr std::size_t kWide = 3;  // bytes of a full-width colon
    setKey(line.substr(0, end),
           line.substr(end + (line[end] == ':' || line[end] == '=' ? 1 : kWide)));
  } else if (const std::size_t semicolon = line.find(';');
             semicolon != std::string_view::npos && semicolon > 0) {
    setKey(line.substr(0, semicolon), line.substr(semicolon + 1));
  } else if (tab != std::string_view::npos && tab > 0) {
    setKey(line.substr(0, tab), line.substr(tab + 1));
  } else if (const std::size_t comma = line.find(','); statesAfterComma(line, comma, dialect)) {
    // "Sampling pitch","0.5um"; Spacing,0.0005,mm
    std::string value(line.substr(comma + 1));
    replaceAll(value, ",", " ");
    replaceAll(value, "\"", "");
    setKey(line.substr(0, comma), value);
  } else if ((fields.size() == 2 || fields.size() == 3) &&
             readField(fields[0], dialect.decimal).kind == FieldKind::Text &&
             readField(fields[1], dialect.decimal).kind == FieldKind::Number) {
    setKey(fields[0], line.substr(static_cast<std::size_t>(fields[1].data() - line.data())));
  }
  return entry;
}

}  // namespace asperity
