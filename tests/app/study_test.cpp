// asperity study as people and clusters use it: killed at any moment, several processes on one
// store, shards, full disks, tables of constant memory.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;

constexpr const char* kStudy =
    R"({"schema":"asperity-study/1","title":"Small","chunk":16,)"
    R"("set":{"surface.elements":200,"ensemble.realizations":2},)"
    R"("space":{"load.normal_force":{"from":0.001,"to":1,"points":60},)"
    R"("surface.hurst":{"from":0.3,"to":0.9,"points":20}},"outputs":["mu","contact_fraction"]})";

class StudyCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write("study.json", kStudy);
  }

  /// Starts the program in the folder; its words are arguments.
  pid_t start(const std::vector<std::string>& words) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(program.folder.path().c_str()) != 0) ::_exit(99);
    std::vector<char*> arguments;
    std::string name = ASPERITY_PROGRAM;
    arguments.push_back(name.data());
    std::vector<std::string> copies = words;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(ASPERITY_PROGRAM, arguments.data());
    ::_exit(98);
  }

  std::string table(const std::string& store) const {
    const Said said = program.run("study table " + store);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(said.err, "");
    return said.out;
  }

  /// The table of a run that nothing disturbed.
  std::string undisturbed() const {
    const Said said = program.run("study run study.json -o whole --quiet");
    EXPECT_EQ(said.status, 0) << said.err;
    return table("whole");
  }
};

TEST_F(StudyCommandTest, SurvivesBeingKilledAtAnyMoment) {
  const std::string whole = undisturbed();
  std::mt19937 random(1);
  std::uniform_int_distribution<int> moment(0, 250);  // ms
  long done = 0;
  for (int kill = 0; kill < 100; ++kill) {
    const pid_t child = start({"study", "run", "study.json", "-o", "killed", "--quiet"});
    std::this_thread::sleep_for(std::chrono::milliseconds(moment(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!std::filesystem::exists(program.folder / "killed") ||
        program.folder.read(program.folder / "killed").empty())
      continue;
    // The store opens, SQLite finds it whole, and nothing that was there is lost.
    const Said shown = program.run("study show killed --json --quiet");
    if (shown.status == 2 && shown.err.find("is empty") != shown.err.npos) continue;
    ASSERT_EQ(shown.status, 0) << shown.err;
    const long now = nlohmann::json::parse(shown.out)["done"].get<long>();
    EXPECT_GE(now, done);
    done = now;
    if (done < 1200) continue;
    EXPECT_EQ(table("killed"), whole);
    done = 0;
    for (const char* name : {"killed", "killed-wal", "killed-shm", "killed-claims"})
      std::filesystem::remove(program.folder / name);
  }
  EXPECT_EQ(program.run("study run study.json -o killed --quiet").status, 0);
  EXPECT_EQ(table("killed"), whole);
  EXPECT_THAT(program.folder.names(), testing::Not(testing::Contains("killed-claims")));
}

TEST_F(StudyCommandTest, ProcessesShareAStore) {
  const std::string whole = undisturbed();
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i)
    children.push_back(
        start({"study", "run", "study.json", "-o", "shared", "--quiet", "--threads", "1"}));
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  EXPECT_EQ(table("shared"), whole);
}

TEST_F(StudyCommandTest, ShardsInAnyOrderGiveTheSameTable) {
  const std::string whole = undisturbed();
  for (const char* shard : {"3/3", "1/3", "2/3"})
    EXPECT_EQ(program
                  .run("study run study.json -o part" + std::string(shard, 1) + " --shard " +
                       shard + " --quiet")
                  .status,
              0);
  for (const char* order : {"part1 part2 part3", "part3 part1 part2"}) {
    std::filesystem::remove(program.folder / "merged");
    const Said said = program.run(std::string("study merge ") + order + " -o merged");
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(table("merged"), whole);
  }
  std::filesystem::remove(program.folder / "merged");
  const Said said = program.run("study merge part1 part3 -o merged");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.err, HasSubstr("no store is of shard 2/3"));
  // What is there is a store that goes on.
  EXPECT_EQ(program.run("study run study.json -o merged --quiet").status, 0);
  EXPECT_EQ(table("merged"), whole);
}

