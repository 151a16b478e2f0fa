// asperity batch: a page, a sheet, a table; bad entries told and passed over.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/scene/provenance.h"
#include "tests/app/program_test.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class BatchTest : public ProgramTest {
 protected:
  void write(const std::string& entries) {
    program.folder.write("b.json", R"({"schema": "asperity-batch/1", "title": "Two & more",
                                       "size": "400x400", "entries": [)" +
                                       entries + "]}");
  }
  std::string read(const std::string& name) const {
    return TemporaryFolder::read(program.folder / name);
  }
};

TEST_F(BatchTest, SweepsMakeAGridWithPicturesDataAndAPage) {
  write(R"({"name": "grid", "scene": "s.json", "set": {"sweep.points": 3},
            "sweep": {"load.normal_force": {"from": 0.01, "to": 1, "points": 3},
                      "surface.hurst": [0.4, 0.8]}},
           {"scene": {"surface": {"kind": "sine"}}, "show": "contact"})");
  const Said said = program.run("batch b.json -o out --json");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("out"),
              IsSupersetOf({"index.html", "contact_sheet.png", "results.csv", "grid_01.png",
                            "grid_06.csv", "grid_06.json", "entry_2.png", "entry_2.json"}));
  const auto scenes = nlohmann::json::parse(said.out)["scenes"];
  ASSERT_EQ(scenes.size(), 7U);
  // The last key runs fastest; the range is logarithmic.
  const auto& fourth = scenes[3]["provenance"]["scene"];
  EXPECT_EQ(fourth["load"]["normal_force"], 0.1);
  EXPECT_EQ(fourth["surface"]["hurst"], 0.8);
  const std::string page = read("out/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("Two &amp; more"), HasSubstr("href=\"grid_03.csv\""),
                          HasSubstr("src=\"entry_2.png\""), Not(HasSubstr("http"))));
  EXPECT_THAT(read("out/results.csv"),
              HasSubstr("name,load.normal_force,surface.hurst,mu,indentation"));
  EXPECT_EQ(program.run("open out/grid_04.png --json").out, read("out/grid_04.json"));
}

TEST_F(BatchTest, WhatShowsAllScenesNamesThemAndIsNotOpenedAsOne) {
  write(R"({"name": "two", "scene": "s.json", "show": "contact",
            "sweep": {"surface.hurst": [0.4, 0.8]}})");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  for (const std::string name : {"contact_sheet.png", "results.csv"}) {
    const std::string bytes = read("out/" + name);
    const auto made = nlohmann::json::parse(findProvenance(bytes));
    ASSERT_EQ(made["scenes"].size(), 2U) << name;
    EXPECT_EQ(made["scenes"][1]["scene"], nlohmann::json::parse(read("out/two_02.json"))) << name;
    const Said said = program.run("open out/" + name + " --json");
    EXPECT_EQ(said.status, 2) << name;
    EXPECT_THAT(said.err, HasSubstr("shows many scenes")) << name;
  }
}

TEST_F(BatchTest, ABadEntryIsToldAndTheOthersGoOn) {
  write(R"({"name": "good", "scene": "s.json", "show": "contact"},
           {"name": "gone", "scene": "gone.json"},
           {"name": "partly", "scene": "s.json", "show": "contact",
            "sweep": {"surface.hurst": [0.5, 1.5]}},
           {"name": "odd", "swoop": 1}, {"name": "good"}, 7)");
  const Said said = program.run("batch b.json -o out");
  EXPECT_EQ(said.status, 1);
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 5) << said.err;
  EXPECT_THAT(said.err, AllOf(HasSubstr("asperity: b.json: gone: "), HasSubstr("gone.json"),
                              HasSubstr("1.5 is outside 0 to 1"), HasSubstr("'swoop' is unknown"),
                              HasSubstr("stands twice")));
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"good.png", "partly_01.png"}));
  EXPECT_THAT(read("out/index.html"), HasSubstr("5 of them failed"));
}

