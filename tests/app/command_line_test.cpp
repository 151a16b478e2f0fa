// The program as scripts call it: answers, errors, exit statuses, files.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

using CommandLineTest = ProgramTest;

TEST_F(CommandLineTest, VersionAndHelp) {
  EXPECT_THAT(program.run("--version").out, StartsWith("asperity " ASPERITY_VERSION "\n"));
  EXPECT_THAT(program.run("--help").out, HasSubstr("render"));
  for (const char* verb : {"check", "curve", "render", "surface"}) {
    const Said said = program.run(std::string(verb) + " --help");
    EXPECT_EQ(said.status, 0);
    EXPECT_THAT(said.out, HasSubstr("--help keys"));
  }
}

TEST_F(CommandLineTest, CheckSaysWhatTheSceneIs) {
  const Said said = program.run("check s.json");
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.out, HasSubstr("A scene"));
  EXPECT_EQ(said.err, "");
  const Said json = program.run("check s.json --json --set load.normal_force=3");
  EXPECT_EQ(nlohmann::json::parse(json.out)["scene"]["load"]["normal_force"], 3);
  EXPECT_THAT(json.err, HasSubstr("A scene"));
  EXPECT_EQ(program.run("check s.json --quiet").out, "");
}

/// Shipped scenes go by their names, as materials and lessons do.
TEST_F(CommandLineTest, AShippedSceneNeedsNoEnding) {
  const Said bare = program.run("check figure_2");
  EXPECT_EQ(bare.status, 0) << bare.err;
  EXPECT_EQ(bare.out, program.run("check figure_2.json").out);
  expectRefused("check figure_22", 2,
                "figure_22: there is no such file; the nearest shipped scene is figure_2");
  expectRefused("check figur_1.json", 2, "the nearest shipped scene is figure_1");
}

TEST_F(CommandLineTest, BadInputIsExitTwoAndOneClearLine) {
  program.folder.write("broken.json", "{\"surface\": ");
  program.folder.write("unknown.json", R"({"surface":{"hurts":0.5}})");
  program.folder.write("text.json", R"({"load":{"normal_force":"much"}})");
  program.folder.write("nan.json", R"({"load":{"normal_force":NaN}})");
  program.folder.write("negative.json", R"({"elastomer":{"shear_modulus":-1e7}})");
  program.folder.write("hurst.json", R"({"surface":{"hurst":1.4}})");
  program.folder.write("row.csv", "x,z\n0,1\n");
  program.folder.write("profile.json", R"({"surface":{"kind":"profile","file":"row.csv"}})");
  program.folder.write("gone.json", R"({"surface":{"kind":"profile","file":"gone.csv"}})");
  for (const char* verb : {"check", "curve", "surface"}) {
    const std::string v = std::string(verb) + " ";
    expectRefused(v + "missing.json", 2, "missing.json: cannot be opened");
    expectRefused(v + "broken.json", 2, "broken.json: is not valid JSON");
    expectRefused(v + "unknown.json", 2,
                  "surface.hurts: unknown key; the nearest known one is surface.hurst");
    expectRefused(v + "text.json", 2, "load.normal_force: 'much' is not a number");
    expectRefused(v + "nan.json", 2, "nan.json: is not valid JSON");
    expectRefused(v + "negative.json", 2, "elastomer.shear_modulus: -10000000 is outside");
    expectRefused(v + "hurst.json", 2, "hurst.json: surface.hurst: 1.4 is outside 0 to 1");
    expectRefused(v + "profile.json", 2, "row.csv: has 1 rows");
    expectRefused(v + "gone.json", 2, "gone.csv: cannot be opened");
    expectRefused(v + ".", 2, "is a folder");
    expectRefused(v + "s.json --set load.normal_force=nan", 2, "not a finite number");
    expectRefused(v + "s.json --set surface.kind=sine --set surface.waves=5000", 2,
                  "s.json: surface.waves: 5000 is outside 1 to 99");
  }
}

