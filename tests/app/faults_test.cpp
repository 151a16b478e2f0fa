// What goes wrong from outside, for every verb that writes: killed at random moments, no room on
// the disk, a folder that goes away meanwhile. ASPERITY_KILLS=N kills each verb N times.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/app/program_test.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

constexpr const char* kCurve = "curve s.json -o out/a.csv -o out/a.json -o out/a.png -o out/a.svg";
constexpr const char* kRender = "render s.json -o out --frames 12 --size 320x240";
constexpr const char* kFigure = "figure 1 5 -o out --realizations 3 --set surface.elements=300";
constexpr const char* kAccuracy = "accuracy s.json -o out";

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
    if (arguments == kCurve) fs::create_directory(program.folder / "out");
  }

  static int kills() {
    const char* wanted = std::getenv("ASPERITY_KILLS");
    return wanted ? std::atoi(wanted) : 8;
  }

  /// isWhole(name, bytes, those of a run that was let be).
  template <class IsWhole>
  void killAtRandom(const std::string& arguments, const IsWhole& isWhole) {
    start(arguments);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(program.run(arguments).status, 0);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const Files whole = files();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.05, 1.1);
    for (int i = 0; i < kills(); ++i) {
      start(arguments);
      program.run(arguments, "timeout -s KILL " + std::to_string(part(random) * taken.count()));
      for (const auto& [name, bytes] : files()) {
        ASSERT_EQ(whole.count(name), 1U) << name << " is no file of " << arguments;
        EXPECT_TRUE(isWhole(name, bytes, whole.at(name))) << name << " of " << arguments;
      }
    }
    clear();
    EXPECT_THAT(program.folder.names(), testing::ElementsAre("s.json"));
  }

  /// One line that says why, and no crash.
  static void expectOneLine(const std::string& err, const std::string& what) {
    EXPECT_THAT(err, StartsWith("asperity: ")) << what;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  }
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