/// Whatever a file says, the page shows it as text: titles, names, values and errors.
TEST_F(BatchTest, ThePageHoldsNoMarkupOfItsScenes) {
  const std::string evil = R"(<script>alert('x')</script> \"><img src=x onerror=\"y\"> & more)";
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "size": "300x300", "title": ")" +
                                     evil +
                                     R"(", "entries": [
      {"name": "a", "show": "contact", "scene": {"title": ")" +
                                     evil +
                                     R"(", "surface": {"elements": 64}}},
      {"name": "b", "show": "contact", "scene": {"surface": {"elements": 64}},
       "sweep": {"title": [")" + evil +
                                     R"(", "plain"]}},
      {"name": "c", "scene": ")" + evil +
                                     R"(.json"},
      {"name": "d", "scene": {"title": "x", ")" +
                                     evil + R"(": 1}},
      {"name": ")" + evil + R"(", "show": "contact", "scene": {"surface": {"elements": 64}}}]})");
  const Said said = program.run("batch b.json -o out");
  EXPECT_EQ(said.status, 1) << said.err;
  const std::string page = read("out/index.html");
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<img src=x")),
                          Not(HasSubstr("onerror=\"y")), Not(HasSubstr("& more"))));
  // In the page's title and heading, in those of the scene and its picture, and in the errors.
  std::size_t shown = 0;
  for (std::size_t at = 0; (at = page.find("&lt;script&gt;", at)) != page.npos; ++at) ++shown;
  EXPECT_GE(shown, 7U);
  // Every tag is one of the page's own.
  for (std::size_t at = 0; (at = page.find('<', at)) != page.npos; ++at)
    EXPECT_THAT(
        page.substr(at, 12),
        testing::ContainsRegex("^</?(!DOCTYPE|html|head|meta|style|title|body|h1|h2|p|a|main|"
                               "article|img|table|tr|td)[ >]"));
}

/// A batch holds scenes, which hold sections: nothing of ours is deeper.
TEST_F(BatchTest, NestingHasALimit) {
  const auto nested = [](int levels) {
    std::string text = "1";
    for (int i = 0; i < levels; ++i) text = "[" + text + "]";
    return R"({"schema": "asperity-batch/1", "entries": )" + text + "}";
  };
  program.folder.write("b.json", nested(12));
  expectRefused("batch b.json -o out", 2, "b.json: entries: is nested too deeply");
  program.folder.write("b.json", nested(100000));
  expectRefused("batch b.json -o out", 2, "b.json: entries: is nested too deeply");
  program.folder.write("b.json", nested(11));
  EXPECT_THAT(program.run("batch b.json -o out").err, Not(HasSubstr("nested too deeply")));
}

TEST_F(BatchTest, TheSameBatchGivesTheSameBytes) {
  write(R"({"name": "a", "scene": "s.json", "sweep": {"surface.seed": [1, 2]}})");
  ASSERT_EQ(program.run("batch b.json -o x --threads 1").status, 0);
  ASSERT_EQ(program.run("batch b.json -o y --threads 2").status, 0);
  for (const std::string& name : program.folder.names("x"))
    EXPECT_EQ(read("x/" + name), read("y/" + name)) << name;
}

TEST_F(BatchTest, AFileThatIsNoBatchIsRefused) {
  program.folder.write("broken.json", "{");
  write("");
  expectRefused("batch b.json -o out", 2, "b.json: entries: needs a list");
  expectRefused("batch broken.json -o out", 2, "broken.json: is not valid JSON");
  expectRefused("batch s.json -o out", 2, "s.json: ");
  expectRefused("batch gone.json -o out", 2, "gone.json: cannot be opened");
  write(R"({"scene": "s.json", "sweep": {"surface.seed": {"from": 0, "to": 1, "points": 3}}})");
  EXPECT_THAT(program.run("batch b.json -o out").err, HasSubstr("logarithmic range needs"));
}

TEST_F(BatchTest, HelpShowsTheFormat) {
  EXPECT_THAT(program.run("batch --help").out, HasSubstr("asperity-batch/1"));
}

TEST_F(BatchTest, ShippedScenesAreFoundByName) {
  write(R"({"name": "shipped", "scene": "wedge.json", "show": "contact"})");
  EXPECT_EQ(program.run("batch b.json -o out").status, 0);
  program.folder.write("wedge.json", R"({"title": "our own"})");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  EXPECT_THAT(read("out/shipped.json"), HasSubstr("our own"));
}

}  // namespace
}  // namespace asperity
