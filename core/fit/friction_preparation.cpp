#include "core/fit/friction_preparation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/power_of_ten.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/fit/friction_columns.h"

namespace asperity {
namespace {

/// Calls use(column, end) for each column with a known meaning that the words from `begin` to `end`
/// make, `most` words at the most, until it returns true. Returns whether it did.
template <class Use>
bool anyColumn(const std::vector<std::string>& words, std::size_t begin, std::size_t most,
               const Use& use) {
  std::string text;
  for (std::size_t i = begin; i < std::min(words.size(), begin + most); ++i) {
    appendItem(text, words[i], " ");
    const TextColumn column = parseColumnName(text);
    if (findMeaning(column) && use(column, i + 1)) return true;
  }
  return false;
}

/// Finds all ways to make so many known columns of the words from `begin` on.
void findNames(const std::vector<std::string>& words, std::size_t begin, std::size_t count,
               std::vector<TextColumn>& made, std::vector<std::vector<TextColumn>>& ways) {
  constexpr std::size_t kMostWords = 6, kMostWays = 2;
  if (ways.size() >= kMostWays) return;
  if (made.size() == count || begin == words.size()) {
    if (made.size() == count && begin == words.size()) ways.push_back(made);
    return;
  }
  // A unit in brackets begins no name.
  if (words[begin].starts_with('(') || words[begin].starts_with('[')) return;
  anyColumn(words, begin, kMostWords, [&](const TextColumn& column, std::size_t end) {
    made.push_back(column);
    findNames(words, end, count, made, ways);
    made.pop_back();
    return false;
  });
}

/// Gives names to columns whose line of names has blanks within the names as well.
void findNames(TextBlock& block) {
  if (block.hasNames() || block.header.empty()) return;
  std::vector<std::vector<TextColumn>> ways;
  std::vector<TextColumn> made;
  findNames(blankSeparated(joinEntry(block.header.back(), " ")), 0, block.columns.size(), made,
            ways);
  for (std::size_t i = 0; ways.size() == 1 && i < block.columns.size(); ++i) {
    block.columns[i].name = ways.front()[i].name;
    block.columns[i].unit = ways.front()[i].unit;
  }
}

/// Separates from its name a unit that only friction has: "(% of mu)", and a power of ten as that
/// of a pure number, "(10^-3)" and "/ 10^-3".
void separateUnit(TextColumn& column) {
  const std::size_t open = column.name.find_last_of("([/");
  if (!column.unit.empty() || open == std::string::npos || open == 0) return;
  const bool isStroke = column.name[open] == '/';
  const std::string unit(withoutBrackets(column.name.substr(open + (isStroke ? 1 : 0))));
  if (!isWrittenPower(unit) && (isStroke || !isShareUnit(unit))) return;
  column.unit = unit;
  column.name = trimmedBlanks(column.name.substr(0, open));
}

/// Joins the symbol of friction to the name of its error, "s(\u00B5)" and "\u03C3_\u00B5": nobody
/// measures an error of friction in microns.
void joinSymbol(TextColumn& column) {
  if (!isOneOf(column.unit, "\u00B5 \u03BC")) return;
  const std::string name = column.name + "(" + column.unit + ")";
  if (findMeaning(name, {}) != FrictionQuantity::MuError) return;
  column.name = name;
  column.unit.clear();
}

/// Splits "mu \u00B1 2 sigma", the name of a column with errors in its cells; returns the name of
/// the errors.
std::string takeErrorName(TextColumn& column) {
  const std::string name = column.name;
  const auto sides = splitAtErrorSign(name);
  if (!sides || sides->number.empty()) return {};
  column.name = trimmedBlanks(sides->number);
  const std::string_view errors = trimmedBlanks(sides->error);
  return isOneOf(errors, "u s") ? std::string() : std::string(errors);
}

/// Appends a column of the errors that stand in the cells of another one.
void appendErrors(TextBlock& block, std::size_t of, const std::string& name) {
  const std::size_t count = block.columns.size();
  TextColumn column{name.empty() ? "standard error" : name, block.columns[of].unit};
  column.errorsOf = of;
  std::vector<double> values;
  std::vector<TextCell> cells(block.rows);
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t i = 0; i < count; ++i) values.push_back(block.at(row, i));
    values.push_back(block.cells[of][row].error);
    cells[row].unit = block.cells[of][row].unit;
  }
  block.columns.push_back(column);
  block.values = std::move(values);
  block.texts.emplace_back();
  block.cells.push_back(std::move(cells));
}

/// Gives the errors in the cells of the coefficient of friction a column of their own.
void separateErrors(TextBlock& block) {
  std::optional<std::size_t> found;
  std::string name;
  std::size_t count = 0;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    TextColumn& column = block.columns[i];
    std::string ofErrors;
    if (hasErrors(block.cells[i])) ofErrors = takeErrorName(column);
    if (findMeaning(column) != FrictionQuantity::Mu) continue;
    ++count;
    if (!hasErrors(block.cells[i])) continue;
    found = i;
    name = ofErrors;
  }
  if (found && count == 1) appendErrors(block, *found, name);
}

/// Keeps the cells of labels as they are written: "5 N" may name a sample.
void keepLabels(TextBlock& block) {
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    std::vector<TextCell>& cells = block.cells[i];
    const auto hasText = [](const TextCell& cell) { return !cell.text.empty(); };
    if (cells.empty() || findMeaning(block.columns[i]) != FrictionQuantity::Label ||
        !std::ranges::all_of(cells, hasText))
      continue;
    block.columns[i].isText = true;
    for (const TextCell& cell : cells) block.texts[i].push_back(cell.text);
    cells.clear();
  }
}

}  // namespace

bool hasErrors(const std::vector<TextCell>& cells) {
  return std::ranges::any_of(cells, [](const TextCell& cell) { return !std::isnan(cell.error); });
}

bool namesQuantity(const std::string& line) {
  constexpr std::size_t kMostWords = 3;
  const std::vector<std::string> words = blankSeparated(line);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (anyColumn(words, i, kMostWords, [](const TextColumn& column, std::size_t) {
          return findMeaning(column) != FrictionQuantity::Label && column.name.size() > 1;
        }))
      return true;
  return false;
}

void prepareColumns(TextBlock& block) {
  findNames(block);
  for (TextColumn& column : block.columns) {
    separateUnit(column);
    joinSymbol(column);
  }
  keepLabels(block);
  separateErrors(block);
}

}  // namespace asperity
