#include "core/scene/data_table.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::HasSubstr;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(DataTable, IsTheSameInCsvAndJson) {
  const DataTable table{{"velocity", "mu", "notes"},
                        {{0.1, kNone, std::string("a,b \"c\"")}, {1e-300, std::int64_t{7}, "x"}}};
  EXPECT_EQ(tableCsv(table), "velocity,mu,notes\n0.1,,\"a,b \"\"c\"\"\"\n1e-300,7,x\n");
  EXPECT_EQ(tableJson(table).dump(), R"([{"velocity":0.1,"mu":null,"notes":"a,b \"c\""},)"
                                     R"({"velocity":1e-300,"mu":7,"notes":"x"}])");
}

/// R and pandas, told that "#" begins a comment, read a quoted cell whole.
TEST(DataTable, QuotesWhatWouldBeginAComment) {
  EXPECT_EQ(csvCell("specimen #3"), "\"specimen #3\"");
  EXPECT_EQ(csvCell("specimen 3"), "specimen 3");
}

TEST(ColumnChoice, KeepsOrderCommentsAndQuotes) {
  const std::string csv = "# asperity: {}\nvelocity,mu,notes\n1,2,\"a,\nb\"\"c\"\n3,,x\n";
  EXPECT_EQ(ColumnChoice("notes,velocity", {"curve"}).select(csv),
            "# asperity: {}\nnotes,velocity\n\"a,\nb\"\"c\",1\nx,3\n");
  EXPECT_EQ(ColumnChoice("", {"curve"}).select(csv), csv);
}

TEST(ColumnChoice, AColumnWithoutAMeaningHereIsEmpty) {
  EXPECT_EQ(ColumnChoice("mu,mu_total", {"curve"}).select(std::string("velocity,mu\n1,2\n")),
            "mu,mu_total\n2,\n");
  const auto rows = nlohmann::ordered_json::parse(R"([{"velocity":1,"mu":2}])");
  EXPECT_EQ(ColumnChoice("mu,mu_total", {"curve"}).select(rows).dump(),
            R"([{"mu":2,"mu_total":null}])");
}

/// A curve over load.normal_force has it as normal_force.
TEST(ColumnChoice, AKeyIsTheColumnOfItsLastWord) {
  const ColumnChoice choice("load.normal_force,mu", {"curve"});
  EXPECT_EQ(choice.select(std::string("normal_force,mu\n1,2\n")), "load.normal_force,mu\n1,2\n");
  EXPECT_EQ(choice.select(std::string("normal_force,load.normal_force,mu\n1,3,2\n")),
            "load.normal_force,mu\n3,2\n");
  const auto rows = nlohmann::ordered_json::parse(R"([{"normal_force":1,"mu":2}])");
  EXPECT_EQ(choice.select(rows).dump(), R"([{"load.normal_force":1,"mu":2}])");
}

TEST(ColumnChoice, RefusesWhatTheTableNeverHas) {
  const auto refusal = [](const std::string& words) {
    return errorFrom([&] { ColumnChoice(words, {"curve", "curves"}); });
  };
  EXPECT_THAT(refusal("velocty"),
              HasSubstr("--columns: 'velocty' is not a column of this table; did "
                        "you mean 'velocity'?"));
  EXPECT_THAT(refusal("line_load"), HasSubstr("is not a column of this table"));
  EXPECT_THAT(refusal("mu,mu"), HasSubstr("more than once"));
  EXPECT_THAT(refusal("mu,"), HasSubstr("''"));
  EXPECT_EQ(refusal("temperature"), "no error");  // the last word of a key that may be swept
}

}  // namespace
}  // namespace asperity
