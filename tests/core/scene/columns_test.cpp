// The dictionary of columns in itself; that every table written has its columns there is tested
// with the program (tests/app/motion_test.cpp) and by the compiler (ColumnName).
#include "core/scene/columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/scene/parameters.h"

namespace asperity {
namespace {

TEST(Columns, EachIsDescribedOnceForATable) {
  std::set<std::pair<std::string, std::string>> seen;
  const auto json = nlohmann::json::parse(columnsJson());
  EXPECT_EQ(json["schema"], "asperity-columns/1");
  for (const auto& column : json["columns"]) {
    EXPECT_FALSE(column["name"].get<std::string>().empty());
    EXPECT_EQ(column["meaning"].get<std::string>().back(), '.') << column;
    EXPECT_FALSE(column["tables"].empty()) << column;
    for (const auto& table : column["tables"])
      EXPECT_TRUE(seen.emplace(column["name"], table).second) << column;
  }
  // Beside the dictionary and the keys there are the last words of keys, which name the axes of
  // curves and maps.
  const auto isSide = [](const auto& column) {
    return column["tables"] == nlohmann::json{"curve over it", "map"};
  };
  const auto sides = std::count_if(json["columns"].begin(), json["columns"].end(), isSide);
  EXPECT_GT(sides, 20);
  EXPECT_EQ(json["columns"].size(),
            kColumns.size() + parameters().size() + static_cast<std::size_t>(sides));
}

/// A column may be listed alone, so that its sentence cannot lean on the row before it.
TEST(Columns, EachIsDescribedByItsOwnSentence) {
  for (const Column& column : kColumns)
    EXPECT_EQ(column.meaning.find("likewise"), column.meaning.npos) << column.name;
}

TEST(Columns, TheTextNamesAllWithTheirUnits) {
  const std::string text = columnsText();
  for (const Column& column : kColumns) {
    EXPECT_NE(text.find(column.meaning), text.npos) << column.name;
    const std::string unit = column.unit.empty() ? "" : " [" + std::string(column.unit) + "]";
    EXPECT_NE(("\n" + text).find("\n" + std::string(column.name) + unit + "\n"), text.npos);
  }
}

}  // namespace
}  // namespace asperity
