// Reads tables of numbers in text files, whatever program or person wrote them: profiles, sweeps of
// a rheometer, measured friction. One reader finds encoding, separator, decimal mark, names, units,
// `key: value` lines and missing values; the callers interpret the columns.
// Pure; any thread. Failure: InputError that names the file and the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_cell.h"
#include "core/base/text_dialect.h"

namespace asperity {

struct TextColumn {
  std::string name{};   // without the unit; empty where the file has no names
  std::string unit{};   // as written ("\u00B5m", "rad/s"), from the name or from a row of units
  bool isText = false;  // labels, in TextBlock::texts
  std::optional<std::size_t> errorsOf{};  // the column in whose cells the numbers stand as errors
  bool isOfNames = false;                 // the numbers stand in the names of other columns
};

/// A line that is not a row of numbers: "key: value", "key = value", "key;value", "# key: value".
struct TextEntry {
  std::string key{};  // empty where the line has none
  std::string value{};
  std::size_t line = 0;  // counted from 1
  /// The line as the file has it, without the mark of a comment, separators at its end and tabs, to
  /// be quoted.
  std::string written{};
};

/// Consecutive rows of equally many fields. Blank lines and comments do not end a block.
struct TextBlock {
  std::vector<TextColumn> columns{};
  std::size_t rows = 0;
  std::vector<double> values{};                   // rows x columns, row by row; NaN where missing
  std::vector<std::vector<std::string>> texts{};  // of each column; empty where it has numbers
  /// Errors and units of each column that has some in its cells (TextTableOptions::readsCells).
  std::vector<std::vector<TextCell>> cells{};
  std::vector<TextEntry> header{};  // the lines between the block before and this one
  /// The rows but the first with blank lines in front of them, and how many these are; 0 where
  /// there are comments, too.
  std::vector<std::pair<std::size_t, std::size_t>> blanks{};
  std::vector<std::uint32_t> lines{};  // of each row, counted from 1

  double at(std::size_t row, std::size_t column) const {
    return values[row * columns.size() + column];
  }
  double& at(std::size_t row, std::size_t column) { return values[row * columns.size() + column]; }
  std::vector<double> column(std::size_t number) const;
  /// Returns whether some row has a number in a column.
  bool hasNumber(std::size_t column) const;
  /// Appends a column with a number in each row.
  void append(TextColumn column, const std::vector<double>& numbers);
  /// Returns whether some column has a name.
  bool hasNames() const;
  /// Returns the name of a column, or "column 3".
  std::string label(std::size_t column) const;
};

struct TextTable {
  std::string_view encoding{};  // as DecodedText names it
  TextDialect dialect{};
  std::vector<TextBlock> blocks{};   // at least one
  std::vector<TextEntry> trailer{};  // lines after the last block
  /// The numbers of lines that look like rows but are not: damaged ones right above or below a
  /// block, and those after the last block that begin with a number.
  std::vector<std::uint32_t> leftOut{};

  /// Returns the block with the most numbers; of equal ones the first.
  const TextBlock& largest() const;
  /// Returns TextPart::entry of the block.
  std::string entry(std::string_view key, const TextBlock& block) const;
};

/// A block of a table with what the lines above it state. The readers of surfaces, moduli and
/// friction add what the user states.
struct TextPart {
  const TextTable& table;
  const TextBlock& block;

