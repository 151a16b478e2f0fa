// asperity motion and columns: tables, pictures, refusals, and that no table has a column that the
// dictionary does not know.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/scene/provenance.h"
#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

constexpr const char* kHeader =
    "time,displacement,velocity,normal_force,tangential_force,mu,indentation,contact_fraction,"
    "contact_spots,power_in,power_dissipated,mu_interface,realization\n";

class MotionCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write(
        "m.json",
        R"({"title":"A stop","surface":{"elements":200},"load":{"normal_force":0.02},
                             "sliding":{"kind":"step","velocity":0.5,"velocity_after":0,
                             "duration":0.004}})");
  }

  std::size_t rows(const std::string& csv) const {
    return static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n'));
  }

  /// The names in a table's header, after the line that says how it was made.
  std::vector<std::string> header(const std::string& csv) const {
    std::istringstream lines(csv);
    std::string line, name;
    std::getline(lines, line);
    if (line.starts_with('#')) std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream cells(line); std::getline(cells, name, ',');) names.push_back(name);
    return names;
  }
};

/// A picture of few pixels at the density of print: its texts are larger than on a screen.
TEST_F(MotionCommandTest, ThePictureHasTextsOfItsScale) {
  const auto heading = [&](const std::string& options) {
    EXPECT_EQ(program.run("motion m.json -o a.svg --size 1016x760" + options).status, 0);
    const std::string picture = read("a.svg"), key = "font-size=\"";
    double largest = 0;
    for (std::size_t at = picture.find(key); at != picture.npos; at = picture.find(key, at + 1))
      largest = std::max(largest, std::stod(picture.substr(at + key.size(), 8)));
    return largest;
  };
  const double usual = heading("");
  EXPECT_GT(usual, 0);
  EXPECT_NEAR(heading(" --scale 300dpi") / usual, 300.0 / 96, 0.4);
}

TEST_F(MotionCommandTest, WritesTheTableThePictureAndHowTheyWereMade) {
  const Said said =
      program.run("motion m.json -o a.csv -o a.json -o a.png -o a.svg -o a.pdf --json");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(said.out, read("a.json"));
  EXPECT_THAT(said.err, AllOf(HasSubstr(" rows, estimated error of mu"), HasSubstr("wrote a.csv")));
  const std::string csv = read("a.csv");
  EXPECT_THAT(csv, StartsWith("# asperity: {\"schema\":\"asperity-motion/1\""));
  EXPECT_THAT(csv, HasSubstr(std::string("\n") + kHeader));
  const auto json = nlohmann::json::parse(said.out);
  EXPECT_EQ(json["points"].size(), rows(csv) - 2);
  EXPECT_EQ(json["points"][0]["mu_interface"], nullptr);
  EXPECT_GT(json["discretization_error"]["relative"], 0);
  EXPECT_THAT(read("a.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read("a.svg"), AllOf(HasSubstr("A stop"), HasSubstr("in contact")));
  for (const char* name : {"a.csv", "a.json", "a.png", "a.svg", "a.pdf"})
    EXPECT_EQ(program.run(std::string("open --json ") + name).out,
              program.run("open --json m.json").out)
        << name;
}

TEST_F(MotionCommandTest, WithoutAnOutputTheTableGoesToStdout) {
  const Said said = program.run("motion m.json --threads 1");
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(withoutComment(said.out), StartsWith(kHeader));
  EXPECT_EQ(said.err, "");
  EXPECT_EQ(program.run("motion m.json --threads 2 --quiet").out, said.out);
  const std::string whole = withoutComment(said.out);
  const std::string some = withoutComment(program.run("motion m.json --every 100").out);
  EXPECT_EQ(rows(some), 1 + (rows(whole) - 1 + 99) / 100);
  std::istringstream lines(some);
  for (std::string line; std::getline(lines, line);) EXPECT_THAT(said.out, HasSubstr(line + "\n"));
  const std::string three = withoutComment(program.run("motion m.json --lines 3").out);
  EXPECT_EQ(rows(three), 1 + 3 * (rows(whole) - 1));
  EXPECT_THAT(three, StartsWith(whole));
  EXPECT_EQ(withoutComment(program.run("motion m.json --lines 3 --threads 1").out), three);
}

TEST_F(MotionCommandTest, RefusesWhatItCannotDo) {
  expectRefused("motion s.json", 2, "s.json: sliding.kind: is steady, so nothing changes");
  expectRefused("motion m.json -o a.gif", 2, "a.gif: '.gif' is not one of");
  expectRefused("motion m.json --every 0", 2, "--every: 0 is outside 1 to ");
  expectRefused("motion m.json --lines 0", 2, "--lines: 0 is outside 1 to ");
  expectRefused("motion m.json --lines 2 --set surface.kind=sine", 2,
                "--lines: this surface has one line");
  expectRefused("motion m.json --set sliding.duration=1e5", 2, "--every: ");
  expectRefused("motion m.json -o a.csv --theme dark", 2, "--theme: belongs to pictures");
  expectRefused("motion m.json -o m.json", 2, "m.json is also an input file");
  expectRefused("columns m.json", 2, "unexpected argument 'm.json' for 'asperity columns'");
  expectRefused("columns --set surface.hurst=1", 2, "--set: unknown option of 'asperity columns'");
}

TEST_F(MotionCommandTest, ABatchWritesTheTableOfAMotion) {
  program.folder.write("b.json", R"({"schema":"asperity-batch/1","size":"400x600","entries":[
      {"name":"stop","scene":"m.json"},{"name":"still","scene":"m.json","show":"contact"}]})");
  const Said said = program.run("batch b.json -o out --json");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("out"), IsSupersetOf({"stop.png", "stop.csv", "stop.json"}));
  EXPECT_THAT(program.folder.names("out"), Not(testing::Contains("still.csv")));
  EXPECT_THAT(read("out/stop.csv"), HasSubstr(kHeader));
  EXPECT_THAT(read("out/index.html"), HasSubstr("href=\"stop.csv\""));
  EXPECT_EQ(program.run("open --json out/stop.csv").out, read("out/stop.json"));
}

