#include "core/measured/grid_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/intervals.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/measured/uniform_positions.h"

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
  Extent range;
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (!wholeNumber(std::isnan(value) ? INFINITY : value)) return {};
    range.add(value);
  }
  const auto [lowest, highest] = range;
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
      if (isOther(roles.x) && isPositionName(lowerCase(columnAt(block, roles.x).name))) return {};
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

namespace {

/// The rows or the columns of a table, each from number `from` on.
class Lines {
 public:
  Lines(const TextBlock& block, bool areRows, std::size_t from)
      : block_(block), areRows_(areRows), from_(from) {}

  std::size_t count() const { return areRows_ ? block_.rows : block_.columns.size(); }
  /// Returns how many numbers a line has.
  std::size_t size() const {
    const std::size_t all = areRows_ ? block_.columns.size() : block_.rows;
    return all > from_ ? all - from_ : 0;
  }
  std::vector<double> at(std::size_t line) const {
    std::vector<double> numbers;
    for (std::size_t i = from_; i < from_ + size(); ++i)
      numbers.push_back(areRows_ ? block_.at(line, i) : block_.at(i, line));
    return numbers;
  }

 private:
  const TextBlock& block_;
  bool areRows_;
  std::size_t from_;
};

/// Returns whether all numbers are there and evenly spaced, apart from their last digits.
bool areEven(const std::vector<double>& numbers) {
  constexpr double kRounding = 0.05;  // of a step
  if (std::ranges::any_of(numbers, [](double number) { return std::isnan(number); })) return false;
  const auto spacing = uniformSpacing(numbers);
  if (!spacing) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (std::abs(numbers[i] - numbers[0] - static_cast<double>(i) * *spacing) >
        kRounding * std::abs(*spacing))
      return false;
  return true;
}

/// Returns whether the first row or column is an axis by its numbers: at least `fewest`, which are
/// evenly spaced, while those of most other rows or columns are not, as on a plane.
bool isAxis(const Lines& lines, std::size_t fewest) {
  if (lines.size() < fewest || lines.count() < 3 || !areEven(lines.at(0))) return false;
  std::size_t alike = 0;
  for (std::size_t line = 1; line < lines.count(); ++line) alike += areEven(lines.at(line)) ? 1 : 0;
  return 2 * alike < lines.count();
}

/// Returns whether the first row or column from number `from` on numbers the points: it counts by
/// one, and the others do not. Throws InputError where that is not clear.
bool numbersPoints(const TextBlock& block, bool isRow, std::size_t from,
                   const SurfaceSource& source) {
  const Lines lines(block, isRow, from);
  constexpr std::size_t kMin = 3, kMany = 8;
  if (lines.size() < kMin || !countByOne(lines.at(0))) return false;
  std::size_t alike = 0;
  bool areWhole = true;
  for (std::size_t line = 1; line < lines.count(); ++line) {
    const std::vector<double> numbers = lines.at(line);
    alike += countByOne(numbers) ? 1 : 0;
    areWhole = areWhole && std::ranges::all_of(numbers, [](double one) {
                 return std::isnan(one) || one == std::floor(one);
               });
  }
  if (alike + 1 == lines.count()) return false;  // a ramp
  if (alike == 0 && (!areWhole || lines.size() >= kMany)) return true;
  if (source.choices.format == "matrix") return false;
  throw InputError(source.name, "surface.format",
                   isRow ? message("is needed: the first row may number the points; leave it out, "
                                   "or set matrix where it holds heights")
                         : message("is needed: the first column may number the points; leave it "
                                   "out, or set matrix where it holds heights"));
}

/// Throws InputError where only the first row, or only the first column, is an axis that does not
/// number the points.
void refuseLoneAxis(const TextBlock& block, const Numbering& numbering,
                    const SurfaceSource& source) {
  constexpr std::size_t kMany = 8;
  if (source.choices.format == "matrix") return;
  if (!numbering.row && isAxis(Lines(block, true, numbering.column ? 1 : 0), kMany))
    throw InputError(source.name, "surface.format",
                     "is needed: the first row is evenly spaced and may hold positions; leave it "
                     "out, or set matrix where it holds heights");
  if (!numbering.column && isAxis(Lines(block, false, numbering.row ? 1 : 0), kMany))
    throw InputError(source.name, "surface.format",
                     "is needed: the first column is evenly spaced and may hold positions; leave "
                     "it out, or set matrix where it holds heights");
}

}  // namespace

bool countByOne(const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != (i == 0 ? std::floor(numbers[0]) : numbers[i - 1] + 1)) return false;
  return !numbers.empty();
}

MatrixFrame readFrame(const TextBlock& block) {
  MatrixFrame frame;
  const std::size_t columns = block.columns.size();
  if (columns < 4 || block.rows < 3) return frame;
  // All names but the first are numbers.
  std::vector<double> named;
  for (std::size_t i = 1; i < columns; ++i) {
    double number = 0;
    if (readTextNumber(block.columns[i].name, '.', number) ||
        readTextNumber(block.columns[i].name, ',', number))
      named.push_back(number);
  }
  std::vector<double> first;
  for (std::size_t i = 1; i < columns; ++i) first.push_back(block.at(0, i));
  const bool inNames = named.size() + 1 == columns && uniformSpacing(named).has_value();
  constexpr std::size_t kMin = 5;  // fewer are even by chance
  const bool isOpen = std::isnan(block.at(0, 0));
  const bool inRow =
      !inNames &&
      (isOpen ? std::ranges::none_of(first, [](double x) { return std::isnan(x); }) &&
                    uniformSpacing(first).has_value()
              : isAxis(Lines(block, true, 1), kMin) && isAxis(Lines(block, false, 1), kMin));
  if (!inNames && !inRow) return frame;
  std::vector<double> y;
  for (std::size_t i = inRow ? 1 : 0; i < block.rows; ++i) y.push_back(block.at(i, 0));
  if (y.size() < 2 || !uniformSpacing(y)) return frame;
  // Numbers 1, 2, 3, ... around a number only number the points.
  if (inRow && !isOpen && countByOne(first) && countByOne(y)) return frame;
  frame.hasColumn = true;
  if (inRow && !isOpen) frame.corner = block.at(0, 0);
  frame.hasRow = inRow;
  frame.x = inNames ? named : first;
  frame.y = std::move(y);
  return frame;
}

Numbering findNumbering(const TextBlock& block, const SurfaceSource& source) {
  if (numbersPoints(block, true, 1, source) && numbersPoints(block, false, 1, source))
    return {true, true};
  const Numbering numbering{numbersPoints(block, true, 0, source),
                            numbersPoints(block, false, 0, source)};
  refuseLoneAxis(block, numbering, source);
  return numbering;
}

}  // namespace asperity