TEST_F(CommandLineTest, BadUsageIsExitTwo) {
  expectRefused("curve", 2, "SCENE");
  expectRefused("check s.json --nonsense", 2, "--nonsense");
  expectRefused("check s.json --set nothing", 2, "KEY=VALUE");
  expectRefused("check s.json --threads -1", 2, "--threads");
  expectRefused("render s.json", 2, "--output");
  expectRefused("render s.json -o a.png --size 10", 2, "--size");
  expectRefused("render s.json -o a.png --size 32768x32768", 2, "160 to 16384");
  expectRefused("render s.json -o a.png --frames 0", 2, "--frames");
  expectRefused("render s.json -o a.png --frames 3", 2, "frames need a folder or a film");
  expectRefused("nowhere.json", 2, "cannot be opened");
  expectRefused("chekc s.json", 2, "unknown command 'chekc'; did you mean 'check'?");
  expectRefused("render s.json -o new/folder --fps nan", 2, "--fps");
  expectRefused("render s.json -o f --fps 0", 2, "--fps: 0 is outside 0.001 to 1000");
  expectRefused("render s.json -o f --slow-motion 1e16", 2, "1e16 is outside 1e-12 to 1e15");
  expectRefused("render s.json -o f --duration x", 2, "'x' is not a number; allowed is 0.001 to");
  expectRefused("curve s.json -o ''", 2, "--output: is empty");
}

TEST_F(CommandLineTest, OutputsThatCannotBeAreRefusedBeforeAnyWork) {
  expectRefused("curve s.json -o .", 2, "is a folder");
  expectRefused("curve s.json -o nowhere/a.csv", 2, "does not exist");
  expectRefused("curve s.json -o - -o -", 2, "- is given more than once");
  expectRefused("curve s.json -o a.txt", 2, "is not one of .csv, .json, .png, .svg, .pdf");
  expectRefused("curve s.json -o a.csv -o b", 2,
                "b: the file name has no extension; allowed is .csv");
  expectRefused("curve s.json -o /dev/full", 2, "not a plain file");
  expectRefused("surface s.json -o a.txt", 2, "is not one of");
  expectRefused("render s.json -o a.jpg", 2, "neither a folder nor a .png, .svg, .pdf");
  expectRefused("render s.json -o s.json/x", 2, "cannot be created");
}

TEST_F(CommandLineTest, AFullDiskIsExitOneAndLeavesNoPart) {
  for (const char* arguments : {"curve s.json -o a.csv", "curve s.json -o a.json",
                                "surface s.json -o a.csv", "render s.json -o a.png"}) {
    const Said said = program.runOnFullDisk(arguments);
    EXPECT_EQ(said.status, 1) << arguments;
    EXPECT_THAT(said.err, HasSubstr("cannot be written")) << arguments;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_THAT(program.folder.names(), ElementsAre("s.json")) << arguments;
  }
}

TEST_F(CommandLineTest, StandardOutputThatIsFullIsExitOne) {
  EXPECT_EQ(program.run("curve s.json > /dev/full; exit $?").status, 1);
  EXPECT_EQ(program.run("columns > /dev/full 2> said; exit $?").status, 1);
  EXPECT_EQ(read("said"), "asperity: standard output cannot be written\n");
  EXPECT_EQ(program.run("check s.json --json > /dev/full; exit $?").status, 1);
}

TEST_F(CommandLineTest, CurveIsATableOnStandardOutput) {
  const Said said = program.run("curve s.json");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.err, "");
  EXPECT_THAT(said.out, StartsWith("# asperity: {"));
  EXPECT_THAT(said.out.substr(said.out.find('\n') + 1),
              StartsWith("velocity,mu,mu_standard_error,mu_law,contact_fraction,"
                         "rms_slope_contact,indentation,normalized_mu,"
                         "dimensionless_velocity,dimensionless_force,realizations\n"));
  EXPECT_EQ(std::count(said.out.begin(), said.out.end(), '\n'), 7);
}

