// Options that are wrong, missing, contradictory, repeated or of no use: each is exit 2 and one
// line that names it, and nothing is written.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/program.h"

namespace asperity {
namespace {

using namespace std::string_literals;

constexpr const char* kStep =
    R"({"surface":{"elements":200},"sliding":{"kind":"step","duration":0.01}})";

class UsageTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write("step.json", kStep);
    program.folder.write("b.json", batch(""));
  }

  /// One small entry, and what else the file says.
  static std::string batch(const std::string& more) {
    return R"({"schema":"asperity-batch/1",)" + more +
           R"("entries":[{"name":"b","scene":{"surface":{"elements":64}},"show":"contact"}]})";
  }

  const std::vector<std::string> verbs_{
      "check s.json",        "curve s.json",           "explain s.json",  "surface s.json",
      "open s.json",         "render s.json -o a.png", "figure 3 -o out", "accuracy s.json -o out",
      "batch b.json -o out", "motion step.json",       "columns"};
};

TEST_F(UsageTest, EveryVerbRefusesWhatItCannotTake) {
  for (const std::string& verb : verbs_) {
    expectRefused(verb + " --threads -1", 2, "--threads: -1 is outside 0 to 1024");
    expectRefused(verb + " --threads some", 2, "--threads: 'some' is not a whole number");
    expectRefused(verb + " --threads", 2, "--threads: needs a value");
    expectRefused(verb + " --threads 1 --threads 2", 2, "--threads: is given more than once");
    expectRefused(verb + " --language ''", 2, "--language: is empty");
    expectRefused(verb + " --language fr", 2, "--language: fr is not one of en, de");
    expectRefused(verb + " --json=no", 2, "--json: takes no value");
    expectRefused(verb + " --timng", 2, "--timng: unknown option of 'asperity ");
    expectRefused(verb + " --timng", 2, "did you mean --timing?");
  }
}

TEST_F(UsageTest, AnActionThatIsMissingOrUnknownIsNamed) {
  expectRefused("study", 2,
                "asperity: study: needs one of run, merge, table, show, analyse behind");
  expectRefused("study stop", 2, "asperity: study: stop is not one of run, merge, table, show");
}

TEST_F(UsageTest, AFolderThatIsGoneIsNamedInOneSentence) {
  const std::string before = "mkdir gone; cd gone; rmdir ../gone; ";
  expectRefused("curve figure_2.json -o x.csv", 1, "asperity: x.csv: No such file", before);
}

/// The system refuses to look for a file of such a name.
TEST_F(UsageTest, NamesTooLongForAFileAreRefused) {
  const std::string name(300, 'a');
  expectRefused(name, 2, "unknown command 'aaa");
  expectRefused("material " + name + ".json -o out", 2, ".json: cannot be opened: ");
  expectRefused("render s.json -o " + name + ".txt", 2, "is neither a folder nor a .png");
}

TEST_F(UsageTest, WordsBeforeAVerbAreNotPassedOver) {
  for (const char* word : {"--threads 1", "--set load.normal_force=1", "--language de", "--timing",
                           "--quiet", "--json"})
    expectRefused(std::string(word) + " check s.json", 2, "must come after 'check'");
  expectRefused("s.json check s.json", 2, "SCENE: must come after 'check'");
}

TEST_F(UsageTest, AWordTooManyOrNoneIsTold) {
  expectRefused("explain s.json step.json", 2,
                "unexpected argument 'step.json' for 'asperity explain'");
  expectRefused("curve s.json -o a.csv b.csv", 2, "unexpected argument 'b.csv'");
  expectRefused("curve s.json --set load.normal_force=0.1 surface.hurst=0.5", 2,
                "--set stands before each KEY=VALUE");
  expectRefused("check ''", 2, "SCENE: is empty");
  expectRefused("figure -o out", 2, "NAME is required");
  expectRefused("--json s.json", 2, "--json: unknown option of 'asperity'");
}

