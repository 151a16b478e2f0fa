#include "core/base/text_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/base/units.h"

namespace asperity {

std::vector<double> TextBlock::column(std::size_t number) const {
  std::vector<double> found(rows);
  for (std::size_t i = 0; i < rows; ++i) found[i] = at(i, number);
  return found;
}

bool TextBlock::hasNumber(std::size_t column) const {
  for (std::size_t row = 0; row < rows; ++row)
    if (!std::isnan(at(row, column))) return true;
  return false;
}

void TextBlock::append(TextColumn column, const std::vector<double>& numbers) {
  const std::size_t count = columns.size();
  std::vector<double> wider;
  wider.reserve(rows * (count + 1));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < count; ++i) wider.push_back(at(row, i));
    wider.push_back(numbers[row]);
  }
  values = std::move(wider);
  columns.push_back(std::move(column));
  texts.emplace_back();
  cells.emplace_back();
}

bool TextBlock::hasNames() const {
  return std::ranges::any_of(columns,
                             [](const TextColumn& column) { return !column.name.empty(); });
}

std::string TextBlock::label(std::size_t number) const {
  const std::string& name = columns[number].name;
  return name.empty() ? "column " + std::to_string(number + 1) : name;
}

const TextBlock& TextTable::largest() const {
  return *std::ranges::max_element(blocks, {},
                                   [](const TextBlock& one) { return one.values.size(); });
}

std::vector<const TextEntry*> TextPart::entriesAbove() const {
  std::vector<const TextEntry*> entries;
  for (const TextBlock& one : blocksUpTo())
    for (const TextEntry& entry : one.header) entries.push_back(&entry);
  return entries;
}

std::string TextTable::entry(std::string_view key, const TextBlock& block) const {
  return TextPart{*this, block}.entry(key);
}

std::string TextPart::entry(std::string_view key) const {
  const auto spelled = [](std::string_view text) {
    std::string word = lowerCase(text);
    std::ranges::replace(word, '_', ' ');
    return word;
  };
  const std::string wanted = spelled(key);
  std::string found;
  for (const TextEntry* const entry : entriesAbove())
    if (spelled(entry->key) == wanted) found = entry->value;
  return found;
}

namespace {

/// Returns whether a block is a list of names and numbers, as "Load [N];75" below "Compound;A12",
/// which may have units behind the numbers or in front of them.
bool isList(const TextBlock& block) {
  const std::vector<TextColumn>& columns = block.columns;
  if (columns.size() < 2 || columns.size() > 3 || !columns[0].isText) return false;
  if (columns.size() == 2 || columns[2].isText) return !columns[1].isText;
  for (std::size_t row = 0; columns[1].isText && row < block.rows; ++row)
    if (isUnitInFront(block.texts[0][row], block.texts[1][row])) return true;
  return false;
}

bool hasTwoNumbers(const TextBlock& block) {
  return std::ranges::count(block.columns, false, &TextColumn::isText) > 1;
}

/// Returns the lines of a list as they would stand above a table.
std::vector<TextEntry> listedEntries(const TextBlock& list, char decimal) {
  std::vector<TextEntry> entries = list.header;
  const std::size_t numbers = list.columns[1].isText ? 2 : 1, units = 3 - numbers;
  for (std::size_t row = 0; row < list.rows; ++row) {
    if (std::isnan(list.at(row, numbers))) continue;
    std::string value = plain(list.at(row, numbers)).text;
    std::ranges::replace(value, '.', decimal);
    if (row < list.cells[numbers].size() && !list.cells[numbers][row].text.empty())
      value = list.cells[numbers][row].text;
    const std::string& key = list.texts[0][row];
    if (list.columns.size() == 3) {
      const std::string& unit = list.texts[units][row];
      if (units > numbers || isUnitInFront(key, unit))
        appendItem(value, unit, " ");
      else
        value = unit + " " + value;
    }
    entries.push_back({key, value, list.lines[row], key + ": " + value});
  }
  return entries;
}

/// Returns whether a block has one row of numbers with names, fewer than the block below it and
/// with other names: "Load (N);T (C)" above "50;23".
bool isRowOfConditions(const TextBlock& block, const TextBlock& below) {
  const auto isOwnName = [&below](const TextColumn& column) {
    return !column.name.empty() &&
           std::ranges::find(below.columns, column.name, &TextColumn::name) == below.columns.end();
  };
  return block.rows == 1 && block.values.size() < below.values.size() && hasTwoNumbers(below) &&
         std::ranges::all_of(block.columns, isOwnName);
}

/// Returns the numbers of such a row as lines.
std::vector<TextEntry> conditionEntries(const TextBlock& row, char decimal) {
  std::vector<TextEntry> entries = row.header;
  for (std::size_t i = 0; i < row.columns.size(); ++i) {
    const TextColumn& column = row.columns[i];
    if (column.isText || std::isnan(row.at(0, i))) continue;
    std::string value = plain(row.at(0, i)).text;
    std::ranges::replace(value, '.', decimal);
    const bool hasCell = !row.cells[i].empty() && !row.cells[i].front().text.empty();
    value = hasCell ? row.cells[i].front().text : value + " " + column.unit;
    entries.push_back({column.name, value, row.lines.front(), column.name + ": " + value});
  }
  return entries;
}

}  // namespace

