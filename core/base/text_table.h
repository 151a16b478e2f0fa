// Tables of numbers in text files, of whatever program or person wrote them: profiles, sweeps of a
// rheometer, measured friction. One reader finds encoding, separator, decimal mark, names, units,
// `key: value` lines and missing values; what the columns mean is up to its callers.
// Pure; any thread. Failure: InputError that names the file and the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_dialect.h"

namespace asperity {

struct TextColumn {
  std::string name{};   // without the unit; empty where the file has no names
  std::string unit{};   // as written ("\u00B5m", "rad/s"), from the name or from a row of units
  bool isText = false;  // labels, in TextBlock::texts
};

/// A line that is not a row of numbers: "key: value", "key = value", "key;value", "# key: value".
struct TextEntry {
  std::string key{};  // empty where the line has none
  std::string value{};
  std::size_t line = 0;  // counted from 1
};

/// Rows of equally many fields that follow each other. Blank lines and comments do not end it.
struct TextBlock {
  std::vector<TextColumn> columns{};
  std::size_t rows = 0;
  std::vector<double> values{};                   // rows x columns, row by row; NaN where missing
  std::vector<std::vector<std::string>> texts{};  // of each column; empty where it has numbers
  std::vector<TextEntry> header{};                // the lines between the block before and this one
  std::vector<std::uint32_t> lines{};             // of each row, counted from 1

  double at(std::size_t row, std::size_t column) const {
    return values[row * columns.size() + column];
  }
  std::vector<double> column(std::size_t number) const;
};

struct TextTable {
  std::string_view encoding{};  // "UTF-8", "UTF-16", "Latin-1"
  TextDialect dialect{};
  std::vector<TextBlock> blocks{};   // at least one
  std::vector<TextEntry> trailer{};  // lines behind the last block
  /// Numbers of lines that look like rows and are none: damaged ones right above a block, and those
  /// behind the last block that begin with a number.
  std::vector<std::uint32_t> leftOut{};

  /// The block with the most numbers, the first of those.
  const TextBlock& largest() const;
  /// The value of the nearest entry with this key in front of the block, its header or that of a
  /// block before it; letters large or small. Empty where there is none.
  std::string entry(std::string_view key, const TextBlock& block) const;
};

struct TextTableOptions {
  /// Columns whose first field is no number are kept as texts, if the columns have names. Else rows
  /// are of numbers alone.
  bool keepsTexts = false;
  /// Names (in lower case) of columns that are texts even where they look like numbers: labels.
  std::vector<std::string> textColumns{};
  /// In a table of one column a blank line between numbers is a row without a value, as
  /// spreadsheets write it, unless such a line follows every row.
  bool blankLinesAreGaps = false;
  /// Told the part that is read, 0 to 1, now and then. May throw to end the reading.
  std::function<void(double)> progress{};
};

/// Reads the bytes of a file, whose name stands in errors. A field that is no number amid rows of
/// numbers, or a row of another width, is an error; where such a line follows the last row of a
/// block, it ends the block.
TextTable readTextTable(std::string_view bytes, const std::string& name,
                        const TextTableOptions& options = {});

/// Replaces the numbers of columns whose names say logarithm ("log10(f/Hz)", "lg G' (Pa)", "ln v")
/// by their powers, and the names by those of the quantities. isQuantity: whether a name, without
/// the logarithm, is one that the caller knows.
void undoLogarithms(TextTable& table, const std::function<bool(const std::string&)>& isQuantity);

/// Says that the marks in the numbers may separate thousands as well (TextDialect::isUnclear).
Message unclearMark(char decimal);

/// Refuses a table whose marks are unclear, where nobody would see the note. Throws InputError.
void refuseUnclearMark(const TextTable& table, const std::string& name);

/// Whether a column counts the rows: 0, 1, 2, ... or 1, 2, 3, ...
bool countsRows(const TextBlock& block, std::size_t column);

}  // namespace asperity