TEST_F(UsageTest, AssignmentsAreSaidOfTheirOption) {
  expectRefused("check s.json --set nothing", 2, "asperity: --set: 'nothing' is not KEY=VALUE");
  expectRefused("check s.json --set =1", 2, "asperity: --set: '=1' is not KEY=VALUE");
}

TEST_F(UsageTest, NumbersHaveLimitsAndAreFinite) {
  const std::string film = "render s.json -o out ";
  expectRefused(film + "--frames 0", 2, "--frames: 0 is outside 1 to 1000000");
  expectRefused(film + "--frames 1.5", 2, "--frames: '1.5' is not a whole number");
  for (const char* option : {"--fps", "--duration", "--cycles", "--slow-motion"}) {
    expectRefused(film + option + " nan", 2, std::string(option) + ": 'nan' is not a number");
    expectRefused(film + option + " 0", 2, std::string(option) + ": 0 is outside ");
  }
}

TEST_F(UsageTest, WhatDoesNotGoTogetherIsSaidOfTheOption) {
  for (const char* film : {"render s.json -o a.gif ", "render step.json -o out "}) {
    expectRefused(std::string(film) + "--frames 5 --duration 3", 2,
                  "asperity: --duration: cannot be combined with --frames");
    expectRefused(std::string(film) + "--slow-motion 1e12", 2, "asperity: --slow-motion: ");
  }
  expectRefused("render step.json -o out --cycles 2", 2, "asperity: --cycles: belongs to steady");
  expectRefused("render step.json -o out --frames 3 --slow-motion 2", 2,
                "asperity: --slow-motion: follows from the motion");
  expectRefused("render s.json -o out --duration 1e6 --fps 1000", 2,
                "asperity: --duration: 10⁹ frames are more than 10⁶");
  expectRefused("render s.json -o out --cycles 1e6", 2, "asperity: --cycles: 6×10⁷ frames");
  expectRefused("render s.json -o a.gif --layout curve", 2,
                "asperity: --layout: curve cannot be a film");
}

/// As 1.3×10⁻⁵, not as 1.3e-05.
TEST_F(UsageTest, WhatIsPrintedForPeopleHasNoNumbersOfMachines) {
  const std::string small = " --set surface.elements=64 --set load.normal_force=1e-7";
  for (const char* verb :
       {"check s.json",
        "curve s.json -o a.csv --set accuracy.target_relative_error=1e-4 --set surface.kind=sine",
        "curve s.json -o a.csv --set accuracy.scheme=nodal", "render s.json -o a.png",
        "render step.json -o a.png", "accuracy s.json -o out", "explain s.json --analyze",
        "explain step.json", "surface s.json -o a.csv", "batch b.json -o pages"}) {
    const bool isBatch = std::string(verb).starts_with("batch");
    const Said said = program.run(verb + (isBatch ? std::string() : small));
    EXPECT_THAT(said.out + said.err, testing::Not(testing::ContainsRegex("[0-9]e[-+0-9]"))) << verb;
    EXPECT_FALSE(said.out.empty()) << verb << said.err;
  }
}

TEST_F(UsageTest, OnePictureHasNoTime) {
  for (const char* option :
       {"--frames 2", "--fps 30", "--duration 2", "--cycles 2", "--slow-motion 2"})
    for (const char* picture : {"render s.json -o a.png ", "render step.json -o a.svg "})
      expectRefused(std::string(picture) + option, 2, "is one picture; frames need a folder");
}

TEST_F(UsageTest, PictureOptionsNeedAPicture) {
  for (const char* option :
       {"--size 300x300", "--scale 2", "--theme dark", "--transparent", "--backend auto"})
    for (const char* verb : {"curve s.json ", "curve s.json -o a.csv -o a.json "})
      expectRefused(std::string(verb) + option, 2,
                    std::string(option).substr(0, std::string(option).find(' ')) +
                        ": belongs to pictures, and no output is one");
  for (const char* verb : {"curve s.json -o a.svg", "render s.json -o a.pdf"})
    expectRefused(std::string(verb) + " --backend osmesa", 2, "--backend: draws pixels");
  EXPECT_EQ(program.run("curve s.json -o a.csv -o a.png --theme dark").status, 0);
}

