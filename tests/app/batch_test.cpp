// asperity batch: a page, a sheet, a table; bad entries told and passed over.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/embedded_provenance.h"
#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
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
};

/// The row of results.csv with this name, by its columns.
std::map<std::string, std::string> rowOf(const std::string& csv, const std::string& name) {
  std::istringstream lines(csv);
  std::string line;
  std::vector<std::string> columns;
  while (std::getline(lines, line)) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    if (columns.empty()) columns = cells;
    if (cells.front() != name) continue;
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = cells.at(i);
    return row;
  }
  return {};
}

TEST_F(BatchTest, SweepsMakeAGridWithPicturesDataAndAPage) {
  write(R"({"name": "grid", "scene": "s.json", "set": {"sweep.points": 3},
            "sweep": {"load.normal_force": {"from": "10 mN", "to": 1, "points": 3},
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

/// Measured friction that the scene names is drawn and in the table, as by asperity curve, and
/// local friction is on the page and in the table of all scenes.
TEST_F(BatchTest, ShowsMeasuredAndLocalFriction) {
  program.folder.write("data.csv", "velocity,mu\n0.01,0.02\n1,0.03\n");
  write(R"({"name": "a", "scene": "s.json", "show": "curve",
            "set": {"sweep.points": 3, "interface.friction_coefficient": 0.25,
                    "comparison.data": [{"file": "data.csv"}]}},
           {"name": "gone", "scene": "s.json", "show": "curve",
            "set": {"sweep.points": 3, "comparison.data": [{"file": "gone.csv"}]}})");
  const Said said = program.run("batch b.json -o out/new --json");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.err, AllOf(HasSubstr("gone: "), HasSubstr("gone.csv")));
  EXPECT_THAT(read("out/new/a.csv"),
              AllOf(HasSubstr("\nseries,velocity,mu"), HasSubstr("\ndata,0.01,0.02,")));
  const auto scene = nlohmann::json::parse(said.out)["scenes"][0];
  const double mu = scene["mu"].get<double>();
  EXPECT_EQ(scene["mu_total"].get<double>(), mu + 0.25);
  auto row = rowOf(read("out/new/results.csv"), "a");
  EXPECT_NEAR(std::stod(row["mu_total"]), mu + 0.25, 1e-12);
  EXPECT_THAT(read("out/new/index.html"), HasSubstr("<td>with local friction</td>"));
  // Its tables are those of every language.
  const Said german = program.run("batch b.json -o out/de --language de");
  EXPECT_EQ(german.status, 1);
  const auto rowsOf = [](const std::string& csv) { return csv.substr(csv.find("\nseries,")); };
  EXPECT_EQ(rowsOf(read("out/de/a.csv")), rowsOf(read("out/new/a.csv")));
  // A run that continues says once more how the data were read: the other entry failed.
  const Said continued = program.run("batch b.json -o out/new --json");
  EXPECT_EQ(nlohmann::json::parse(continued.out)["scenes"],
            nlohmann::json::parse(said.out)["scenes"]);
  // The scene of the folder finds the files of the scene that it was made from.
  const Said again = program.run("curve out/new/a.json -o again.csv");
  EXPECT_EQ(again.status, 0) << again.err;
}

TEST_F(BatchTest, WhatShowsAllScenesNamesThemAndIsNotOpenedAsOne) {
  write(R"({"name": "two", "scene": "s.json", "show": "contact",
            "sweep": {"surface.hurst": [0.4, 0.8]}})");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  for (const std::string name : {"contact_sheet.png", "results.csv"}) {
    const std::string bytes = read("out/" + name);
    const auto made = nlohmann::json::parse(embeddedProvenance(bytes));
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
                              HasSubstr("1.5 is outside 0 to 1"), HasSubstr("swoop: unknown key"),
                              HasSubstr("occurs twice")));
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"good.png", "partly_01.png"}));
  EXPECT_THAT(read("out/index.html"), HasSubstr("5 of them failed"));
}

/// A missed target is told at the end; what was computed stays, with its picture.
TEST_F(BatchTest, AMissedTargetHasItsPictureAndIsToldAtTheEnd) {
  write(R"({"name": "curve", "scene": "s.json", "show": "curve",
            "set": {"surface.kind": "sine", "accuracy.target_relative_error": 1e-17}},
           {"name": "mean", "scene": "s.json", "show": "contact",
            "set": {"surface.kind": "sine", "accuracy.target_relative_error": 1e-17}},
           {"name": "met", "scene": "s.json", "show": "contact"})");
  for (int run = 0; run < 2; ++run) {
    const Said said = program.run("batch b.json -o out");
    EXPECT_EQ(said.status, 1);
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 2) << said.err;
    EXPECT_THAT(said.err, AllOf(HasSubstr("b.json: curve: accuracy.target_relative_error is not"),
                                HasSubstr("b.json: mean: accuracy.target_relative_error is not")));
    EXPECT_THAT(said.out,
                AllOf(HasSubstr("3 scenes, 0 failed"), HasSubstr("target accuracy missed: 2")));
  }
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"curve.png", "curve.csv", "mean.png"}));
  EXPECT_THAT(read("out/index.html"), AllOf(HasSubstr("src=\"curve.png\""),
                                            HasSubstr("is not reached"), Not(HasSubstr("failed"))));
  const std::string table = read("out/results.csv");
  auto row = rowOf(table, "curve");
  EXPECT_THAT(row["mu"], Not(testing::IsEmpty()));
  EXPECT_THAT(row["error"], HasSubstr("is not reached"));
  EXPECT_EQ(rowOf(table, "met")["error"], "");
}

