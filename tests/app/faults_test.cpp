// What goes wrong from outside, for every verb that writes: killed at random moments, over an empty
// folder and over older files; no room on the disk, a folder that goes away meanwhile.
// ASPERITY_KILLS=N kills each verb N times.
#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

constexpr const char* kCurve = "curve s.json -o out/a.csv -o out/a.json -o out/a.png -o out/a.svg";
constexpr const char* kRender = "render s.json -o out --frames 12 --size 320x240";
constexpr const char* kFigure = "figure 1 5 -o out --realizations 3 --set surface.elements=300";
constexpr const char* kAccuracy = "accuracy s.json -o out";
constexpr const char* kFilm = "render s.json -o out/film.mp4 --frames 12 --size 320x240";
constexpr const char* kBatch = "batch b.json -o out";
constexpr const char* kEntries =
    R"({"schema": "asperity-batch/1", "title": "Two", "size": "300x300", "entries": [
        {"name": "two", "scene": "s.json", "sweep": {"surface.hurst": [0.4, 0.8]}}]})";

class FaultsTest : public ProgramTest {
 protected:
  using Files = std::map<std::string, std::string>;

  Files files() const {
    Files found;
    if (!fs::exists(program.folder / "out")) return found;
    for (const std::string& name : program.folder.names("out"))
      found[name] = TemporaryFolder::read(program.folder / ("out/" + name));
    return found;
  }
  void clear() const { fs::remove_all(program.folder / "out"); }
  void start(const std::string& arguments) const {
    clear();
    // Folders that a verb makes by itself are left to it.
    if (arguments == kCurve || arguments == kFilm) fs::create_directory(program.folder / "out");
  }

  static int kills() {
    const char* wanted = std::getenv("ASPERITY_KILLS");
    return wanted ? std::atoi(wanted) : 8;
  }

  /// What a run that is let be writes; how long it takes sets when others are killed.
  Files filesOf(const std::string& arguments) {
    const auto begin = std::chrono::steady_clock::now();
    const Said said = program.run(arguments);
    EXPECT_EQ(said.status, 0) << said.err;
    taken = std::chrono::steady_clock::now() - begin;
    return files();
  }
  void runAndKill(const std::string& arguments) {
    std::uniform_real_distribution<double> part(0.05, 1.1);
    program.run(arguments, "timeout -s KILL " + std::to_string(part(random) * taken.count()));
  }

  /// isWhole(name, bytes, those of a run that was let be).
  template <class IsWhole>
  void killAtRandom(const std::string& arguments, const IsWhole& isWhole) {
    start(arguments);
    const Files whole = filesOf(arguments);
    for (int i = 0; i < kills(); ++i) {
      start(arguments);
      runAndKill(arguments);
      for (const auto& [name, bytes] : files()) {
        // From what a killed batch has noted, the same command goes on.
        if (name == ".asperity_batch_progress") continue;
        ASSERT_EQ(whole.count(name), 1U) << name << " is no file of " << arguments;
        EXPECT_TRUE(isWhole(name, bytes, whole.at(name))) << name << " of " << arguments;
      }
    }
    clear();
    EXPECT_THAT(program.folder.names(), testing::IsSubsetOf({"s.json", "b.json"}));
  }

  /// Two scenes in turn over each other's files: each file is one of the two. Only the moment of
  /// replacing may leave a hidden part, which the next run removes.
  void killWhileReplacing(const std::string& arguments) {
    const std::array<std::string, 2> runs{arguments, arguments + " --set load.normal_force=0.01"};
    start(arguments);
    const std::array<Files, 2> whole{filesOf(runs[0]), filesOf(runs[1])};
    for (int i = 0; i < kills(); ++i) {
      runAndKill(runs[i % 2]);
      for (const auto& [name, bytes] : files()) {
        if (name.starts_with(".asperity.") && name.ends_with(".part")) continue;
        ASSERT_EQ(whole[0].count(name), 1U) << name << " is no file of " << arguments;
        EXPECT_TRUE(bytes == whole[0].at(name) || bytes == whole[1].at(name)) << name;
      }
    }
    EXPECT_EQ(filesOf(runs[0]), whole[0]) << arguments;
  }

  /// One line that says why, and no crash.
  static void expectOneLine(const std::string& err, const std::string& what) {
    EXPECT_THAT(err, StartsWith("asperity: ")) << what;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  }

  std::mt19937 random{7};
  std::chrono::duration<double> taken{};
};

/// The same bytes as without the kill: files are whole or not there.
bool isTheSame(const std::string&, const std::string& bytes, const std::string& whole) {
  return bytes == whole;
}

/// Where times are written the bytes differ: the file's own end tells.
bool hasItsEnd(const std::string& name, const std::string& bytes, const std::string& whole) {
  if (!name.ends_with(".csv")) return bytes.ends_with(whole.substr(whole.size() - 8));
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  return bytes.ends_with('\n') && lines(bytes) == lines(whole);
}

TEST_F(FaultsTest, AKilledCurveLeavesNoHalfFile) {
  killAtRandom(kCurve, isTheSame);
}
TEST_F(FaultsTest, AKilledRenderLeavesNoHalfFile) {
  killAtRandom(kRender, isTheSame);
}
TEST_F(FaultsTest, AKilledFigureLeavesNoHalfFile) {
  killAtRandom(kFigure, isTheSame);
}
TEST_F(FaultsTest, AKilledAccuracyLeavesNoHalfFile) {
  killAtRandom(kAccuracy, hasItsEnd);
}
TEST_F(FaultsTest, AKilledFilmLeavesNoHalfFile) {
  killAtRandom(kFilm, isTheSame);
}
TEST_F(FaultsTest, AKilledBatchLeavesNoHalfFile) {
  program.folder.write("b.json", kEntries);
  killAtRandom(kBatch, isTheSame);
}

TEST_F(FaultsTest, AKillWhileCurvesAreReplacedLeavesTheOldOrTheNew) {
  killWhileReplacing(kCurve);
}
TEST_F(FaultsTest, AKillWhileFramesAreReplacedLeavesTheOldOrTheNew) {
  killWhileReplacing(kRender);
}

TEST_F(FaultsTest, WithoutRoomOnTheDiskEveryVerbSaysSo) {
  for (const char* arguments : {kCurve, kRender, kFigure, kAccuracy}) {
    start(arguments);
    const Said said = program.runOnFullDisk(arguments);
    EXPECT_EQ(said.status, 1) << arguments;
    expectOneLine(said.err, arguments);
    EXPECT_THAT(said.err, HasSubstr("cannot be written")) << arguments;
    EXPECT_TRUE(files().empty()) << arguments;
  }
}

/// Removed as soon as it is there; the watcher ends when the program has ended.
TEST_F(FaultsTest, AFolderThatGoesAwayMeanwhileIsTold) {
  for (const char* arguments : {kRender, kFigure, kAccuracy}) {
    clear();
    const Said said = program.run(
        std::string(arguments) + " 2>told; status=$?; touch ended; wait; rm -f ended; exit $status",
        "(until [ -e ended ] || [ -d out ]; do :; done; until [ -e ended ]; do rm -rf out; done) "
        ">/dev/null 2>&1 & ");
    const std::string told = TemporaryFolder::read(program.folder / "told");
    // It may find the folder gone at the next file, or fail in the middle of one.
    EXPECT_THAT(said.status, testing::AnyOf(1, 2)) << arguments;
    expectOneLine(told, arguments);
    EXPECT_THAT(told, HasSubstr("out")) << arguments;
  }
}

}  // namespace
}  // namespace asperity