TEST_F(UsageTest, AnOutputStandsOnceAndReplacesNothingThatIsRead) {
  program.run("surface s.json -o line.csv");
  program.folder.write("p.json", R"({"surface":{"kind":"profile","file":"line.csv"}})");
  const std::string line = TemporaryFolder::read(program.folder / "line.csv");
  expectRefused("curve s.json -o a.csv -o ./a.csv", 2, "--output: ./a.csv is given more than once");
  expectRefused("render s.json -o a.png -o b.png", 2, "--output: is given more than once");
  for (const char* verb : {"curve", "surface"}) {
    expectRefused(std::string(verb) + " s.json -o s.json", 2, "s.json is also an input file");
    expectRefused(std::string(verb) + " p.json -o line.csv", 2, "line.csv is also an input file");
  }
  std::filesystem::rename(program.folder / "s.json", program.folder / "accuracy.json");
  expectRefused("accuracy accuracy.json -o .", 2, "accuracy.json is also an input file");
  expectRefused("batch b.json -o .", 2, "b.json is also an input file");
  EXPECT_EQ(TemporaryFolder::read(program.folder / "line.csv"), line);
}

TEST_F(UsageTest, ABatchIsToldWhereItsFileIsWrong) {
  program.folder.write("b.json", batch(R"("size":"3x3",)"));
  expectRefused("batch b.json -o out", 2, "b.json: size: 3x3 is not WIDTHxHEIGHT");
  program.folder.write("b.json", batch(R"("sise":"300x300",)"));
  expectRefused("batch b.json -o out", 2,
                "b.json: sise: unknown key; the nearest known one is size");
  program.folder.write("b.json", batch(R"("title":"a","title":"b",)"));
  expectRefused("batch b.json -o out", 2, "b.json: title: occurs twice");
  program.folder.write("b.json", R"({"schema": )");
  expectRefused("batch b.json -o out", 2, "b.json: is not valid JSON: line 1, column ");
}

TEST_F(UsageTest, AKeyIsSetOrSwept) {
  program.folder.write("b.json", R"({"schema":"asperity-batch/1","entries":[{"name":"one",
      "set":{"surface.hurst":0.5},"sweep":{"surface.hurst":[0.3,0.7]}}]})");
  const Said said = program.run("batch b.json -o out");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.err, testing::HasSubstr("one: surface.hurst: is in set and in sweep"));
}

TEST_F(UsageTest, HelpIsAlsoAWord) {
  EXPECT_EQ(program.run("help").out, program.run("--help").out);
  EXPECT_EQ(program.run("help render").out, program.run("render --help").out);
  EXPECT_THAT(program.run("help render").out,
              testing::AllOf(testing::HasSubstr("--fps 0.001 to 1000 "),
                             testing::HasSubstr("--slow-motion 1e-12 to 1e15")));
  expectRefused("help rendr", 2, "rendr");
}

TEST_F(UsageTest, TimeIsToldByEveryVerb) {
  for (const char* verb : {"check s.json", "explain s.json", "surface s.json"})
    EXPECT_THAT(program.run(std::string(verb) + " --timing").err, testing::StartsWith("time "));
}

/// The file that is missing behind a link is told before any work, and not after it.
TEST_F(UsageTest, ALinkThatLeadsNowhereIsTold) {
  for (const char* name : {"a.csv", "a.png", "a.mp4"})
    std::filesystem::create_symlink("gone/away", program.folder / name);
  // What cannot be computed in the time of a test would be computed first.
  const std::string endless = " --set ensemble.realizations=1000000 ";
  for (const char* verb :
       {"curve s.json -o a.csv", "curve s.json -o a.png", "render s.json --frames 100000 -o a.mp4",
        "render s.json -o a.png", "surface s.json -o a.csv"})
    expectRefused(verb + endless, 2, "is a link to 'gone/away', which does not exist");
}