/// What no scene can be is wrong with the file: nothing is written.
TEST_F(BatchTest, ASweepThatCannotBeIsRefusedWithItsEntry) {
  const auto refused = [&](const std::string& sweep, const std::string& message) {
    write(R"({"name": "a", "scene": "s.json", "show": "contact"},
             {"name": "b", "scene": "s.json", "sweep": {)" +
          sweep + "}}");
    expectRefused("batch b.json -o none", 2, "b.json: entries[1].sweep." + message);
    EXPECT_FALSE(std::filesystem::exists(program.folder / "none"));
  };
  refused(R"("surface.hurts": [0.5])",
          "surface.hurts: unknown key; the nearest known one is surface.hurst");
  refused(R"("surface.hurst": [])", "surface.hurst: has no value");
  refused(R"("surface.seed": {"from": 0, "to": 1, "points": 3})",
          "surface.seed: a logarithmic range needs");
  refused(R"("surface.hurst": {"from": 0.1, "to": 1, "points": 3, "scale": "cubic"})",
          "surface.hurst.scale: cubic is not one of log, linear");
  refused(R"("surface.hurst": {"from": 0.1, "points": 3})",
          "surface.hurst.to: is missing; it needs a number");
}

TEST_F(BatchTest, AnEmptyNameIsToldWithItsEntry) {
  write(R"({"name": "a", "scene": "s.json", "show": "contact"}, {"name": ""})");
  EXPECT_THAT(program.run("batch b.json -o out").err, HasSubstr("entries[1].name: is empty"));
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

TEST_F(BatchTest, TheCoefficientIsTheMeanOfTheLinesAndTheLinesOwnStandsBeside) {
  write(R"({"name": "many", "scene": "s.json", "show": "contact"},
           {"name": "one", "scene": {"surface": {"kind": "sine"}}, "show": "contact"},
           {"name": "motion", "scene": "s.json", "set": {"sliding.kind": "start"}})");
  const Said said = program.run("batch b.json -o out --json");
  ASSERT_EQ(said.status, 0) << said.err;
  // The curve at the scene's own velocity is the same mean.
  const std::string at =
      " --set sweep.velocity_from=1 --set sweep.velocity_to=1 --set sweep.points=1";
  const auto curve = nlohmann::json::parse(program.run("curve s.json --json -o c.json" + at).out);
  const auto line = nlohmann::json::parse(program.run("render s.json --json -o c.png").out);
  const auto& mean = curve["points"][0];
  const std::string table = read("out/results.csv");
  auto many = rowOf(table, "many"), one = rowOf(table, "one"), motion = rowOf(table, "motion");
  for (const char* column : {"mu", "mu_standard_error", "contact_fraction", "indentation"})
    EXPECT_EQ(std::stod(many[column]), mean[column].get<double>()) << column;
  EXPECT_EQ(many["realizations"], "6");
  EXPECT_EQ(std::stod(many["line_mu"]), line["mu"].get<double>());
  EXPECT_NE(many["line_mu"], many["mu"]);
  EXPECT_EQ(std::stod(many["line_indentation"]), line["indentation"].get<double>());
  EXPECT_EQ(one["realizations"], "1");
  EXPECT_EQ(one["mu_standard_error"], "");
  EXPECT_NEAR(std::stod(one["mu"]), std::stod(one["line_mu"]), 1e-9);
  EXPECT_EQ(motion["mu"] + motion["indentation"] + motion["realizations"], "");
  EXPECT_NE(motion["line_mu"], "");
  const auto answer = nlohmann::json::parse(said.out)["scenes"][0];
  EXPECT_EQ(answer["mu"], mean["mu"]);
  EXPECT_EQ(answer["mu_standard_error"], mean["mu_standard_error"]);
  EXPECT_EQ(answer["line_mu"], line["mu"]);
  const std::string page = read("out/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("coefficient of friction, mean of 6 lines"), HasSubstr(" ± "),
                          HasSubstr("(line shown: "), HasSubstr("3 scenes.")));
}

TEST_F(BatchTest, NamesThatWouldOverwriteAFileAreRefusedBeforeAnythingRuns) {
  const std::string sweep =
      R"({"name": "a", "scene": "s.json", "sweep": {"surface.seed": [1, 2]}})";
  write(sweep + R"(, {"name": "a_01", "scene": "s.json"})");
  expectRefused("batch b.json -o out", 2,
                "b.json: entries[1].name: 'a_01' would write a_01.png, as entries[0] does");
  write(R"({"name": "a_02", "scene": "s.json"},)" + sweep);
  expectRefused("batch b.json -o out", 2, "entries[1].name: 'a_02' would write a_02.png");
  for (const auto& [name, file] : {std::pair{"results", "results.csv"},
                                   {"contact_sheet", "contact_sheet.png"},
                                   {"contact_sheet_2", "contact_sheet_2.png"}}) {
    write(R"({"scene": "s.json"}, {"scene": "s.json", "name": ")" + std::string(name) + "\"}");
    expectRefused(
        "batch b.json -o out", 2,
        std::string("entries[1].name: '") + name + "' would write " + file + ", which holds");
  }
  // Harmless: no file of theirs has the name of another.
  write(R"({"name": "index", "scene": "s.json", "show": "contact"},
           {"name": "contact_sheets", "scene": "s.json", "show": "contact"},)" +
        sweep);
  EXPECT_EQ(program.run("batch b.json -o out").status, 0);
}