TEST_F(StudyCommandTest, AChangedStudyIsRefused) {
  undisturbed();
  std::string changed = kStudy;
  changed.replace(changed.find("0.001"), 5, "0.002");
  program.folder.write("study.json", changed);
  expectRefused("study run study.json -o whole", 2, "is the store of another study: space.load.");
}

TEST_F(StudyCommandTest, MistakesAreOneLine) {
  program.folder.write("bad.json",
                       R"({"schema":"asperity-study/1","space":{"surface.hrust":[1]}})");
  expectRefused("study", 2, "");
  expectRefused("study run", 2, "");
  expectRefused("study rnu study.json", 2, "");
  expectRefused("study run study.json", 2, "needs a store");
  expectRefused("study run bad.json -o s", 2, "bad.json: space.surface.hrust");
  expectRefused("study run study.json -o study.json", 2, "study.json");
  expectRefused("study run study.json -o nowhere/s", 2, "nowhere");
  expectRefused("study run study.json -o s --shard 4/3", 2, "--shard");
  expectRefused("study run study.json -o s --bogus", 2, "--bogus");
  expectRefused("study table study.json", 2, "is not the store of a study");
  expectRefused("study table nothing", 2, "nothing: is not there");
  expectRefused("study show s.json", 2, "is not the store of a study");
  expectRefused("study merge s.json -o m", 2, "is not the store of a study");
  expectRefused("study analyse nothing -o d", 2, "is not there");
}

/// The folder is checked before the store is even opened.
TEST_F(StudyCommandTest, AFolderThatCannotBeWrittenIsRefusedBeforeTheWork) {
  expectRefused("study analyse nothing -o study.json/d", 2,
                "study.json/d: is not a folder and cannot be created");
}

TEST_F(StudyCommandTest, AFullDiskIsOneLineAndTheRunGoesOn) {
  const std::string whole = undisturbed();
  const Said full = program.runOnFullDisk("study run study.json -o full --quiet");
  EXPECT_EQ(full.status, 1) << full.err;
  EXPECT_THAT(full.err, HasSubstr("full: cannot be written"));
  EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
  EXPECT_EQ(program.run("study run study.json -o full --quiet").status, 0);
  EXPECT_EQ(table("full"), whole);
}

TEST_F(StudyCommandTest, ThePlanComputesNothing) {
  const Said said = program.run("study run study.json --plan --json --quiet");
  EXPECT_EQ(said.status, 0) << said.err;
  const auto plan = nlohmann::json::parse(said.out);
  EXPECT_EQ(plan["simulations"], 1200);
  EXPECT_EQ(plan["chunk"], 16);
  EXPECT_GT(plan["seconds"].get<double>(), 0);
  EXPECT_THAT(program.folder.names(), testing::UnorderedElementsAre("s.json", "study.json"));
}

TEST_F(StudyCommandTest, FailedSimulationsAreAnExitStatusUnlessTheyAreAllowed) {
  // Below T_r - c2 there is no shift with temperature.
  program.folder.write("study.json",
                       R"({"schema":"asperity-study/1","set":{"surface.elements":100,)"
                       R"("ensemble.realizations":1},"space":{"elastomer.temperature":)"
                       R"([150,298.15,320]},"outputs":["mu"]})");
  const Said said = program.run("study run study.json -o s --json --quiet");
  EXPECT_EQ(said.status, 1);
  EXPECT_EQ(said.err,
            "asperity: s: some simulations failed: 'asperity study show' says why; "
            "--allow-failures accepts them\n");
  EXPECT_EQ(nlohmann::json::parse(said.out)["done"], 3);
  EXPECT_THAT(table("s"), HasSubstr("\n1,298.15,0."));  // the others are stored
  EXPECT_EQ(program.run("study run study.json -o s --quiet").status, 1);
  const Said allowed = program.run("study run study.json -o s --allow-failures");
  EXPECT_EQ(allowed.status, 0) << allowed.err;
  EXPECT_THAT(allowed.out + allowed.err, HasSubstr("some simulations failed"));
}

