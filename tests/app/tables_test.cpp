// Tables of the program: what can be asked for, where it goes, and that each column is in the
// dictionary.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/columns.h"
#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class TablesTest : public ProgramTest {
 protected:
  /// The lines after the comment.
  static std::vector<std::string> lines(const std::string& csv) {
    std::vector<std::string> all;
    std::istringstream text(csv);
    for (std::string line; std::getline(text, line);)
      if (!line.starts_with('#')) all.push_back(line);
    return all;
  }
  static void expectInDictionary(const std::string& header, const std::string& table) {
    std::istringstream text(header);
    for (std::string word; std::getline(text, word, ',');)
      EXPECT_TRUE(std::ranges::any_of(
          kColumns,
          [&](const Column& column) {
            return column.name == word &&
                   (", " + std::string(column.tables) + ", ").find(", " + table + ", ") !=
                       std::string::npos;
          }))
          << word << " of " << table;
  }
};

TEST_F(TablesTest, TheContactAsTables) {
  for (const std::string table : {"shape", "contacts", "gaps", "power"}) {
    run("render s.json -o " + table + ".csv --table " + table);
    const std::string csv = read(table + ".csv");
    EXPECT_THAT(csv, StartsWith("# asperity: {\"schema\":\"asperity-render/1\""));
    expectInDictionary(lines(csv).front(), table);
    EXPECT_EQ(run("render s.json -o - --table " + table), csv);
    run("render s.json -o " + table + ".json --table " + table);
    const auto json = nlohmann::json::parse(read(table + ".json"));
    EXPECT_EQ(json["rows"].size() + 1, lines(csv).size());
    EXPECT_EQ(json["options"]["table"], table);
    EXPECT_GT(json["derived"]["contact_spots"], 0);
  }
  EXPECT_THAT(
      lines(read("shape.csv")).front(),
      StartsWith("position,rigid_height,surface_height,gap,line_load,time_in_contact,power"));
}

TEST_F(TablesTest, AMotionHasItsShapeAtAnyTime) {
  const std::string motion =
      "render s.json --set sliding.kind=start --set sliding.duration=0.002 -o - --at ";
  EXPECT_NE(run(motion + "0.001"), run(motion + "0.002"));
}

TEST_F(TablesTest, ReadingsAndDerivedNumbersAreInTheAnswer) {
  const auto answer =
      nlohmann::json::parse(run("render s.json -o a.png --size 320x200 --probe 0.01 --json"));
  EXPECT_NEAR(answer["probe"]["position"], 0.01, 1e-4);
  for (const char* name : {"rigid_height", "surface_height", "gap", "line_load", "slope"})
    EXPECT_TRUE(answer["probe"].contains(name)) << name;
  EXPECT_GT(answer["derived"]["largest_line_load"], 0);
}

TEST_F(TablesTest, RealizationsAreBehindTheMeans) {
  run("curve s.json -o c.csv --realizations-table r.csv --columns mu");
  const auto rows = lines(read("r.csv"));
  expectInDictionary(rows.front(), "realizations");
  ASSERT_EQ(rows.size(), 1U + 6 * 5);
  double first = 0;
  for (std::size_t line = 0; line < 6; ++line) {
    std::istringstream cells(rows[1 + 5 * line]);
    std::string cell;
    for (int i = 0; i < 3; ++i) std::getline(cells, cell, ',');
    first += std::atof(cell.c_str()) / 6;
  }
  EXPECT_NEAR(first / std::atof(lines(read("c.csv"))[1].c_str()), 1, 1e-12);
  // Without --output the table of the curve still goes to standard output.
  EXPECT_EQ(run("curve s.json --realizations-table r.csv --columns mu"), read("c.csv"));
  expectRefused("curve s.json --realizations-table r.txt", 2, "is not one of .csv, .json");
  expectRefused("curve s.json --realizations-table x.csv --set accuracy.target_relative_error=0.1",
                2, "--realizations-table: needs the same lines");
}