void moveListsAbove(TextTable& table) {
  std::vector<TextBlock>& blocks = table.blocks;
  for (std::size_t i = 0; i + 1 < blocks.size();) {
    const auto below = blocks.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const bool isOfList = isList(blocks[i]) && std::any_of(below, blocks.end(), hasTwoNumbers);
    // A single row may belong to the table above it.
    const bool hasNamesOfAbove = i > 0 && blocks[i].hasNames() &&
                                 std::ranges::equal(blocks[i].columns, blocks[i - 1].columns, {},
                                                    &TextColumn::name, &TextColumn::name);
    if (!isOfList && (hasNamesOfAbove || !isRowOfConditions(blocks[i], *below))) {
      ++i;
      continue;
    }
    const std::vector<TextEntry> entries = isOfList
                                               ? listedEntries(blocks[i], table.dialect.decimal)
                                               : conditionEntries(blocks[i], table.dialect.decimal);
    below->header.insert(below->header.begin(), entries.begin(), entries.end());
    blocks.erase(below - 1);
  }
}

namespace {

/// A clause that is a name, a number and a unit and nothing else.
struct StatedClause {
  std::string quantity{};  // by the caller's word
  double number = 0;
};

/// Reads such a clause; nothing where it is none, or has none of the caller's quantities.
std::optional<StatedClause> parseStated(std::string_view clause, const StatedQuantity& quantityOf) {
  const std::size_t sign = clause.find_first_of(":=");
  const std::size_t number = sign == clause.npos ? clause.find_first_of("+-0123456789") : sign + 1;
  if (number == clause.npos || clause.find_first_of("<>") != clause.npos) return {};
  const auto value = parseQuantity(clause.substr(number));
  const std::string_view key = withoutEnd(clause.substr(0, number), " :=");
  if (!value || (sign == clause.npos && key.size() == number && number > 0)) return {};
  // "T [\u00B0C] = 20", but not "[1] T = 20 \u00B0C"
  const TextColumn name = parseColumnName(key);
  if (!key.starts_with(name.name) || (!name.unit.empty() && !value->unit.empty())) return {};
  StatedClause stated{quantityOf(plainWord(name.name), name.unit + value->unit), value->number};
  return stated.quantity.empty() ? std::nullopt : std::optional(std::move(stated));
}

/// Returns whether a line below a table is about who measured it, when, and on which size of a
/// sample, so that lines below it still are about the table. "Sample: B" may begin another one.
bool isOfRecord(const TextEntry& entry) {
  constexpr WordList kOfRecord(
      "operator bediener pr\u00FCfer lab labor width breite length l\u00E4nge thickness dicke area "
      "fl\u00E4che");
  const std::vector<std::string> words = wordsIn(entry.key);
  if (entry.value.empty() || entry.value.find('=') != std::string::npos || words.empty())
    return false;
  return isOneOf(words.front(), kOfRecord) ||
         (words.size() == 1 && isOneOf(words.front(), "date datum"));
}

/// Returns whether a line is about a duration: a temperature beside it is one of curing, ageing or
/// storing.
bool isOfDuration(const TextEntry& entry) {
  const std::string line = joinEntry(entry);
  const auto stated = parseStatement(line);
  return (stated && unitSize(stated->unit(), "s")) ||
         hasOneOf(wordsIn(entry.key), "time zeit uhrzeit dauer duration");
}

}  // namespace