TEST_F(StudyCommandTest, AnalyseWritesTablesAndPictures) {
  program.folder.write(
      "study.json",
      R"({"schema":"asperity-study/1","set":{"surface.elements":100,"ensemble.realizations":1,)"
      R"("sweep.points":5},"sampling":"saltelli","samples":64,"space":{"load.normal_force":)"
      R"({"from":0.001,"to":1},"elastomer.shear_modulus":{"distribution":"lognormal","mean":1e7,)"
      R"("deviation":2e6}},"outputs":["mu","curve.mu"]})");
  EXPECT_EQ(program.run("study run study.json -o s --quiet").status, 0);
  const Said said = program.run("study analyse s -o d --json --quiet");
  EXPECT_EQ(said.status, 0) << said.err;
  const auto names = program.folder.names("d");
  for (const char* name : {"analysis.json", "sensitivity.csv", "effects.csv", "percentiles.csv",
                           "sensitivity.png", "correlation.svg", "effects_mu.pdf", "band_mu.png"})
    EXPECT_THAT(names, testing::Contains(name));
  const auto json = nlohmann::json::parse(said.out);
  const auto& output = json["analysis"]["outputs"][0];
  EXPECT_EQ(output["sobol_indices"].size(), 2U);
  EXPECT_EQ(output["blocks"], 64);
}

TEST_F(StudyCommandTest, MemoryDoesNotGrowWithTheStudy) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer keeps freed memory";
#endif
  const auto peak = [&](const std::vector<std::string>& words) {
    const pid_t child = start(words);
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    EXPECT_EQ(status, 0);
    return static_cast<double>(usage.ru_maxrss) / 1024;  // MiB
  };
  const auto study = [](int points) {
    return R"({"schema":"asperity-study/1","chunk":512,"set":{"surface.elements":100,)"
           R"("ensemble.realizations":1},"space":{"load.normal_force":{"from":0.1,"to":1,"points":)" +
           std::to_string(points) +
           R"(},"surface.rms_height":{"from":3e-7,"to":6e-7,"points":50}}})";
  };
  program.folder.write("little.json", study(40));
  program.folder.write("much.json", study(2000));
  const double little = peak({"study", "run", "little.json", "-o", "little", "--quiet"});
  const double much = peak({"study", "run", "much.json", "-o", "much", "--quiet"});
  EXPECT_LT(much, little + 25) << "2,000 simulations: " << little << " MiB";
  const double table = peak({"study", "table", "little", "-o", "little.csv", "--quiet"});
  const double big = peak({"study", "table", "much", "-o", "much.csv", "--quiet"});
  EXPECT_LT(big, table + 10) << "2,000 rows: " << table << " MiB";
}

TEST_F(StudyCommandTest, ADamagedStoreIsRefusedBeforeAnythingIsComputed) {
  program.folder.write("study.json",
                       R"({"schema":"asperity-study/1","chunk":16,"set":{"surface.elements":100,)"
                       R"("ensemble.realizations":1},"space":{"load.normal_force":)"
                       R"({"from":0.001,"to":1,"points":4000}}})");
  // A store with a part of its chunks, the last pages of which are overwritten.
  start({"study", "run", "study.json", "-o", "s", "--quiet", "--shard", "1/3"});
  int status = 0;
  ::wait(&status);
  ASSERT_EQ(status, 0);
  const auto size = std::filesystem::file_size(program.folder / "s");
  ASSERT_GT(size, 4U * 4096U);
  std::string bytes = TemporaryFolder::read(program.folder / "s");
  std::fill(bytes.begin() + 2 * 4096, bytes.end(), '\x5a');
  program.folder.write("s", bytes);
  expectRefused("study run study.json -o s --shard 1/3 --quiet", 2, "is damaged");
}

}  // namespace
}  // namespace asperity