/// Where nothing computed can make room, a chart is refused before the work, which would take
/// hours; otherwise before the first file is written. The size that is named is enough.
TEST_F(TablesTest, NoFileIsWrittenWhereAChartHasNoRoom) {
  const std::string call =
      "curve s.json -o a.csv -o a.svg --realizations-table r.csv --compare linear:2:3 --size ";
  expectRefused(call + "600x160 --set ensemble.realizations=1000000 --set surface.elements=20000",
                2, "--size: 600x160 leaves no room for the difference", "timeout 60");
  const std::string said = program.run(call + "600x160").err;
  const std::size_t from = said.find("; ") + 2;
  const std::string enough = said.substr(from, said.find(" does") - from);
  const int least = std::stoi(enough.substr(enough.find('x') + 1));
  int refused = 0;
  for (int height = 160; height < least; height += 40) {
    const std::string small = call + "600x" + std::to_string(height);
    if (program.run(small).status == 0) break;
    expectRefused(small, 2, "--size: 600x");
    ++refused;
  }
  EXPECT_GT(refused, 1);
  run(call + enough);
  EXPECT_THAT(read("a.svg"), testing::HasSubstr("\u0394 (%)"));
}

TEST_F(TablesTest, ColumnsAreChosenInAnyTable) {
  EXPECT_EQ(lines(run("curve s.json --columns mu,velocity")).front(), "mu,velocity");
  EXPECT_EQ(lines(run("render s.json -o - --columns gap")).front(), "gap");
  EXPECT_EQ(lines(run("surface s.json -o - --columns height")).front(), "height");
  const std::string motion = "motion s.json --set sliding.kind=start --set sliding.duration=1e-3";
  EXPECT_EQ(lines(run(motion + " --columns mu,time")).front(), "mu,time");
  const auto json = nlohmann::json::parse(run("curve s.json --json --columns mu"));
  EXPECT_EQ(json["points"][0].size(), 1U);
  expectRefused("curve s.json --columns velocty", 2, "did you mean 'velocity'?");
  expectRefused("render s.json -o a.png --columns gap", 2, "--columns: belongs to tables");
  expectRefused("render s.json -o a.csv --theme dark", 2, "--theme: belongs to pictures");
  expectRefused("render s.json -o a.csv --table shap", 2, "shap is not one of shape, contacts");
  expectRefused("render s.json -o a.csv --frames 3", 2, "--frames: belongs to films");
  expectRefused("surface s.json -o a.png --table spectrum", 2, "--table: belongs to .csv");
}

TEST_F(TablesTest, SpectrumAndStatisticsOfTheLine) {
  const auto spectrum = lines(run("surface s.json -o - --table spectrum --quiet"));
  expectInDictionary(spectrum.front(), "spectrum");
  const auto values = lines(run("surface s.json -o - --table statistics --quiet"));
  expectInDictionary(values.front(), "statistics");
  // h^2 = 2 sum C dq.
  double squares = 0, first = 0;
  for (std::size_t i = 1; i < spectrum.size(); ++i) {
    if (i == 1) first = std::atof(spectrum[i].c_str());
    squares += 2 * first * std::atof(spectrum[i].substr(spectrum[i].find(',') + 1).c_str());
  }
  const auto height = std::ranges::find_if(
      values, [](const std::string& row) { return row.starts_with("rms_height,m,"); });
  ASSERT_NE(height, values.end());
  EXPECT_NEAR(std::sqrt(squares) / std::atof(height->substr(13).c_str()), 1, 1e-6);
}

TEST_F(TablesTest, StandardOutputCarriesItsProvenance) {
  const std::string out = run("curve s.json");
  EXPECT_THAT(out, StartsWith("# asperity: {\"schema\":\"asperity-curve/1\""));
  EXPECT_EQ(run("curve s.json -o -"), out);
  run("curve s.json -o a.csv");
  EXPECT_EQ(read("a.csv"), out);
}

}  // namespace
}  // namespace asperity
