// INT and TERM: one line, the shell's exit status, no unfinished file, the old files as they were.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/app/program.h"

namespace asperity {
namespace {

struct Ended {
  int status = -1;  // of the process, as wait() has it
  std::string err;
};

class InterruptionTest : public ProgramTest {
 protected:
  /// A shell in the background ignores the signal, and its children inherit that.
  InterruptionTest() { ::signal(SIGINT, SIG_DFL); }

  /// Runs the program with `arguments`, waits until `isUnderWay` says that it works, and sends the
  /// signal.
  template <class Condition>
  Ended interrupt(const std::vector<std::string>& arguments, int signal,
                  const Condition& isUnderWay) {
    std::vector<std::string> words{ASPERITY_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string err = program.folder / ".err";
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, program.folder.path().c_str());
    pid_t process = 0;
    EXPECT_EQ(
        ::posix_spawn(&process, ASPERITY_PROGRAM, &actions, nullptr, pointers.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    Ended ended;
    while (!isUnderWay() && ::waitpid(process, &ended.status, WNOHANG) == 0) ::usleep(2000);
    ::kill(process, signal);
    ::waitpid(process, &ended.status, 0);
    ended.err = TemporaryFolder::read(err);
    std::filesystem::remove(err);
    return ended;
  }

  bool exists(const std::string& name) const {
    return std::filesystem::exists(program.folder / name);
  }
};

TEST_F(InterruptionTest, OneLineTheShellsStatusAndNoUnfinishedFile) {
  for (const auto& [signal, status, word] :
       {std::tuple{SIGINT, 130, "interrupted"}, {SIGTERM, 143, "terminated"}}) {
    // Far more frames than a test has time for; the first one says that the work is under way.
    const Ended ended = interrupt(
        {"render", "s.json", "-o", "out", "--frames", "100000", "--size", "320x240"}, signal,
        [this] { return exists("out") && program.folder.names("out").size() > 2; });
    ASSERT_TRUE(WIFEXITED(ended.status)) << ended.status;
    EXPECT_EQ(WEXITSTATUS(ended.status), status);
    EXPECT_EQ(ended.err, std::string("asperity: ") + word + "; no unfinished file is left\n");
    for (const std::string& name : program.folder.names("out")) {
      EXPECT_THAT(name, testing::EndsWith(".png"));
      EXPECT_THAT(TemporaryFolder::read(program.folder / ("out/" + name)),
                  testing::HasSubstr("IEND"))
          << name;
    }
    std::filesystem::remove_all(program.folder / "out");
  }
}

/// The film is written all the while, and ffmpeg is another process.
TEST_F(InterruptionTest, AnOldFilmStays) {
  program.folder.write("film.mp4", "the old one");
  program.folder.write("ffmpeg", "#!/bin/sh\ntouch '" + (program.folder / "under_way").string() +
                                     "'\nexec cat >/dev/null\n");
  std::filesystem::permissions(program.folder / "ffmpeg", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (program.folder.path().string() + ":" + path).c_str(), 1);
  const Ended ended = interrupt({"render", "s.json", "-o", "film.mp4", "--frames", "100000"},
                                SIGINT, [this] { return exists("under_way"); });
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_TRUE(WIFEXITED(ended.status)) << ended.status;
  EXPECT_EQ(WEXITSTATUS(ended.status), 130);
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(TemporaryFolder::read(program.folder / "film.mp4"), "the old one");
  EXPECT_THAT(program.folder.names(),
              testing::UnorderedElementsAre("s.json", "film.mp4", "ffmpeg", "under_way"));
}

/// As nohup and shells in the background start a program.
TEST_F(InterruptionTest, AnIgnoredSignalStaysIgnored) {
  ::signal(SIGINT, SIG_IGN);
  bool sent = false;
  const Ended ended = interrupt({"curve", "s.json", "-o", "b.csv"}, SIGINT,
                                [&sent] { return std::exchange(sent, true); });
  ::signal(SIGINT, SIG_DFL);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(exists("b.csv"));
}

}  // namespace
}  // namespace asperity
