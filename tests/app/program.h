// Runs the program as a user does: a shell line, its exit status, what it said. And what tests of
// the program share: a folder with a small scene, and what a refusal looks like.
#pragma once

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/core/temporary_folder.h"

namespace asperity {

struct Said {
  int status;
  std::string out, err;
};

/// A table without the comment in front that says how it was made.
inline std::string withoutComment(const std::string& table) {
  return table.starts_with('#') ? table.substr(table.find('\n') + 1) : table;
}

class Program {
 public:
  /// `arguments` as typed in a shell, which may end with "<FILE"; `before` goes in front ("VAR=x",
  /// "ulimit ...;").
  Said run(const std::string& arguments, const std::string& before = "") const {
    const auto out = folder / ".out", err = folder / ".err";
    const std::string line = "cd '" + folder.path().string() + "'; " + before +
                             " '" ASPERITY_PROGRAM "' " + arguments + " >'" + out.string() +
                             "' 2>'" + err.string() +
                             (arguments.find('<') == arguments.npos ? "' </dev/null" : "'");
    const int status = std::system(line.c_str());
    Said said{WIFEXITED(status) ? WEXITSTATUS(status) : -1, TemporaryFolder::read(out),
              TemporaryFolder::read(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return said;
  }

  /// The same where no file may grow: a size limit stands for a full disk. What is said goes
  /// through a pipe, which the limit does not touch, and comes back as err.
  Said runOnFullDisk(const std::string& arguments) const {
    const auto err = folder / ".err";
    const std::string line = "cd '" + folder.path().string() +
                             "' && bash -c '(trap \"\" XFSZ; ulimit -f 0; exec \"" ASPERITY_PROGRAM
                             "\" " +
                             arguments + ") 2>&1 >/dev/null | cat >.err; exit ${PIPESTATUS[0]}'";
    const int status = std::system(line.c_str());
    Said said{WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", TemporaryFolder::read(err)};
    std::filesystem::remove(err);
    return said;
  }

  TemporaryFolder folder;
};

inline constexpr const char* kScene =
    R"({"schema":"asperity-scene/1","title":"A scene","surface":{"elements":200},)"
    R"("sweep":{"points":5},"ensemble":{"realizations":6}})";

class ProgramTest : public testing::Test {
 protected:
  void SetUp() override { program.folder.write("s.json", kScene); }

  /// Runs the program, which must succeed. Returns what it printed.
  std::string run(const std::string& arguments, const std::string& before = "") const {
    const Said said = program.run(arguments, before);
    EXPECT_EQ(said.status, 0) << arguments << "\n" << said.err;
    return said.out;
  }

  std::string read(const std::string& name) const {
    return TemporaryFolder::read(program.folder / name);
  }

  /// One line on stderr, nothing on stdout, nothing written.
  void expectRefused(const std::string& arguments, int status, const std::string& says,
                     const std::string& before = "") {
    SCOPED_TRACE(arguments);
    const auto names = program.folder.names();
    const Said said = program.run(arguments, before);
    EXPECT_EQ(said.status, status);
    EXPECT_THAT(said.err, testing::StartsWith("asperity: "));
    EXPECT_THAT(said.err, testing::HasSubstr(says));
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_THAT(program.folder.names(), testing::UnorderedElementsAreArray(names));
  }

  Program program;
};

}  // namespace asperity