TEST_F(CommandLineTest, CurveFilesAreTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(program.run("curve s.json -o a.csv -o a.json --threads 1").status, 0);
  EXPECT_EQ(program.run("curve s.json -o b.csv -o b.json --threads 2 --quiet").out, "");
  for (const char* extension : {".csv", ".json"})
    EXPECT_EQ(TemporaryFolder::read(program.folder / ("a" + std::string(extension))),
              TemporaryFolder::read(program.folder / ("b" + std::string(extension))));
  EXPECT_THAT(TemporaryFolder::read(program.folder / "a.csv"),
              AllOf(StartsWith("# asperity: {\"schema\":\"asperity-curve/1\""),
                    EndsWith(program.run("curve s.json").out)));
  EXPECT_EQ(TemporaryFolder::read(program.folder / "a.json"),
            program.run("curve s.json --json").out);
  EXPECT_THAT(program.folder.names(),
              UnorderedElementsAre("s.json", "a.csv", "a.json", "b.csv", "b.json"));
}

TEST_F(CommandLineTest, TimingGoesToStandardErrorOnly) {
  const Said said = program.run("curve s.json --timing");
  EXPECT_EQ(said.out, program.run("curve s.json").out);
  EXPECT_THAT(said.err, HasSubstr("time "));
}

TEST_F(CommandLineTest, RenderNeedsNeitherDisplayNorHome) {
  // Of the leak checker's list a build under sanitizers may not be deprived.
  const std::string bare = "env -i PATH=/usr/bin:/bin \"LSAN_OPTIONS=$LSAN_OPTIONS\"";
  const Said said = program.run("render s.json -o a.png --size 640x360", bare);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(said.err, "");
  EXPECT_THAT(said.out, HasSubstr("wrote a.png"));
  const Said again = program.run("render s.json -o b.png --size 640x360 --threads 1", bare);
  EXPECT_EQ(again.status, 0);
  const std::string picture = TemporaryFolder::read(program.folder / "a.png");
  EXPECT_THAT(picture, StartsWith("\x89PNG"));
  EXPECT_EQ(picture, TemporaryFolder::read(program.folder / "b.png"));
}

TEST_F(CommandLineTest, RenderMakesNumberedFrames) {
  const Said said = program.run("render s.json -o out/film --frames 3 --size 320x200 --json");
  EXPECT_EQ(said.status, 0) << said.err;
  const auto answer = nlohmann::json::parse(said.out);
  EXPECT_EQ(answer["files"].size(), 3U);
  EXPECT_GT(answer["mu"], 0);
  for (const char* name : {"frame_0001.png", "frame_0002.png", "frame_0003.png"})
    EXPECT_TRUE(std::filesystem::exists(program.folder / ("out/film/" + std::string(name))));
  EXPECT_NE(TemporaryFolder::read(program.folder / "out/film/frame_0001.png"),
            TemporaryFolder::read(program.folder / "out/film/frame_0002.png"));
}

TEST_F(CommandLineTest, AMissingOpenGlIsOneClearLine) {
  expectRefused("render s.json -o a.png --backend osmesa", 1, "libNowhere",
                "ASPERITY_OSMESA_LIBRARY=libNowhere.so ");
  expectRefused("render s.json -o a.png --backend egl", 1, "libegl1",
                "ASPERITY_EGL_LIBRARY=libNowhere.so ");
}

TEST_F(CommandLineTest, SurfaceWritesWhatTheProfileReaderTakesBack) {
  EXPECT_EQ(program.run("surface s.json -o line.csv -o line.json -o line.png").status, 0);
  program.folder.write("p.json", R"({"surface":{"kind":"profile","file":"line.csv"}})");
  const Said said = program.run("check p.json");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("rms height 500 nm"));
  const auto root = nlohmann::json::parse(TemporaryFolder::read(program.folder / "line.json"));
  EXPECT_NEAR(root["statistics"]["rms_height"].get<double>(), 5e-7, 1e-18);
  EXPECT_EQ(root["spectrum"]["wave_number"].size(), 99U);
  EXPECT_THAT(TemporaryFolder::read(program.folder / "line.png"), StartsWith("\x89PNG"));
}

TEST_F(CommandLineTest, AProfileIsFoundBesideItsScene) {
  EXPECT_EQ(program.run("surface s.json -o line.csv").status, 0);
  program.folder.write("p.json", R"({"surface":{"kind":"profile","file":"line.csv"}})");
  EXPECT_EQ(program.run("check p.json", "mkdir -p other; cd other;").status,
            2);  // p.json is not there
  EXPECT_EQ(program.run("check ../p.json", "cd other;").status, 0);
}

