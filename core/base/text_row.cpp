#include "core/base/text_row.h"

#include <algorithm>
#include <utility>

#include "core/base/text_header.h"

namespace asperity {
namespace {

/// Returns whether a line of a quoted field may be one of a name: "mu" and, below such a line,
/// "5 \u00B0C", but neither a number alone nor a statement such as "Width: 10 mm".
bool isLineOfName(std::string_view line, bool isFirst) {
  if (trimmedBlanks(line).empty()) return true;
  if (readField(line, '.').kind != FieldKind::Text || keyEnd(line) != std::string_view::npos)
    return false;
  return !isFirst || (!beginsAsNumber(line) && !statesQuantity(line));
}

/// Returns the length of a quoted field with line breaks at the beginning of a text; 0 where there
/// is none. It has no signs that separate fields, so that no rows are joined.
std::size_t lengthOfBrokenField(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  bool isBroken = false;
  std::size_t begin = 1;  // of the line
  for (std::size_t i = 1; i < std::min(text.size(), kLongest); ++i) {
    const std::string_view rest = text.substr(i + 1);
    if (std::string_view(";,|\t").find(text[i]) != std::string_view::npos) return 0;
    const bool isEnd = text[i] == '\n' || (text[i] == '"' && !rest.starts_with('"'));
    if (isEnd && (isBroken || text[i] == '\n')) {
      if (!isLineOfName(trimmedField(text.substr(begin, i - begin)), !isBroken)) return 0;
      begin = i + 1;
    }
    isBroken = isBroken || text[i] == '\n';
    if (text[i] != '"') continue;
    if (!rest.starts_with('"'))
      return isBroken && (rest.empty() || rest.find_first_of(";,|\t\r\n ") == 0) ? i + 1 : 0;
    ++i;  // two of them are one of the text
  }
  return 0;
}

/// Returns whether a quoted field at the beginning of a text ends in its line.
bool endsInLine(std::string_view text) {
  return text.substr(1, text.find('\n') - 1).find('"') != std::string_view::npos;
}

}  // namespace

JoinedText::JoinedText(std::string_view written) : text(written) {
  std::size_t kept = 0;
  for (std::size_t at = written.find('"'); at != written.npos; at = written.find('"', at + 1)) {
    if (at > 0 && std::string_view(";,|\t\n").find(written[at - 1]) == std::string_view::npos)
      continue;
    const std::string_view field = written.substr(at);
    const std::size_t length = lengthOfBrokenField(field);
    const bool isInJoinedLine =
        kept > 0 && written.substr(kept, at - kept).find('\n') == written.npos;
    // Of a line of names all fields are joined, or none.
    if (length == 0 && isInJoinedLine && !endsInLine(field)) {
      breaks.clear();
      return;
    }
    if (length == 0) continue;
    joined += written.substr(kept, at - kept);
    kept = at + length;
    for (const char letter : field.substr(0, length)) {
      if (letter == '\r') continue;
      if (letter == '\n') breaks.push_back(joined.size());
      joined += letter == '\n' ? ' ' : letter;
    }
    at = kept - 1;
  }
  if (kept == 0) return;
  joined += written.substr(kept);
  text = joined;
}

std::size_t TextRow::count(FieldKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(values, kind, &Field::kind));
}

bool TextRow::areNumbers(std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i)
    if (!is(i, FieldKind::Number)) return false;
  return true;
}

void TextRow::removeLast() {
  fields.pop_back();
  values.pop_back();
  if (!cells.empty()) cells.pop_back();
}

std::vector<std::string_view> RowReader::split(std::string_view line) const {
  std::vector<std::string_view> fields;
  if (options_.keepsTexts)
    splitTextRow(line, dialect_, fields);
  else
    splitRow(line, dialect_, fields);
  if (options_.readsCells && !dialect_.isExact()) joinCells(fields);
  return fields;
}

TextRow RowReader::read(std::string_view line) const {
  TextRow row{split(line)};
  row.values.reserve(row.size());
  for (const std::string_view field : row.fields) {
    TextCell rest;
    row.values.push_back(readField(field, rest));
    if (rest.text.empty()) continue;
    row.cells.resize(row.size());
    row.cells[row.values.size() - 1] = std::move(rest);
  }
  return row;
}

Field RowReader::readField(std::string_view text, TextCell& rest) const {
  const Field field = asperity::readField(text, dialect_.decimal);
  if (field.kind != FieldKind::Text) return field;
  if (options_.datesAreMissing && isDateOrTime(text)) return {FieldKind::Missing, kNaN};
  if (!options_.readsCells) return field;
  auto cell = readCell(text, dialect_.decimal);
  if (!cell) return field;
  rest = std::move(cell->rest);
  return {FieldKind::Number, cell->number};
}

}  // namespace asperity