TEST_F(BatchTest, NoOutputReplacesAFileThatIsRead) {
  write(R"({"name": "s", "scene": "s.json"})");
  expectRefused("batch b.json -o .", 2, "s.json is also an input file");
  program.folder.write("p.csv", "0\n1e-6\n0\n-1e-6\n");
  program.folder.write("q.json",
                       R"({"surface": {"kind": "profile", "file": "p.csv", "length": 1e-3}})");
  write(R"({"name": "p", "scene": "q.json", "show": "contact"})");
  expectRefused("batch b.json -o .", 2, "p.csv is also an input file");
}

TEST_F(BatchTest, TallPicturesFindRoomOnTheSheet) {
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "size": "200x12000", "entries": [
      {"name": "tall", "scene": "s.json", "show": "contact", "sweep": {"surface.seed": [1, 2]}}]})");
  const Said said = program.run("batch b.json -o out");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"contact_sheet.png", "index.html"}));
}

TEST_F(BatchTest, WhatWasFoundIsKeptWhereASheetCannotBeWritten) {
  write(R"({"name": "a", "scene": "s.json", "show": "contact"})");
  // A folder under the sheet's name stands for whatever makes it fail.
  std::filesystem::create_directories(program.folder / "out/contact_sheet.png");
  const Said said = program.run("batch b.json -o out");
  EXPECT_NE(said.status, 0);
  EXPECT_THAT(said.err, HasSubstr("contact_sheet.png"));
  EXPECT_THAT(rowOf(read("out/results.csv"), "a")["mu"], Not(testing::IsEmpty()));
  EXPECT_THAT(read("out/index.html"), HasSubstr("a.png"));
}

TEST_F(BatchTest, ManyScenesHaveAContactSheetOnlyIfItIsAskedFor) {
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "size": "200x200", "entries": [
      {"name": "a", "scene": "s.json", "show": "contact", "set": {"surface.elements": 50},
       "sweep": {"surface.seed": {"from": 1, "to": 101, "points": 101, "spacing": "linear"}}}]})");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  EXPECT_THAT(program.folder.names("out"), Not(Contains("contact_sheet.png")));
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"a_101.png", "results.csv"}));
  EXPECT_THAT(read("out/index.html"), Not(HasSubstr("contact_sheet")));
  ASSERT_EQ(program.run("batch b.json -o out --contact-sheet").status, 0);
  EXPECT_THAT(program.folder.names("out"), Contains("contact_sheet.png"));
}

TEST_F(BatchTest, GoesOnAfterItWasKilled) {
  write(R"({"name": "a", "scene": "s.json", "show": "both", "set": {"ensemble.realizations": 20},
            "sweep": {"surface.seed": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}})");
  ASSERT_EQ(program.run("batch b.json -o whole").status, 0);
  // The program is killed as soon as the third scene is noted as done.
  program.run(
      "batch b.json -o out & child=$!; for i in $(seq 3000); do "
      "[ $(wc -l <out/.asperity_batch_progress || echo 0) -ge 3 ] && break; "
      "kill -0 $child || break; sleep 0.002; done; kill -KILL $child; wait");
  ASSERT_THAT(program.folder.names("out"), Contains(".asperity_batch_progress"));
  ASSERT_THAT(program.folder.names("out"), Not(Contains("results.csv")));
  const auto before = std::filesystem::last_write_time(program.folder / "out/a_01.csv");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(program.folder / "out/a_01.csv"), before);
  EXPECT_THAT(program.folder.names("out"),
              testing::UnorderedElementsAreArray(program.folder.names("whole")));
  for (const std::string& name : program.folder.names("whole"))
    EXPECT_EQ(read("out/" + name), read("whole/" + name)) << name;
}

TEST_F(BatchTest, OneSceneIsCalledOne) {
  write(R"({"name": "a", "scene": "s.json", "show": "contact"})");
  ASSERT_EQ(program.run("batch b.json -o out").status, 0);
  EXPECT_THAT(read("out/index.html"),
              AllOf(HasSubstr("One scene."), HasSubstr("All on one sheet")));
}

}  // namespace
}  // namespace asperity
