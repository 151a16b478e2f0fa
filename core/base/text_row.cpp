#include "core/base/text_row.h"

#include <algorithm>
#include <utility>

namespace asperity {

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
    splitFields(line, dialect_.separator, fields);
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