  /// Returns the blocks from the first one to this one.
  std::span<const TextBlock> blocksUpTo() const { return {table.blocks.data(), &block + 1}; }
  /// Returns the entries in front of the block, in its header or that of an earlier block.
  std::vector<const TextEntry*> entriesAbove() const;
  /// Returns the value of the nearest entry with this key in front of the block, in upper or lower
  /// case. Empty where there is none.
  std::string entry(std::string_view key) const;
};

struct TextTableOptions {
  /// Whether columns whose first field is no number are kept as texts, if the columns have names.
  /// Otherwise rows have numbers only.
  bool keepsTexts = false;
  /// The names (in lower case) of columns that are texts even where they look like numbers: labels.
  std::vector<std::string> textColumns{};
  /// Whether numbers may have errors and units in their cells. A row of such cells alone begins a
  /// block only below names, and above another one.
  bool readsCells = false;
  /// Whether a date or a time of day is a missing value among numbers.
  bool datesAreMissing = false;
  /// Whether a blank line between the numbers of a single column is a row without a value, as
  /// spreadsheets write it, unless such a line follows every row.
  bool blankLinesAreGaps = false;
  /// Called now and then with the part that has been read, 0 to 1. It may throw to end the reading.
  std::function<void(double)> progress{};
};

/// Reads the bytes of a file; name: of the file, in errors. A field that is no number among rows of
/// numbers, or a row of another width, is an error; after the last row of a block such a line ends
/// the block.
TextTable readTextTable(std::string_view bytes, const std::string& name,
                        const TextTableOptions& options = {});

/// Moves lists of names and numbers into the header of the table below them, as the lines "Load
/// [N];75" below "Compound;A12", where a table with two columns of numbers follows; and so single
/// rows of numbers with names, "Load [N];T [C]" above "75;20".
void moveListsAbove(TextTable& table);

/// Returns the quantity that a name, in lower case without blanks and brackets, and a unit state;
/// empty where it is none of those meant.
using StatedQuantity = std::function<std::string(const std::string& name, const std::string& unit)>;

/// Returns the lines below the last table each of whose clauses is the name, the number and the
/// unit of such a quantity and nothing else: "T = 20 \u00B0C; Load 50 N". Lines about who measured
/// it, when, and on which size of a sample may stand among them; any other line ends them, because
/// what stands below it may be of something else. None where a line states a duration.
std::vector<TextEntry> statedBelow(const TextTable& table, const StatedQuantity& quantityOf);

/// Gives the names of a table to numbers below it that have none and as many columns, where each
/// line between them is one of those above the table with another value of such a quantity:
/// "T = 5 \u00B0C, dry" above the first rows and "T = 20 \u00B0C, dry" above the others. No column
/// has these quantities; the name may be empty, as in "20 \u00B0C". isTable: whether a table is one
/// whose names count. Returns notes on them.
std::vector<Message> repeatNames(TextTable& table,
                                 const std::function<bool(const TextBlock&)>& isTable,
                                 const StatedQuantity& quantityOf);

/// Replaces logarithms by the quantities themselves in columns with names such as "log10(f/Hz)",
/// "lg G' (Pa)", "ln v", and changes these names accordingly. isQuantity: whether the caller knows
/// a name without the logarithm.
void undoLogarithms(TextTable& table, const std::function<bool(const std::string&)>& isQuantity);

/// Returns a column whose numbers hold for the rows below them up to the next one, as merged cells
/// of a spreadsheet do; nothing where it is none: at least half of the rows with a number in the
/// other column have none.
std::optional<std::vector<double>> filledDown(const TextBlock& block, std::size_t column,
                                              std::size_t other);

/// Says that a column was read so. name: of the column.
Message standsInFirstRows(const std::string& name);

/// Says that the marks in the numbers may separate thousands as well (TextDialect::isUnclear).
Message unclearMark(char decimal);

/// Says which lines that begin with a number are no rows (TextTable::leftOut), and that the marks
/// in a column may be decimal marks (TextDialect::hasThousandsAlone).
std::vector<Message> doubtsAbout(const TextTable& table);

/// Refuses a table whose marks are unclear, where nobody would see the note. Throws InputError.
void refuseUnclearMark(const TextTable& table, const std::string& name);

/// Returns whether a column counts the rows: 0, 1, 2, ... or 1, 2, 3, ...
bool countsRows(const TextBlock& block, std::size_t column);

}  // namespace asperity