TEST_F(MotionCommandTest, EveryColumnOfEveryTableIsInTheDictionary) {
  program.folder.write("i.json",
                       R"({"surface":{"elements":64},"interface":{"friction_coefficient":0.1},
      "sweep":{"points":2},"ensemble":{"realizations":2}})");
  program.folder.write("b.json", R"({"schema":"asperity-batch/1","size":"400x400","entries":[
      {"name":"a","scene":"i.json","sweep":{"load.normal_force":[1,2],"surface.hurst":[0.5]}}]})");
  const std::string small = " --set surface.elements=64 --set sweep.points=3";
  for (const std::string& call :
       {std::string("curve i.json -o interface.csv"),
        "curve s.json -o target.csv --set accuracy.target_relative_error=0.1" + small,
        "curve s.json -o set.csv --compare nodal" + small,
        std::string("motion m.json -o motion.csv"), std::string("surface s.json -o surface.csv"),
        "accuracy s.json -o cost" + small,
        std::string("figure paper -o figures --realizations 2 --set surface.elements=100"),
        std::string("figure master spacing -o figures --realizations 2"),
        std::string("batch b.json -o batch")}) {
    const Said said = program.run(call);
    ASSERT_EQ(said.status, 0) << call << said.err;
  }
  std::set<std::string> known;
  const auto dictionary = nlohmann::json::parse(program.run("columns --json").out);
  for (const auto& column : dictionary["columns"]) known.insert(column["name"]);
  int tables = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(program.folder.path())) {
    if (entry.path().extension() != ".csv") continue;
    ++tables;
    for (const std::string& name : header(TemporaryFolder::read(entry.path())))
      EXPECT_TRUE(known.contains(name)) << name << " of " << entry.path().filename();
  }
  EXPECT_GE(tables, 5 + 1 + 8 + 3);
}

TEST_F(MotionCommandTest, TheDictionaryIsReadByPeopleAndMachines) {
  const Said text = program.run("columns"), json = program.run("columns --json --quiet");
  EXPECT_THAT(text.out, AllOf(HasSubstr("tangential_force [N]\n"),
                              HasSubstr("F_x = -integral p z' dx"), HasSubstr("in: motion\n")));
  EXPECT_EQ(json.err, "");
  EXPECT_EQ(nlohmann::json::parse(json.out)["verb"], "columns");
  EXPECT_THAT(program.run("--help").out, AllOf(HasSubstr("motion"), HasSubstr("columns")));
}

}  // namespace
}  // namespace asperity
