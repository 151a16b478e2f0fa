// Runs the program as a user does: a shell line, its exit status, what it said.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/core/temporary_folder.h"

namespace asperity {

struct Said {
  int status;
  std::string out, err;
};

class Program {
 public:
  /// `arguments` as typed in a shell; `before` goes in front ("VAR=x", "ulimit ...;").
  Said run(const std::string& arguments, const std::string& before = "") const {
    const auto out = folder / ".out", err = folder / ".err";
    const std::string line = "cd '" + folder.path().string() + "'; " + before +
                             " '" ASPERITY_PROGRAM "' " + arguments + " >'" + out.string() +
                             "' 2>'" + err.string() + "' </dev/null";
    const int status = std::system(line.c_str());
    Said said{WIFEXITED(status) ? WEXITSTATUS(status) : -1, TemporaryFolder::read(out),
              TemporaryFolder::read(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return said;
  }

  TemporaryFolder folder;
};

}  // namespace asperity