std::vector<TextEntry> statedBelow(const TextTable& table, const StatedQuantity& quantityOf) {
  constexpr std::size_t kMaxLines = 100;
  std::vector<TextEntry> lines;
  if (table.trailer.size() > kMaxLines || std::ranges::any_of(table.trailer, isOfDuration))
    return lines;
  for (const TextEntry& entry : table.trailer) {
    if (isRule(joinEntry(entry)) || isOfRecord(entry)) continue;
    const std::string line = joinEntry(entry);
    const std::vector<std::string_view> clauses = splitClauses(line);
    const auto isStated = [&](std::string_view clause) {
      return parseStated(clause, quantityOf).has_value();
    };
    if (clauses.empty() || !std::ranges::all_of(clauses, isStated)) break;
    lines.push_back(entry);
  }
  return lines;
}

namespace {

/// How two lines differ.
enum class Difference { None, Values, Other };

/// Compares two lines by their clauses: "Sample A, T = 5 \u00B0C" and "Sample A, T = 20 \u00B0C"
/// differ in the values of quantities alone.
Difference compareLines(const TextEntry& one, const TextEntry& other,
                        const StatedQuantity& quantityOf) {
  const std::string first = joinEntry(one), second = joinEntry(other);
  const std::vector<std::string_view> ofOne = splitClauses(first), ofOther = splitClauses(second);
  if (ofOne.size() != ofOther.size()) return Difference::Other;
  Difference difference = Difference::None;
  for (std::size_t i = 0; i < ofOne.size(); ++i) {
    if (ofOne[i] == ofOther[i]) continue;
    const auto before = parseStated(ofOne[i], quantityOf),
               now = parseStated(ofOther[i], quantityOf);
    if (!before || !now || before->quantity != now->quantity) return Difference::Other;
    if (before->number != now->number) difference = Difference::Values;
  }
  return difference;
}

/// Returns whether each line above a block is one of those above the rows before it, with other
/// values of quantities in at least one, and puts it in the place of that one.
bool restates(const TextBlock& block, const StatedQuantity& quantityOf,
              std::vector<TextEntry>& above) {
  bool hasOtherValue = false;
  for (const TextEntry& entry : block.header) {
    if (isRule(joinEntry(entry))) continue;
    Difference difference = Difference::Other;
    const auto same = std::ranges::find_if(above, [&](const TextEntry& one) {
      difference = compareLines(one, entry, quantityOf);
      return difference != Difference::Other;
    });
    if (same == above.end()) return false;
    hasOtherValue |= difference == Difference::Values;
    *same = entry;
  }
  return hasOtherValue;
}

}  // namespace

std::vector<Message> repeatNames(TextTable& table,
                                 const std::function<bool(const TextBlock&)>& isTable,
                                 const StatedQuantity& quantityOf) {
  std::vector<Message> notes;
  const TextBlock* named = nullptr;
  std::vector<TextEntry> above;  // the lines above the last rows
  const auto isOfNoColumn = [&](const std::string& name, const std::string& unit) {
    std::string quantity = quantityOf(name, unit);
    const auto hasIt = [&](const TextColumn& column) {
      return quantityOf(plainWord(column.name), column.unit) == quantity;
    };
    return std::ranges::any_of(named->columns, hasIt) ? std::string() : quantity;
  };
  for (TextBlock& block : table.blocks) {
    // "T = 20 \u00B0C;;" has been taken for the name of the first column.
    const bool hasNames = std::any_of(block.columns.begin() + 1, block.columns.end(),
                                      [](const TextColumn& one) { return !one.name.empty(); });
    const bool hasTexts = std::ranges::any_of(block.columns, &TextColumn::isText);
    if (hasNames && !hasTexts && isTable(block)) {
      named = &block;
      above = block.header;
    } else if (named && !hasTexts && block.columns.size() == named->columns.size() &&
               restates(block, isOfNoColumn, above)) {
      block.columns = named->columns;
      notes.push_back(message("the rows from line {} on have the columns of the table above them",
                              block.lines.front()));
    } else {
      named = nullptr;
    }
  }
  return notes;
}

