// What tests of the program share: a folder with a small scene, and what a refusal looks like.
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "tests/app/program.h"

namespace asperity {

inline constexpr const char* kScene =
    R"({"schema":"asperity-scene/1","title":"A scene","surface":{"elements":200},)"
    R"("sweep":{"points":5},"ensemble":{"realizations":6}})";

class ProgramTest : public testing::Test {
 protected:
  void SetUp() override { program.folder.write("s.json", kScene); }

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
