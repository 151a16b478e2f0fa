#include "core/measured/grid_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

constexpr std::size_t kMaxColumns = 12;

/// What the words in the name of a column say.
struct NumberName {
  bool isOfColumns = false, isOfRows = false;  // "col", "pixel_x"; "row", "pixel_y"
  bool isNumber = false;                       // "pixel", "index", "row", "x (px)"
};

NumberName readName(const TextColumn& column) {
  constexpr WordList kColumnWords("col cols column columns spalte spalten colonne");
  constexpr WordList kRowWords("row rows line zeile zeilen ligne rang");
  constexpr WordList kAlongX("x ix px jx"), kAlongY("y iy py jy");
  constexpr WordList kPixels("pixel pixels px py ix iy index idx nr no");
  NumberName found;
  std::string name = lowerCase(column.name);
  // "Column 1" and "Line 2" are names that programs give to columns of any kind.
  if (name.find_first_of("0123456789") != std::string::npos) return found;
  std::ranges::replace_if(
      name,
      [](char letter) {
        return letter != '\0' &&
               std::string_view("_-.()[]#").find(letter) != std::string_view::npos;
      },
      ' ');
  bool isAlongX = false, isAlongY = false;
  for (const std::string_view word : splitText(name, " ")) {
    found.isOfColumns = found.isOfColumns || isOneOf(word, kColumnWords);
    found.isOfRows = found.isOfRows || isOneOf(word, kRowWords);
    isAlongX = isAlongX || isOneOf(word, kAlongX);
    isAlongY = isAlongY || isOneOf(word, kAlongY);
    found.isNumber = found.isNumber || isOneOf(word, kPixels);
  }
  found.isNumber = isInPixels(column) ||
                   (column.unit.empty() && (found.isNumber || found.isOfColumns || found.isOfRows));
  if (!found.isOfColumns && !found.isOfRows) {
    found.isOfColumns = isAlongX;
    found.isOfRows = isAlongY;
  }
  return found;
}

/// The range of the whole numbers of a column; count 0: it holds other numbers, or only one.
struct Numbers {
  std::int64_t first = 0, count = 0;
  bool isComplete = false;  // each number of the range is there
};

Numbers numbersOf(const TextBlock& block, std::size_t column) {
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (!wholeNumber(std::isnan(value) ? INFINITY : value)) return {};
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  if (lowest == highest) return {};
  Numbers numbers{static_cast<std::int64_t>(lowest),
                  static_cast<std::int64_t>(highest - lowest) + 1};
  if (numbers.count > static_cast<std::int64_t>(block.rows)) return numbers;
  std::vector<bool> isThere(static_cast<std::size_t>(numbers.count));
  for (std::size_t i = 0; i < block.rows; ++i)
    isThere[static_cast<std::size_t>(block.at(i, column) - lowest)] = true;
  numbers.isComplete = std::ranges::find(isThere, false) == isThere.end();
  return numbers;
}

/// Returns whether the two columns hold each pair of their numbers once.
bool enumerate(const TextBlock& block, std::size_t one, const Numbers& ofOne, std::size_t other,
               const Numbers& ofOther) {
  if (!ofOne.isComplete || !ofOther.isComplete ||
      ofOne.count * ofOther.count != static_cast<std::int64_t>(block.rows))
    return false;
  std::vector<bool> isThere(block.rows);
  for (std::size_t i = 0; i < block.rows; ++i) {
    const auto at = static_cast<std::size_t>(
        (static_cast<std::int64_t>(block.at(i, one)) - ofOne.first) * ofOther.count +
        static_cast<std::int64_t>(block.at(i, other)) - ofOther.first);
    if (isThere[at]) return false;
    isThere[at] = true;
  }
  return true;
}

/// Returns whether the first column of the pair numbers the rows: by the names, else because it
/// runs more slowly. Without names the first column runs along x, as that of points does.
bool rowsComeFirst(const TextBlock& block, std::size_t one, std::size_t other) {
  const NumberName first = readName(block.columns[one]), second = readName(block.columns[other]);
  if (first.isOfColumns || second.isOfRows) return false;
  if (first.isOfRows || second.isOfColumns) return true;
  if (block.columns[one].name.empty()) return false;
  return block.at(0, one) == block.at(1, one) && block.at(0, other) != block.at(1, other);
}

}  // namespace

std::optional<GridNumbers> findGridNumbers(const TextBlock& block, const ColumnRoles& roles,
                                           const SurfaceSource& source, bool isStepKnown) {
  const std::size_t columns = std::min(block.columns.size(), kMaxColumns);
  if (columns < 3 || block.rows < 4 || source.choices.positionColumn > 0) return {};
  const auto mayNumber = [&](std::size_t i) {
    const TextColumn& column = block.columns[i];
    if (column.isText || static_cast<int>(i) + 1 == source.choices.heightColumn) return false;
    if (readName(column).isNumber) return true;
    if (column.name.empty()) return isStepKnown;
    const std::string name = lowerCase(column.name);
    return column.unit.empty() && !isPositionName(name) && !isRowName(name);
  };
  const auto nameOf = [&block](int column) -> const std::string& {
    return block.columns[static_cast<std::size_t>(column)].name;
  };
  std::vector<Numbers> numbers(columns);
  for (std::size_t i = 0; i < columns; ++i)
    if (mayNumber(i)) numbers[i] = numbersOf(block, i);
  for (std::size_t one = 0; one < columns; ++one)
    for (std::size_t other = one + 1; other < columns; ++other) {
      if (numbers[one].count == 0 || numbers[other].count == 0) continue;
      const NumberName first = readName(block.columns[one]),
                       second = readName(block.columns[other]);
      // Points may be missing, or there twice, where the names leave no doubt.
      const bool areNamed =
          first.isNumber && second.isNumber && !countsRows(block, one) &&
          !countsRows(block, other) &&
          ((first.isOfColumns && second.isOfRows) || (first.isOfRows && second.isOfColumns));
      if (!areNamed && !enumerate(block, one, numbers[one], other, numbers[other])) continue;
      const auto isOther = [&](int column) {
        return column >= 0 && column != static_cast<int>(one) && column != static_cast<int>(other);
      };
      if (isOther(roles.x) && isPositionName(lowerCase(nameOf(roles.x)))) return {};
      GridNumbers found{static_cast<int>(one), static_cast<int>(other), -1};
      if (rowsComeFirst(block, one, other)) std::swap(found.column, found.row);
      // Heights that rise all along may have been taken for positions.
      const auto height = std::ranges::find_if(roles.heights, isOther);
      found.height = source.choices.heightColumn > 0 ? source.choices.heightColumn - 1
                     : height != roles.heights.end() ? *height
                     : isOther(roles.z)              ? roles.z
                                                     : roles.x;
      if (isOther(found.height)) return found;
    }
  return {};
}

}  // namespace asperity