void undoLogarithms(TextTable& table, const std::function<bool(const std::string&)>& isQuantity) {
  constexpr std::pair<std::string_view, double> kLogarithms[] = {
      {"log10", 10}, {"log", 10}, {"lg", 10}, {"ln", std::numbers::e}};
  for (TextBlock& block : table.blocks)
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
      TextColumn& column = block.columns[i];
      const std::string name = lowerCase(column.name);
      const auto* const found = std::ranges::find_if(
          kLogarithms, [&](const auto& logarithm) { return name.starts_with(logarithm.first); });
      if (found == std::end(kLogarithms) || column.isText || !block.cells[i].empty()) continue;
      std::string_view rest = std::string_view(column.name).substr(found->first.size());
      rest = trimmedBlanks(rest.substr(std::min(rest.find_first_not_of("_ "), rest.size())));
      // The unit of "log10(\u03C9/(rad/s))" has taken the second bracket along.
      if (rest.starts_with('(') && rest.find(')') == rest.npos) rest.remove_prefix(1);
      const TextColumn inner = parseColumnName(withoutBrackets(rest));
      if (!isQuantity(inner.name)) continue;
      const std::string unit = inner.unit.empty() ? column.unit : inner.unit;
      column = {inner.name, unit, false};
      for (std::size_t row = 0; row < block.rows; ++row) {
        double& value = block.at(row, i);
        value = std::pow(found->second, value);
        if (std::isinf(value)) value = kNaN;
      }
    }
}

std::optional<std::vector<double>> filledDown(const TextBlock& block, std::size_t column,
                                              std::size_t other) {
  std::vector<double> numbers = block.column(column);
  std::size_t rows = 0, missing = 0;
  for (std::size_t row = 0; row < block.rows; ++row) {
    if (std::isnan(block.at(row, other))) continue;
    ++rows;
    missing += std::isnan(numbers[row]) ? 1 : 0;
  }
  if (missing == 0 || 2 * missing < rows || std::isnan(numbers.front())) return {};
  for (std::size_t row = 1; row < numbers.size(); ++row)
    if (std::isnan(numbers[row])) numbers[row] = numbers[row - 1];
  return numbers;
}

Message standsInFirstRows(const std::string& name) {
  return message("{} stands in the first row of each group alone: it holds for the rows below it",
                 Message::name(name));
}

Message unclearMark(char decimal) {
  return message(
      "All marks in the numbers stand before three digits: '{}' is taken for the decimal mark.",
      std::string(1, decimal));
}

std::vector<Message> doubtsAbout(const TextTable& table) {
  std::vector<Message> doubts;
  const std::vector<std::uint32_t>& lines = table.leftOut;
  if (lines.size() == 1)
    doubts.push_back(
        message("Line {} is left out: it begins with a number but is not a row of the table.",
                lines.front()));
  if (lines.size() > 1)
    doubts.push_back(
        message("{} lines, the first is line {}, are left out: they begin with a number but are "
                "not rows of the table.",
                lines.size(), lines.front()));
  if (table.dialect.hasThousandsAlone)
    doubts.push_back(message(
        "All numbers of a column have a '{}' before their last three digits and are read as "
        "thousands: '{}' is the decimal mark of the others.",
        std::string(1, table.dialect.decimal == '.' ? ',' : '.'),
        std::string(1, table.dialect.decimal)));
  return doubts;
}

void refuseUnclearMark(const TextTable& table, const std::string& name) {
  if (!table.dialect.isUnclear) return;
  throw InputError(
      name, "",
      message("all marks in the numbers stand before three digits, so '{}' may separate "
              "decimals or thousands; write thousands without a mark, or one number "
              "with more or fewer decimals",
              std::string(1, table.dialect.decimal)));
}

bool countsRows(const TextBlock& block, std::size_t column) {
  if (block.columns[column].isText || block.rows < 2) return false;
  const double first = block.at(0, column);
  if (std::isnan(first) || (first != 0 && first != 1)) return false;
  for (std::size_t i = 1; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (std::isnan(value) || value != first + static_cast<double>(i)) return false;
  }
  return true;
}

}  // namespace asperity
