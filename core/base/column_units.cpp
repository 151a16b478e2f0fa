#include "core/base/column_units.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/units.h"

namespace asperity {
namespace {

/// Throws InputError for a number whose unit, or none, is not the common one of its column.
[[noreturn]] void refuseUnit(const TextBlock& block, std::size_t row, std::size_t column,
                             const std::string& unit, const std::string& common,
                             const std::string& file) {
  const std::string& own = block.columns[column].name;
  const std::string label = own.empty() ? std::to_string(column + 1) : shortened(own);
  throw InputError(
      file, "",
      message("row {}: {}", block.lines[row],
              unit.empty() ? message("column {} has no unit here, and {} elsewhere", label,
                                     shortened(common))
                           : message("column {} has the unit {} here, and {} elsewhere", label,
                                     shortened(unit), shortened(common))));
}

}  // namespace

void unifyUnits(TextBlock& block, std::size_t i, const std::string& name) {
  std::vector<TextCell>& cells = block.cells[i];
  TextColumn& column = block.columns[i];
  const auto hasUnit = [](const TextCell& cell) { return !cell.unit.empty(); };
  const auto first = std::ranges::find_if(cells, hasUnit);
  if (first == cells.end()) return;
  const std::string common = column.unit.empty() ? first->unit : column.unit;
  const auto of = findUnit(common);
  bool isMixed = false;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const std::string& unit = cells[row].unit;
    if (std::isnan(block.at(row, i)) || unit == common) continue;
    if (unit.empty() && !column.unit.empty()) continue;
    const auto other = findUnit(unit);
    const bool isSame = !unit.empty() && of && other && other->si == of->si;
    // Above the column and in the cell are two statements about one number.
    if (!isSame || (!column.unit.empty() && !(*other == *of)))
      refuseUnit(block, row, i, unit, common, name);
    isMixed = isMixed || !(*other == *of);
  }
  for (std::size_t row = 0; row < block.rows && isMixed; ++row) {
    if (cells[row].unit.empty()) continue;  // a missing value
    double& value = block.at(row, i);
    value = findUnit(cells[row].unit)->toSi(value);
  }
  column.unit = isMixed ? std::string(of->si) : common;
}

void unifyUnits(TextBlock& block, const std::string& name) {
  for (std::size_t i = 0; i < block.cells.size(); ++i) unifyUnits(block, i, name);
}

bool isNameOfUnits(const TextColumn& column) {
  constexpr WordList kOfUnits("unit units einheit einheiten unit\u00E9 unidad unit\u00E0");
  return isOneOf(lowerCase(column.name), kOfUnits);
}

void takeColumnsOfUnits(TextBlock& block, const std::string& name) {
  if (std::ranges::count(block.columns, false, &TextColumn::isText) < 2) return;
  std::size_t candidates = 0;  // columns of numbers since the last one of units
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    if (!block.columns[i].isText) ++candidates;
    if (!block.columns[i].isText || !isNameOfUnits(block.columns[i])) continue;
    if (std::exchange(candidates, 0) != 1 || block.columns[i - 1].isText) continue;
    TextColumn& numbers = block.columns[i - 1];
    const std::vector<std::string>& units = block.texts[i];
    const auto unit = std::ranges::find_if(units, [](const auto& one) { return !one.empty(); });
    if (unit == units.end() || !numbers.unit.empty() || !isUnitInFront(numbers.name, *unit))
      continue;
    for (std::size_t row = 0; row < block.rows; ++row)
      if (units[row] != *unit && !std::isnan(block.at(row, i - 1)))
        refuseUnit(block, row, i - 1, units[row], *unit, name);
    numbers.unit = withoutBrackets(*unit);
  }
}

}  // namespace asperity