/// What stands in names, keys, values and files reaches the terminal in printable characters.
TEST_F(UsageTest, MessagesQuotePrintableCharactersOnly) {
  program.folder.write("title.json",
                       R"({"title":"a\u001b[2Jb\u202ec\nd","surface":{"elements":64}})");
  program.folder.write("key.json", "{\"surf\\u001b[31mace\":1}");
  program.folder.write("bytes.json", "{\"title\":\"\xff\xfe\"}");
  program.folder.write("b.json",
                       R"({"schema":"asperity-batch/1","entries":[{"scene":"\u001b[31m"}]})");
  const std::string escape = "$(printf '\\033[31m')", bytes = "$(printf '\\377\\233')";
  for (const std::string& arguments : std::vector<std::string>{
           "check title.json", "explain title.json", "check key.json", "check bytes.json",
           "batch b.json -o out", "check \"" + escape + "\"", "check \"" + bytes + ".json\"",
           "check s.json --set \"" + escape + "=1\"",
           "check s.json --set \"surface.hurst=" + bytes + "\"",
           "check s.json --set \"surface.kind=" + escape + "\"",
           "check s.json --\"" + escape + "\"", "check s.json \"" + escape + "\"",
           "curve s.json -o \"no" + escape + "/a.csv\"", "curve s.json -o \"" + escape + ".csv\"",
           "render s.json -o \"" + bytes + ".png\"", "check s.json --threads \"" + escape + "\"",
           "check s.json --language \"" + bytes + "\"",
           "render s.json -o a.png --theme \"" + escape + "\"",
           "figure \"" + escape + "\" -o out"}) {
    const Said said = program.run(arguments);
    for (const std::string& text : {said.out, said.err})
      for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        ASSERT_TRUE(byte >= ' ' || byte == '\n') << arguments << ": byte " << int(byte);
        ASSERT_TRUE(byte < 0xF5 && byte != 0x7F) << arguments << ": byte " << int(byte);
      }
    EXPECT_THAT(said.out + said.err,
                testing::AnyOf(testing::HasSubstr("\\x1b"), testing::HasSubstr("\\xff")))
        << arguments;
    EXPECT_THAT(said.out + said.err, testing::Not(testing::HasSubstr("\u202e"))) << arguments;
  }
}

TEST_F(UsageTest, AnOutputWithoutAnEndingIsNamed) {
  expectRefused("surface figure_1 -o x", 2, "x: the file name has no extension; allowed is .csv");
}

TEST_F(UsageTest, AFileOfAnotherKindIsNamedAndNotQuoted) {
  program.folder.write("utf16.txt", "\xFF\xFEx\0 \0(\0m\0m\0)\0\r\0\n\0"s);
  program.folder.write("heights.csv", "x,z\n0,1e-6\n1,2e-6\n2,1e-6\n");
  const std::string needed =
      "a measured surface is a file that a scene names as surface.file, with surface.kind measured";
  // Only `surface` takes a measured file itself.
  expectRefused("surface utf16.txt", 2, "utf16.txt: has no rows of numbers");
  expectRefused("surface heights.csv", 2, "heights.csv: surface.position_unit: is needed");
  for (const char* verb : {"check", "curve"}) {
    expectRefused(std::string(verb) + " utf16.txt", 2, "utf16.txt: is text in UTF-16; ");
    expectRefused(std::string(verb) + " utf16.txt", 2, needed);
    expectRefused(std::string(verb) + " heights.csv", 2, "heights.csv: is text that is not JSON; ");
    expectRefused(std::string(verb) + " heights.csv", 2, needed);
  }
}

/// Each choice gives its own bytes again, and all of them the same number up to rounding.
TEST_F(UsageTest, TheEnvironmentForcesTheVectors) {
  const auto table = [this](const std::string& before) {
    return program.run("curve s.json --json", before);
  };
  const auto best = nlohmann::json::parse(table("").out);
  EXPECT_EQ(table("ASPERITY_TARGET=").out, table("").out);
  int had = 0;
  for (const char* target : {"scalar", "avx2", "avx3"}) {
    const std::string before = std::string("ASPERITY_TARGET=") + target;
    const Said said = table(before);
    if (said.status != 0) {  // not every machine has all
      EXPECT_EQ(said.status, 2);
      EXPECT_THAT(said.err, testing::HasSubstr("is not what this machine has; "));
      continue;
    }
    ++had;
    EXPECT_EQ(table(before).out, said.out) << target;
    const auto points = nlohmann::json::parse(said.out)["points"];
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(points[i]["mu"].get<double>() / best["points"][i]["mu"].get<double>(), 1, 1e-10);
  }
  EXPECT_GE(had, 1);  // scalar is everywhere
  for (const char* wrong : {"AVX2", "avx", "sse4", "best"})
    expectRefused("check s.json", 2,
                  std::string("ASPERITY_TARGET: ") + wrong + " is not one of avx3, avx2, scalar",
                  std::string("ASPERITY_TARGET=") + wrong);
  EXPECT_THAT(program.run("--help").out, testing::HasSubstr("ASPERITY_TARGET=avx3|avx2|scalar"));
}

// A table of measured friction cannot be computed again.
TEST_F(UsageTest, NoOutputReplacesAFileThatASceneOrAnOptionNames) {
  const std::string table = "velocity,mu\n0.01,0.0002\n0.1,0.0005\n1,0.0004\n";
  program.folder.write("d.csv", table);
  program.folder.write("c.json", R"({"surface":{"elements":100},"sweep":{"points":3},)"
                                 R"("ensemble":{"realizations":2},)"
                                 R"("comparison":{"data":[{"file":"d.csv"}]}})");
  program.folder.write("style.json", R"({"schema":"asperity-style/1"})");
  const std::string style = TemporaryFolder::read(program.folder / "style.json");
  program.folder.write("line.csv", "0\n1e-6\n0\n-1e-6\n");
  program.folder.write(
      "b.json", R"({"schema":"asperity-batch/1","entries":[{"name":"d","scene":"c.json"}]})");
  const std::string map = " --x sliding.velocity=0.1:1:2 --y surface.hurst=0.5:0.7:2";
  for (const std::string& line : {
           std::string("curve s.json --data d.csv -o d.csv"),
           std::string("curve s.json --data d.csv -o ./d.csv"),
           std::string("curve s.json --data d.csv -o a.csv --realizations-table d.csv"),
           std::string("curve c.json -o d.csv"),
           std::string("curve c.json -o a.csv --realizations-table d.csv"),
           std::string("map c.json -o d.csv") + map,
           std::string("sensitivity c.json -o d.csv"),
           std::string("surface c.json -o d.csv"),
           std::string("batch b.json -o ."),
       })
    expectRefused(line, 2, "d.csv is also an input file");
  expectRefused("curve s.json -o a.png --style style.json -o style.json", 2,
                "style.json is also an input file");
  expectRefused("curve s.json --with 'surface.kind=profile;surface.file=line.csv' -o line.csv", 2,
                "line.csv is also an input file");
  // The fit writes files of its own names.
  std::filesystem::rename(program.folder / "d.csv", program.folder / "fit.csv");
  expectRefused("fit s.json --data fit.csv --vary surface.rms_height -o .", 2,
                "fit.csv is also an input file");
  EXPECT_EQ(TemporaryFolder::read(program.folder / "fit.csv"), table);
  EXPECT_EQ(TemporaryFolder::read(program.folder / "style.json"), style);
}

TEST_F(UsageTest, CheckRefusesWhatACurveRefuses) {
  program.folder.write("p.json", R"({"elastomer":{"rheology":"prony","equilibrium_modulus":0,)"
                                 R"("arms":[{"modulus":1e7,"relaxation_time":1e-3}]}})");
  for (const char* verb : {"check", "curve"})
    expectRefused(std::string(verb) + " p.json", 2, "elastomer.equilibrium_modulus: is 0");
}

}  // namespace
}  // namespace asperity
