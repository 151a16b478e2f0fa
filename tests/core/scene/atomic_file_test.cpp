#include "core/scene/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/scene/input_error.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(AtomicFile, WritesAndReplacesWithoutLeftovers) {
  const TemporaryFolder folder;
  const auto file = folder / "a.csv";
  writeFileAtomically(file, "first");
  writeFileAtomically(file, "second");
  EXPECT_EQ(TemporaryFolder::read(file), "second");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

TEST(AtomicFile, NamesThatCanNeverBeWrittenAreRefusedBeforeAnyWork) {
  const TemporaryFolder folder;
  EXPECT_THROW(checkWritable(folder.path()), InputError);
  EXPECT_THROW(checkWritable(folder / "missing/a.csv"), InputError);
  EXPECT_THROW(checkWritable("/dev/full"), InputError);
  EXPECT_NO_THROW(checkWritable(folder / "a.csv"));
}

/// A file size limit stands for a full disk: write fails in the middle. Run in a child process,
/// because the limit holds for all files of a process.
TEST(AtomicFile, AFullDiskLeavesTheOldFileAndNoPart) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "old");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      writeFileAtomically(file, std::string(100000, 'x'));
    } catch (const std::runtime_error& error) {
      ::_exit(std::string(error.what()).find("a.csv") != std::string::npos ? 1 : 3);
    }
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(TemporaryFolder::read(file), "old");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

TEST(AtomicFile, ReadingRefusesFoldersMissingAndOversizedFiles) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", std::string(100, 'x'));
  EXPECT_EQ(readWholeFile(file, 100).size(), 100U);
  EXPECT_THROW(readWholeFile(file, 99), InputError);
  EXPECT_THROW(readWholeFile(folder.path(), 99), InputError);
  EXPECT_THROW(readWholeFile(folder / "none", 99), InputError);
}

}  // namespace
}  // namespace asperity
