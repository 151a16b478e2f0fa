#include "core/measured/matrix_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_number.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
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