TEST_F(CommandLineTest, WithoutADisplayTheWindowSaysWhatToDoInstead) {
  expectRefused("s.json", 1, "no display", "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM");
}

TEST_F(CommandLineTest, ADisplayThatCannotBeReachedIsOneLine) {
  for (const char* display : {"DISPLAY=:987", "DISPLAY=nonsense", "QT_QPA_PLATFORM=nonsense"})
    expectRefused("s.json", 1, "the display cannot be reached",
                  std::string("env -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM ") + display);
}

TEST_F(CommandLineTest, AClosedOrFullStandardErrorChangesNoStatus) {
  EXPECT_EQ(program.run("check s.json --json 2>&- >/dev/null; exit $?").status, 0);
  EXPECT_EQ(program.run("check gone.json 2>&- >/dev/null; exit $?").status, 2);
  EXPECT_EQ(program.run("check gone.json 2>/dev/full >/dev/null; exit $?").status, 2);
  EXPECT_EQ(program.run("curve s.json -o a.csv 2>&- >/dev/null <&-; exit $?").status, 0);
}

TEST_F(CommandLineTest, MachineAnswersCarryTheirProvenance) {
  for (const char* arguments :
       {"check s.json --json", "curve s.json --json", "surface s.json --json",
        "render s.json -o a.png --size 320x200 --json"}) {
    const auto root = nlohmann::json::parse(program.run(arguments).out);
    for (const char* key : {"schema", "verb", "version", "seed", "scene"})
      EXPECT_TRUE(root.contains(key)) << arguments << " " << key;
  }
}

TEST_F(CommandLineTest, BadInputMakesNoFolder) {
  expectRefused("render gone.json -o new/folder", 2, "gone.json: cannot be opened");
}

TEST_F(CommandLineTest, AWriteThroughALinkKeepsTheLink) {
  program.folder.write("target.csv", "old");
  std::filesystem::create_symlink(program.folder / "target.csv", program.folder / "link.csv");
  EXPECT_EQ(program.run("curve s.json -o link.csv").status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(program.folder / "link.csv"));
  EXPECT_THAT(TemporaryFolder::read(program.folder / "target.csv"), HasSubstr("\nvelocity,"));
}

/// Killed while it writes: nothing under the final name, nothing beside it.
/// The moments are spread over the time that a whole run takes.
TEST_F(CommandLineTest, AKillWhileWritingLeavesNothing) {
  const char* writes = "surface s.json --set surface.elements=100000 -o a.csv";
  const auto file = program.folder / "a.csv";
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(program.run(writes).status, 0);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  std::filesystem::remove(file);
  constexpr int kKills = 12;
  for (int i = 1; i <= kKills; ++i) {
    program.run(writes, "timeout -s KILL " + std::to_string(taken.count() * i / kKills));
    if (std::filesystem::exists(file)) {  // it was done before
      EXPECT_EQ(TemporaryFolder::read(file).back(), '\n');
      std::filesystem::remove(file);
    }
    EXPECT_THAT(program.folder.names(), ElementsAre("s.json")) << i;
  }
}

/// A killed run leaves no half file under the final name.
TEST_F(CommandLineTest, AKilledRunLeavesNoHalfFile) {
  for (const char* delay : {"0.02", "0.1", "0.3"}) {
    program.run(
        "curve s.json --set surface.elements=5000 --set ensemble.realizations=5000 -o a.csv",
        std::string("timeout -s KILL ") + delay);
    EXPECT_FALSE(std::filesystem::exists(program.folder / "a.csv"));
  }
}

TEST_F(CommandLineTest, MoreThreadsThanTheMachineHasAreNoMatter) {
  const Said many = program.run("curve s.json --threads 300 --quiet");
  EXPECT_EQ(many.status, 0);
  EXPECT_EQ(many.err, "");
  EXPECT_EQ(many.out, program.run("curve s.json --threads 1 --quiet").out);
}

TEST_F(CommandLineTest, OneVelocityIsCalledOne) {
  EXPECT_THAT(program.run("curve s.json -o c.csv --set sweep.points=1").out,
              testing::StartsWith("one velocity, 6 realizations"));
}

}  // namespace
}  // namespace asperity
