#include "core/scene/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/scene/columns.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOption = "--columns";

std::string cellText(const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return csvNumber(*number);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *count);
  return csvCell(std::get<std::string>(cell));
}

Json jsonCell(const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return numberOrNull(*number);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return *count;
  return std::get<std::string>(cell);
}

/// Returns the cells of a line as they are written, with their quotes. A quoted cell may contain
/// line ends, so the line ends where `at` stands afterwards.
std::vector<std::string_view> cellsAt(std::string_view csv, std::size_t& at) {
  std::vector<std::string_view> cells;
  std::size_t start = at;
  for (bool isQuoted = false;; ++at) {
    const bool isEnd = at >= csv.size() || (csv[at] == '\n' && !isQuoted);
    if (isEnd || (csv[at] == ',' && !isQuoted)) {
      cells.push_back(csv.substr(start, at - start));
      start = at + 1;
    } else if (csv[at] == '"') {
      isQuoted = !isQuoted;
    }
    if (isEnd) break;
  }
  ++at;
  return cells;
}

/// Returns where the line of names begins.
std::size_t afterComments(std::string_view csv) {
  std::size_t at = 0;
  while (at < csv.size() && csv[at] == '#') at = std::min(csv.find('\n', at), csv.size() - 1) + 1;
  return at;
}

std::set<std::string_view> columnsOf(const std::vector<std::string_view>& tables) {
  std::set<std::string_view> names;
  for (const Column& column : kColumns)
    for (const std::string_view table : tables)
      if (isOneOf(table, splitText(column.tables, ", "))) names.insert(column.name);
  return names;
}

}  // namespace

std::string csvCell(std::string_view text) {
  // "#" begins a comment where R and pandas are told so, even within a row.
  if (text.find_first_of(",\"\r\n#") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvLine(const std::vector<TableCell>& row) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + cellText(row[i]);
  return text + "\n";
}

Json jsonObject(const std::vector<std::string>& columns, const std::vector<TableCell>& row) {
  Json object;
  for (std::size_t i = 0; i < row.size(); ++i) object[columns[i]] = jsonCell(row[i]);
  return object;
}

std::string tableCsv(const DataTable& table) {
  std::string text = csvLine({table.columns.begin(), table.columns.end()});
  for (const std::vector<TableCell>& row : table.rows) text += csvLine(row);
  return text;
}

Json tableJson(const DataTable& table) {
  Json rows = Json::array();
  for (const std::vector<TableCell>& row : table.rows)
    rows.push_back(jsonObject(table.columns, row));
  return rows;
}

ColumnChoice::ColumnChoice(const std::string& words, const std::vector<std::string_view>& tables) {
  if (words.empty()) return;
  const std::set<std::string_view> known = columnsOf(tables);
  const std::vector<std::string_view> list(known.begin(), known.end());
  for (const std::string_view word : splitText(words, ",")) {
    const bool isKey = std::ranges::any_of(parameters(), [&](const Parameter& row) {
      return row.key == word || columnOfKey(row.key) == word;
    });
    if (!known.contains(word) && !isKey) {
      const std::string_view nearest = nearestWord(word, list);
      throw InputError(
          "", kOption,
          nearest.empty()
              ? message("'{}' is not a column of this table; 'asperity columns' lists all",
                        shortened(word))
              : message("'{}' is not a column of this table; did you mean '{}'?", shortened(word),
                        nearest));
    }
    if (isOneOf(word, columns_))
      throw InputError("", kOption, message("'{}' is given more than once", shortened(word)));
    columns_.emplace_back(word);
  }
}

std::string ColumnChoice::select(std::string csv) const {
  if (isAll()) return csv;
  std::size_t at = afterComments(csv);
  std::string text = csv.substr(0, at) + fmt::format("{}\n", fmt::join(columns_, ","));
  const std::vector<std::string_view> names = cellsAt(csv, at);
  std::vector<std::size_t> indices;
  for (const std::string& column : columns_) {
    auto name = std::ranges::find(names, column);
    if (name == names.end()) name = std::ranges::find(names, columnOfKey(column));
    indices.push_back(static_cast<std::size_t>(name - names.begin()));
  }
  while (at < csv.size()) {
    const std::vector<std::string_view> cells = cellsAt(csv, at);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (i > 0) text += ",";
      if (indices[i] < cells.size()) text += cells[indices[i]];
    }
    text += "\n";
  }
  return text;
}

std::string ColumnChoice::selectAvailable(std::string csv) const {
  std::size_t at = afterComments(csv);
  const std::vector<std::string_view> names = cellsAt(csv, at);
  ColumnChoice known;
  for (const std::string& column : columns_)
    if (std::ranges::find(names, column) != names.end()) known.columns_.push_back(column);
  return known.select(std::move(csv));
}

Json ColumnChoice::select(const Json& rows) const {
  if (isAll()) return rows;
  Json chosen = Json::array();
  for (const Json& row : rows) {
    Json object;
    for (const std::string& column : columns_)
      object[column] = row.value(column, row.value(std::string(columnOfKey(column)), Json()));
    chosen.push_back(std::move(object));
  }
  return chosen;
}

}  // namespace asperity
