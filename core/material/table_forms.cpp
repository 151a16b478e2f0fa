#include "core/material/table_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/column_units.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_dialect.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

using enum DmaQuantity;

// ---- Cells --------------------------------------------------------------------------------------

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
  const bool isKnown = dmaColumn(written).quantity != None;
  try {
    unifyUnits(block, column, name);
    return isKnown || std::ranges::none_of(block.cells[column], isComplex);
  } catch (const InputError&) {
    if (isKnown) throw;
    return false;
  }
}

// ---- One row for each quantity ------------------------------------------------------------------

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

// ---- Matrices -----------------------------------------------------------------------------------

/// A matrix of one quantity.
struct Matrix {
  TextColumn value{};                 // "G'", MPa
  TextColumn first{};                 // of the rows
  std::vector<std::string> states{};  // of the columns, "20 \u00B0C"
  bool isAssumed = false;             // whether the unit of the states is
};

/// Returns whether a column has a temperature or a frequency with its unit.
bool isTemperatureOrFrequency(const TextColumn& column) {
  const DmaQuantity quantity = dmaColumn(column).quantity;
  return !column.unit.empty() && ((quantity == Temperature && temperatureUnit(column.unit)) ||
                                  (quantity == Frequency && frequencyUnit(column.unit, false)));
}

/// Returns the states above all columns but the first, each "20 \u00B0C" or "10 Hz"; empty where
/// one is none. of: what the columns have, where a number has no unit.
std::vector<std::string> statesOf(const TextBlock& block, DmaQuantity ofRows, const TextColumn& of,
                                  bool& isAssumed) {
  const DmaQuantity wanted = ofRows == Frequency ? Temperature : Frequency;
  std::vector<std::string> states;
  std::vector<double> bare;
  for (std::size_t i = 1; i < block.columns.size(); ++i) {
    const TextColumn& column = block.columns[i];
    if (column.isText) return {};
    const std::string text = column.name + " " + column.unit;
    const auto temperature = firstTemperature(text);
    const auto frequency = firstFrequency(text);
    const auto number = parseQuantity(column.name);
    if (wanted == Temperature && temperature) {
      states.push_back(text.substr(temperature->begin, temperature->end - temperature->begin));
    } else if (wanted == Frequency && frequency) {
      states.push_back(text.substr(frequency->begin, frequency->end - frequency->begin));
    } else if (column.unit.empty() && number && number->unit.empty() && !number->isGrouped) {
      bare.push_back(number->number);
      continue;
    } else {
      return {};
    }
    // "G' 20 \u00B0C" names its modulus, too.
    const std::string name = text.substr(0, text.find_first_of("-0123456789"));
    if (!compactName(name).empty() && dmaColumn(keyBefore(name), {}).quantity != wanted) return {};
  }
  if (bare.empty()) return states;
  const bool isStated = dmaColumn(of).quantity == wanted && !of.unit.empty();
  if (!states.empty() || (!isStated && wanted == Frequency)) return {};
  isAssumed = !isStated;
  const std::string unit = isStated ? of.unit : assumedTemperatureUnit(std::ranges::min(bare));
  for (const double number : bare) states.push_back(plain(number).text + " " + unit);
  return states;
}

/// Returns the modulus that a line above a matrix names, the nearest one; without a name where none
/// does.
TextColumn valueOf(const TextBlock& block) {
  for (auto entry = block.header.rbegin(); entry != block.header.rend(); ++entry) {
    const TextColumn column = parseColumnName(withoutEnd(trimmedBlanks(entry->written), ":;, "));
    if (isMeasured(dmaColumn(column).quantity)) return column;
  }
  return {};
}

std::optional<Matrix> matrixOf(const TextBlock& block) {
  if (block.columns.size() < 3 || block.columns.front().isText) return {};
  Matrix matrix;
  matrix.first = block.columns.front();
  const TextColumn of = quantityOfHeads(matrix.first, block.header, isTemperatureOrFrequency);
  const DmaQuantity ofRows = dmaColumn(matrix.first).quantity;
  if (ofRows != Frequency && ofRows != Temperature) return {};
  matrix.value = valueOf(block);
  if (matrix.value.name.empty()) return {};
  matrix.states = statesOf(block, ofRows, of, matrix.isAssumed);
  if (matrix.states.empty()) return {};
  return matrix;
}

