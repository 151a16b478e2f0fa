#include "core/scene/columns.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kBatch = "batch", kMap = "map", kOverIt = "curve over it, map";

/// Returns the tables that have the column.
std::vector<std::string_view> tablesOf(const Column& column) {
  return splitText(column.tables, ", ");
}

/// Calls `use` for every column of the dictionary, then for the scene keys, which are columns of a
/// batch that varies them.
template <class Use>
void forEachColumn(const Use& use) {
  for (const Column& column : kColumns) use(column);
  for (const Parameter& row : parameters())
    use(Column{row.key, row.unit, row.sentence, row.symbol, kBatch});
  // Some columns of keys are columns of the table itself, with the same meaning, and several keys
  // may end with the same word.
  std::set<std::string_view> known;
  for (const Column& column : kColumns)
    if (isOneOf(kMap, tablesOf(column))) known.insert(column.name);
  for (const Parameter& row : parameters()) {
    const std::string_view word = columnOfKey(row.key);
    if (allowedRange(row) && known.insert(word).second)
      use(Column{word, row.unit, row.sentence, row.symbol, kOverIt});
  }
}

}  // namespace

std::vector<std::string> columnNames(std::initializer_list<ColumnName> names) {
  std::vector<std::string> words;
  for (const ColumnName name : names) words.push_back(name.text());
  return words;
}

std::string columnsText() {
  std::string text;
  forEachColumn([&](const Column& column) {
    const std::string unit = column.unit.empty() ? "" : fmt::format(" [{}]", column.unit);
    text += fmt::format("{}{}\n    {}\n", column.name, unit, column.meaning);
    if (!column.equation.empty()) text += fmt::format("    {}\n", column.equation);
    text += fmt::format("    in: {}\n", column.tables);
  });
  return text;
}

std::string columnsJson() {
  Json list = Json::array();
  forEachColumn([&](const Column& column) {
    list.push_back({{"name", column.name},
                    {"unit", column.unit},
                    {"meaning", column.meaning},
                    {"equation", column.equation},
                    {"tables", tablesOf(column)}});
  });
  const Json root = {{"schema", "asperity-columns/1"},
                     {"verb", "columns"},
                     {"version", ASPERITY_VERSION},
                     {"columns", std::move(list)}};
  return jsonFile(root);
}

}  // namespace asperity
