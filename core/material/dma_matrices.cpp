#include "core/material/dma_matrices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

using enum DmaQuantity;

DmaQuantity quantityOf(const TextColumn& column) {
  return dmaColumn(column.name, column.unit).quantity;
}

/// A matrix of one quantity.
struct Matrix {
  TextColumn value{};                 // "G'", MPa
  TextColumn first{};                 // of the rows
  std::vector<std::string> states{};  // of the columns, "20 \u00B0C"
  bool isAssumed = false;             // whether the unit of the states is
};

/// Returns the quantity in the corner of a matrix that the columns have, "T (\u00B0C)" of "f (Hz) \
/// T (\u00B0C)", and leaves that of the rows; else the one that a line above it names alone.
TextColumn quantityOfColumns(TextColumn& first, const TextBlock& block) {
  const auto hasItsUnit = [](const TextColumn& column) {
    return quantityOf(column) == Temperature ? temperatureUnit(column.unit).has_value()
                                             : frequencyUnit(column.unit, false).has_value();
  };
  if (auto corner = splitCorner(first, hasItsUnit)) {
    first = std::move(corner->first);
    return std::move(corner->second);
  }
  for (const TextEntry& entry : block.header) {
    const std::string_view written = withoutEnd(trimmedBlanks(entry.written), ":;, ");
    const TextColumn column =
        parseColumnName(written.substr(std::min(written.find_first_not_of(";, "), written.size())));
    if (written.find_first_of("0123456789") == written.npos && !column.unit.empty() &&
        (quantityOf(column) == Temperature || quantityOf(column) == Frequency))
      return column;
  }
  return {};
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
    double number = 0;
    if (wanted == Temperature && temperature) {
      states.push_back(text.substr(temperature->begin, temperature->end - temperature->begin));
    } else if (wanted == Frequency && frequency) {
      states.push_back(text.substr(frequency->begin, frequency->end - frequency->begin));
    } else if (column.unit.empty() && readTextNumber(column.name, '.', number)) {
      bare.push_back(number);
      continue;
    } else {
      return {};
    }
    // "G' 20 \u00B0C" names its modulus, too.
    const std::string name = text.substr(0, text.find_first_of("-0123456789"));
    if (!compactName(name).empty() && quantityOf({std::string(keyBefore(name))}) != wanted)
      return {};
  }
  if (bare.empty()) return states;
  const bool isStated = quantityOf(of) == wanted && !of.unit.empty();
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
    if (isMeasured(quantityOf(column))) return column;
  }
  return {};
}

std::optional<Matrix> matrixOf(const TextBlock& block) {
  if (block.columns.size() < 3 || block.columns.front().isText) return {};
  Matrix matrix;
  matrix.first = block.columns.front();
  const TextColumn of = quantityOfColumns(matrix.first, block);
  const DmaQuantity ofRows = quantityOf(matrix.first);
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
        values, [](const TextColumn& value) { return isMeasured(quantityOf(value)); });
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
  const TextColumn of = quantityOfColumns(first, block);
  bool isAssumed = false;
  const std::vector<std::string> states = statesOf(block, quantityOf(first), of, isAssumed);
  const std::size_t count = (block.columns.size() - 1) / values.size();
  if (states.empty() || isAssumed || count < 2) return false;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] != states[i % count]) return false;
  block.columns.front() = std::move(first);
  for (std::size_t i = 0; i < states.size(); ++i)
    block.columns[i + 1] = {values[i / count].name + " " + states[i], values[i / count].unit};
  return true;
}

bool haveSameRows(const TextBlock& one, const TextBlock& other) {
  return one.rows == other.rows && one.column(0) == other.column(0);
}

}  // namespace

void joinMatrices(TextTable& table, std::vector<Message>& notes) {
  std::vector<TextBlock>& blocks = table.blocks;
  for (TextBlock& block : blocks)
    if (nameGroups(block))
      notes.emplace_back("matrices side by side have the names of their moduli above them");
  std::vector<Matrix> found;
  for (const TextBlock& block : blocks) {
    auto matrix = matrixOf(block);
    if (!matrix) return;
    const bool isSame = found.empty() || (matrix->states == found.front().states &&
                                          matrix->first.name == found.front().first.name &&
                                          haveSameRows(block, blocks.front()));
    if (!isSame) return;
    found.push_back(std::move(*matrix));
  }
  if (found.size() < 2) return;
  const Matrix& first = found.front();
  TextBlock made;
  made.header = blocks.front().header;
  // The line of names states none of all points.
  std::erase_if(made.header, [&blocks](const TextEntry& entry) {
    return entry.written.find(blocks.front().columns.back().name) != std::string::npos;
  });
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

}  // namespace asperity
