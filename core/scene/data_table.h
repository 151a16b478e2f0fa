// Tables of results as plain values, and the choice of their columns: the same columns as CSV and
// as JSON, in the order that the user gives. Pure functions; equal tables give equal bytes.
// Failure: InputError naming --columns.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

/// A number in SI (not finite: not applicable, empty in CSV and null in JSON), a count, or a word.
using TableCell = std::variant<double, std::int64_t, std::string>;

struct DataTable {
  std::vector<std::string> columns;  // words of the dictionary (core/scene/columns.h)
  std::vector<std::vector<TableCell>> rows;
};

/// Returns a text as one cell of CSV: quoted where it contains a comma, a quote or a line end
/// (RFC 4180), or "#", which begins a comment for R and pandas.
std::string csvCell(std::string_view text);

/// Return one row as a line of CSV and as an object, for tables that are too long to keep all their
/// cells.
std::string csvLine(const std::vector<TableCell>& row);
nlohmann::ordered_json jsonObject(const std::vector<std::string>& columns,
                                  const std::vector<TableCell>& row);

/// Returns a line of names and one line for each row.
std::string tableCsv(const DataTable& table);

/// Returns a list of objects, one for each row.
nlohmann::ordered_json tableJson(const DataTable& table);

/// The columns that a user wants of the tables that a command writes.
class ColumnChoice {
 public:
  /// All columns, as they are.
  ColumnChoice() = default;

  /// Reads "a,b,c". tables: names of the dictionary that the command can write; a word that is a
  /// column of none of them and no scene key's last word is refused, with the nearest one that is.
  ColumnChoice(const std::string& words, const std::vector<std::string_view>& tables);

  bool isAll() const { return columns_.empty(); }

  /// Returns the table with these columns alone, in their order. A key stands for the column of its
  /// last word where the table has none of the whole key. A column that this table lacks,
  /// because its scene gives it no meaning, is empty. csv: a line of names, then rows; lines of
  /// comment before them stay.
  std::string select(std::string csv) const;
  /// Returns one of several tables that a command writes, with those of the columns that it has. A
  /// table that has none of them stays whole.
  std::string selectAvailable(std::string csv) const;
  /// Returns the same for a list of objects; a column that an object lacks is null.
  nlohmann::ordered_json select(const nlohmann::ordered_json& rows) const;

 private:
  std::vector<std::string> columns_;
};

}  // namespace asperity
