// Regular files are read; nothing that could wait or act is opened.
#include "core/base/regular_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::string refusal(const std::filesystem::path& file) {
  return errorFrom([&] { RegularFile{file}; });
}

TEST(RegularFile, IsReadFromAnyPlace) {
  const TemporaryFolder folder;
  const RegularFile file(folder.write("a", "0123456789"));
  EXPECT_EQ(file.size(), 10U);
  EXPECT_EQ(file.read(3, 4), "3456");
  EXPECT_EQ(file.read(8, 100), "89");
  EXPECT_EQ(file.read(10, 1), "");
  EXPECT_EQ(file.read(99, 1), "");
  EXPECT_EQ(readRegularFile(folder / "a", 10), "0123456789");
  EXPECT_THROW(readRegularFile(folder / "a", 9), InputError);
}

/// With nobody at the other end, opening a pipe the usual way would wait for ever.
TEST(RegularFile, PipesDevicesAndFoldersAreRefusedAtOnce) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder / "pipe", link = folder / "link";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink(pipe, link);
  for (const std::filesystem::path& file : {pipe, link, std::filesystem::path("/dev/zero")})
    EXPECT_THAT(refusal(file), HasSubstr("only regular files")) << file;
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(folder / std::string("a\0b", 3)), HasSubstr("not a valid file name"));
  EXPECT_THAT(refusal(folder / "gone"), HasSubstr("cannot be opened: No such file"));
}

TEST(WholeFile, ReadingRefusesFoldersMissingAndOversizedFiles) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", std::string(100, 'x'));
  EXPECT_EQ(readWholeFile(file, 100).size(), 100U);
  EXPECT_THROW(readWholeFile(file, 99), InputError);
  EXPECT_THROW(readWholeFile(folder.path(), 99), InputError);
  EXPECT_THROW(readWholeFile(folder / "none", 99), InputError);
}

}  // namespace
}  // namespace asperity