/// Returns the moduli that a line above the names of a table gives to groups of its columns, "G'
/// (MPa);;;G'' (MPa);;"; empty where there is no such line.
std::vector<TextColumn> valuesOfGroups(const TextBlock& block) {
  for (auto entry = block.header.rbegin(); entry != block.header.rend(); ++entry) {
    std::string line = joinEntry(*entry, ";");
    std::ranges::replace(line, '\t', ';');
    if (line.find(';') == line.npos) std::ranges::replace(line, ',', ';');
    std::vector<TextColumn> values;
    for (const std::string_view field : splitText(line, ";"))
      if (!trimmedBlanks(field).empty()) values.push_back(parseColumnName(field));
    const bool areMeasured = std::ranges::all_of(
        values, [](const TextColumn& value) { return isMeasured(dmaColumn(value).quantity); });
    if (values.size() > 1 && areMeasured) return values;
  }
  return {};
}

/// Gives the columns of matrices side by side, each below the name of its modulus, that name.
bool nameGroups(TextBlock& block) {
  const std::vector<TextColumn> values = valuesOfGroups(block);
  if (values.empty() || block.columns.front().isText ||
      (block.columns.size() - 1) % values.size() != 0)
    return false;
  TextColumn first = block.columns.front();
  const TextColumn of = quantityOfHeads(first, block.header, isTemperatureOrFrequency);
  bool isAssumed = false;
  const std::vector<std::string> states = statesOf(block, dmaColumn(first).quantity, of, isAssumed);
  const std::size_t count = (block.columns.size() - 1) / values.size();
  if (states.empty() || isAssumed || count < 2) return false;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] != states[i % count]) return false;
  block.columns.front() = std::move(first);
  for (std::size_t i = 0; i < states.size(); ++i)
    block.columns[i + 1] = {values[i / count].name + " " + states[i], values[i / count].unit};
  return true;
}

/// Returns the frequencies (Hz) or temperatures (K) of the rows of a matrix; NaN where their unit
/// is not known.
std::vector<double> rowsInSi(const TextColumn& first, const TextBlock& block) {
  const DmaColumn meaning = dmaColumn(first);
  const auto kelvins = temperatureUnit(first.unit);
  const auto hertz = frequencyUnit(first.unit, meaning.isAngular);
  std::vector<double> rows = block.column(0);
  for (double& row : rows)
    if (meaning.quantity == Temperature)
      row = kelvins ? kelvins->toSi(row) : kNaN;
    else
      row *= hertz.value_or(kNaN);
  return rows;
}

bool haveSameRows(const TextColumn& first, const TextBlock& block, const TextColumn& otherFirst,
                  const TextBlock& other) {
  constexpr double kRounding = 1e-9;
  if (first.name == otherFirst.name && first.unit == otherFirst.unit)
    return block.column(0) == other.column(0);
  return dmaColumn(first).quantity == dmaColumn(otherFirst).quantity &&
         std::ranges::equal(rowsInSi(first, block), rowsInSi(otherFirst, other),
                            [](double one, double two) {
                              return std::abs(one - two) <= kRounding * std::abs(one);
                            });
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

void joinMatrices(TextTable& table, std::vector<Message>& notes) {
  std::vector<TextBlock>& blocks = table.blocks;
  for (TextBlock& block : blocks)
    if (nameGroups(block))
      notes.emplace_back("matrices side by side have the names of their moduli above them");
  std::vector<Matrix> found;
  for (const TextBlock& block : blocks) {
    auto matrix = matrixOf(block);
    if (!matrix) return;
    const bool isSame =
        found.empty() || (matrix->states == found.front().states &&
                          haveSameRows(matrix->first, block, found.front().first, blocks.front()));
    if (!isSame) return;
    found.push_back(std::move(*matrix));
  }
  if (found.size() < 2) return;
  const Matrix& first = found.front();
  TextBlock made;
  made.header = blocks.front().header;
  eraseLinesOfNames(made.header, blocks.front().columns);
  made.rows = blocks.front().rows;
  made.lines = blocks.front().lines;
  made.columns = {first.first};
  made.values = blocks.front().column(0);
  made.texts.resize(1);
  made.cells = {blocks.front().cells.front()};
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t column = 1; column < blocks[i].columns.size(); ++column) {
      made.append({found[i].value.name + " " + found[i].states[column - 1], found[i].value.unit},
                  blocks[i].column(column));
      made.cells.back() = blocks[i].cells[column];
    }
  notes.push_back(message("{} matrices, each below the name of its modulus, are read as one table",
                          found.size()));
  if (first.isAssumed)
    notes.push_back(message("the numbers above the columns are taken for temperatures: {} to {}",
                            Message::name(first.states.front()),
                            Message::name(first.states.back())));
  blocks = {std::move(made)};
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
