#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>

#include "core/base/input_error.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

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
TEST(AtomicFile, WhatIsReadIsNotReplacedUnderAnyName) {
  TemporaryFolder folder;
  folder.write("read.csv", "1");
  std::filesystem::create_symlink(folder / "read.csv", folder / "link.csv");
  const std::vector<std::filesystem::path> inputs{folder / "gone.csv", folder / "read.csv"};
  for (const char* name : {"read.csv", "link.csv"})
    EXPECT_THROW(checkReplacesNone(folder / name, inputs), InputError) << name;
  EXPECT_NO_THROW(checkReplacesNone(folder / "gone.csv", inputs));
}

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

/// From here on a renaming ends in this way, as if it came in the moment before.
bool failAtRenaming(std::uint32_t action) {
  constexpr auto is = [](std::uint32_t call, std::uint8_t skipped) {
    return sock_filter{BPF_JMP | BPF_JEQ | BPF_K, skipped, 0, call};
  };
  sock_filter program[] = {{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
#ifdef SYS_rename
                           is(SYS_rename, 3),
#else
                           is(SYS_renameat, 3),
#endif
                           is(SYS_renameat, 2),
                           is(SYS_renameat2, 1),
                           {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
                           {BPF_RET | BPF_K, 0, 0, action}};
  const sock_fprog filter{std::size(program), program};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

/// Killed while it replaces a file, which is the one moment that leaves a part. Returns its name.
std::string leavePart(const TemporaryFolder& folder, const std::string& name) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (failAtRenaming(SECCOMP_RET_KILL_PROCESS)) writeFileAtomically(folder / name, "never seen");
    ::_exit(0);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status)) << "it was not killed";
  for (const std::string& found : folder.names())
    if (found.ends_with(".part")) return found;
  return "";
}

TEST(AtomicFile, TheNextWriteRemovesWhatAKillLeft) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "old");
  ASSERT_NE(leavePart(folder, "a.csv"), "");
  EXPECT_EQ(TemporaryFolder::read(file), "old");
  writeFileAtomically(file, "new");
  EXPECT_EQ(TemporaryFolder::read(file), "new");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

TEST(AtomicFile, AndAlsoWhereTheFileIsGone) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "old");
  ASSERT_NE(leavePart(folder, "a.csv"), "");
  std::filesystem::remove(file);
  writeFileAtomically(file, "new");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

TEST(AtomicFile, WhatAnotherProcessIsWritingStays) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "old");
  const std::string part = leavePart(folder, "a.csv");
  const int other = ::open((folder / part).c_str(), O_RDWR);
  ASSERT_GE(other, 0);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  writeFileAtomically(file, "new");
  EXPECT_EQ(TemporaryFolder::read(file), "new");
  EXPECT_THAT(folder.names(), UnorderedElementsAre("a.csv", part));
  ::close(other);
  writeFileAtomically(file, "newer");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

/// A long name bears no addition; two writes at once of one file do not meet.
TEST(AtomicFile, LongNamesAndTwoWritesAtOnce) {
  const TemporaryFolder folder;
  const std::string name = std::string(251, 'n') + ".csv";
  writeFileAtomically(folder / name, "first");
  {
    AtomicFile one(folder / name), other(folder / name);
    one.write("one");
    other.write("other");
    one.commit();
    other.commit();
  }
  EXPECT_EQ(TemporaryFolder::read(folder / name), "other");
  EXPECT_THAT(folder.names(), ElementsAre(name));
}

mode_t permissionsOf(const std::filesystem::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 0777U;
}

TEST(AtomicFile, AReplacedFileKeepsItsPermissions) {
  const TemporaryFolder folder;
  for (const mode_t mode : {0600U, 0640U, 0444U, 0666U, 0755U}) {
    const auto file = folder.write("a.csv", "old");
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    {
      AtomicFile next(file);
      next.write("new");
      struct stat open {};
      ASSERT_EQ(::fstat(next.descriptor(), &open), 0);
      EXPECT_EQ(open.st_mode & 0777U, mode) << "open to others while it is written";
      next.commit();
    }
    EXPECT_EQ(permissionsOf(file), mode);
    EXPECT_EQ(TemporaryFolder::read(file), "new");
    std::filesystem::remove(file);
  }
  writeFileAtomically(folder / "first.csv", "first");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(permissionsOf(folder / "first.csv"), 0666U & ~mask);
}

TEST(AtomicFile, ALinkIsWrittenThroughOrRefusedBeforeAnyWork) {
  const TemporaryFolder folder;
  folder.write("target.csv", "old");
  std::filesystem::create_symlink("target.csv", folder / "link.csv");
  writeFileAtomically(folder / "link.csv", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_EQ(TemporaryFolder::read(folder / "target.csv"), "new");

  std::filesystem::create_symlink("gone.csv", folder / "dangling.csv");
  std::filesystem::create_symlink("missing/gone.csv", folder / "further.csv");
  std::filesystem::create_symlink("dangling.csv", folder / "twice.csv");
  std::filesystem::create_symlink("round.csv", folder / "round.csv");
  for (const char* name : {"dangling.csv", "further.csv", "twice.csv", "round.csv"}) {
    EXPECT_THROW(checkWritable(folder / name), InputError) << name;
    EXPECT_THROW(writeFileAtomically(folder / name, "new"), InputError) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "gone.csv"));
}

/// In a child process that ends in the moment when the file has a hidden name.
TEST(AtomicFile, AnEndThatIsToldOfRemovesTheHiddenName) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "old");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGSYS, [](int) {
      removeUnfinishedFiles();
      ::_exit(7);
    });
    if (failAtRenaming(SECCOMP_RET_TRAP)) writeFileAtomically(file, "never seen");
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(TemporaryFolder::read(file), "old");
  EXPECT_THAT(folder.names(), ElementsAre("a.csv"));
}

}  // namespace
}  // namespace asperity
