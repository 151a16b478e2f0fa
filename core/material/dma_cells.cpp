#include "core/material/dma_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/column_units.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_dialect.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

/// Instruments write 9.9E+37 and the like where a value is out of range or missing (SCPI 1999,
/// volume 1, 7.2.1); no table has such a number.
void dropOverflows(TextBlock& block) {
  constexpr double kOverflow = 9.9e30;
  for (double& value : block.values)
    if (std::isgreaterequal(std::abs(value), kOverflow)) value = kNaN;
}

bool isComplex(const TextCell& cell) {
  return !std::isnan(cell.imaginary);
}

/// Makes two columns of one of complex numbers. A loss is above 0 whatever the sign convention is.
void separateParts(TextBlock& block, std::size_t column, const std::string& name,
                   std::vector<Message>& notes) {
  const std::vector<TextCell> cells = std::exchange(block.cells[column], {});
  std::vector<double> parts;
  bool areNegative = true;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const bool isLost = std::isnan(block.at(row, column));
    if (!isLost && !isComplex(cells[row]))
      throw InputError(name, block.label(column),
                       message("line {}: is not a complex number, as others of the column are",
                               block.lines[row]));
    parts.push_back(cells[row].imaginary);
    areNegative = areNegative && (isLost || std::isless(cells[row].imaginary, 0));
  }
  const std::string label = block.label(column);
  const std::string unit = block.columns[column].unit;
  if (areNegative) {
    for (double& part : parts) part = -part;
    notes.push_back(
        message("{}: the imaginary parts are below 0 in all rows, by a convention of signs; their "
                "magnitude is taken",
                Message::name(shortened(label))));
  }
  block.columns[column].name = label + " real part";
  block.append({label + " imaginary part", unit}, parts);
}

/// Makes a column one of texts, as its cells are written.
void keepAsTexts(TextBlock& block, std::size_t column) {
  block.columns[column].isText = true;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const std::string& text = block.cells[column][row].text;
    const double number = block.at(row, column);
    block.texts[column].push_back(text.empty() && !std::isnan(number) ? plain(number).text : text);
  }
}

/// Gives the cells of a column one unit. Returns false where they have several and the column may
/// be one of remarks.
bool haveOneUnit(TextBlock& block, std::size_t column, const std::string& name) {
  const TextColumn& written = block.columns[column];
  const bool isKnown = dmaColumn(written).quantity != DmaQuantity::None;
  try {
    unifyUnits(block, column, name);
    return isKnown || std::ranges::none_of(block.cells[column], isComplex);
  } catch (const InputError&) {
    if (isKnown) throw;
    return false;
  }
}

/// Returns the numbers in the names of all columns but the first; empty where one is no number.
std::vector<double> numbersInNames(const TextBlock& block, char decimal) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i < block.columns.size(); ++i) {
    double number = 0;
    if (!readTextNumber(block.columns[i].name, decimal, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

/// Returns the table of which each row is a column of this one: names stand in the first column,
/// and the line of names is a row, too, or numbers the points. Nothing where the table is another
/// one.
std::optional<TextBlock> transposed(const TextBlock& block, char decimal) {
  if (block.columns.size() < 3 || !block.columns.front().isText) return {};
  // "v;1 mm/s;2 mm/s"
  const bool hasUnits =
      std::ranges::any_of(block.columns.begin() + 1, block.columns.end(),
                          [](const TextColumn& one) { return !one.unit.empty(); });
  const std::vector<double> first = numbersInNames(block, decimal);
  if (first.empty() || hasUnits) return {};
  TextBlock made;
  made.header = block.header;
  made.rows = first.size();
  made.lines.assign(made.rows, block.lines.front());
  eraseLinesOfNames(made.header, block.columns);
  made.append({block.columns.front().name, block.columns.front().unit}, first);
  for (std::size_t row = 0; row < block.rows; ++row) {
    std::vector<double> numbers;
    for (std::size_t i = 1; i < block.columns.size(); ++i) numbers.push_back(block.at(row, i));
    made.append(parseColumnName(block.texts.front()[row]), numbers);
    for (std::size_t i = 1; i < block.columns.size(); ++i) {
      if (row >= block.cells[i].size() || block.cells[i][row].text.empty()) continue;
      made.cells.back().resize(made.rows);
      made.cells.back()[i - 1] = block.cells[i][row];
    }
  }
  return made;
}

/// Returns the lines beside a table with one row for each quantity that are such rows, too, but
/// have texts: "label;A;B;C".
std::string rowsOfTexts(const TextTable& table, const TextBlock& block) {
  std::string rows;
  for (const std::vector<TextEntry>& entries : {block.header, table.trailer})
    for (const TextEntry& entry : entries) {
      const auto fields = splitFields(entry.written, table.dialect.separator);
      const auto isText = [&table](std::string_view field) {
        return readField(field, table.dialect.decimal).kind == FieldKind::Text;
      };
      if (fields.size() == block.columns.size() && std::ranges::all_of(fields, isText))
        appendItem(rows, shortened(trimmedField(fields.front())));
    }
  return rows;
}

}  // namespace

void transposeRows(TextTable& table, const std::function<bool(const TextBlock&)>& isTable,
                   std::vector<Message>& notes) {
  for (TextBlock& block : table.blocks) {
    auto made = transposed(block, table.dialect.decimal);
    if (!made || !isTable(*made)) continue;
    notes.emplace_back("the table has one row for each quantity, and its columns are the points");
    if (const std::string rows = rowsOfTexts(table, block); !rows.empty())
      notes.push_back(message("not used: {}", Message::name(rows)));
    block = std::move(*made);
  }
}

void separateCells(TextTable& table, const std::string& name, std::vector<Message>& notes) {
  std::string withErrors;
  for (TextBlock& block : table.blocks) {
    dropOverflows(block);
    for (std::size_t i = 0, count = block.columns.size(); i < count; ++i) {
      if (!haveOneUnit(block, i, name)) keepAsTexts(block, i);
      if (block.columns[i].isText) {
        block.cells[i].clear();
        continue;
      }
      if (std::ranges::any_of(block.cells[i], isComplex)) separateParts(block, i, name, notes);
      const bool hasErrors = std::ranges::any_of(
          block.cells[i], [](const TextCell& cell) { return !std::isnan(cell.error); });
      if (hasErrors) {
        // "E' \u00B1 s" is no deviation alone.
        if (const auto sides = splitAtErrorSign(block.columns[i].name))
          block.columns[i].name = std::string(trimmedBlanks(sides->number));
        appendItem(withErrors, shortened(block.label(i)));
      }
      block.cells[i].clear();
    }
  }
  if (!withErrors.empty())
    notes.push_back(message("errors in cells, not read, because every point counts the same: {}",
                            Message::name(withErrors)));
}

}  // namespace asperity
