#include "core/surface/profile_file.h"

#include <gmock/gmock.h>

#include "core/scene/input_error.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string errorOf(const std::string& text) {
  try {
    parseProfile(text, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ProfileFile, PositionAndHeightWithAHeader) {
  const Profile profile = parseProfile("x (m),z (m)\n0,1\n0.5,2\r\n1.0, 3\n", "p.csv");
  EXPECT_THAT(profile.height, ElementsAre(1, 2, 3));
  EXPECT_DOUBLE_EQ(profile.length, 1.5);
}

TEST(ProfileFile, HeightsAloneHaveNoLength) {
  const Profile profile = parseProfile("\xEF\xBB\xBF# measured\n1e-6\n\n-2e-6\n+3e-6", "p.csv");
  EXPECT_THAT(profile.height, ElementsAre(1e-6, -2e-6, 3e-6));
  EXPECT_EQ(profile.length, 0);
}

TEST(ProfileFile, OtherSeparators) {
  EXPECT_THAT(parseProfile("0;1\n1;2\n2;3\n", "p.csv").height, ElementsAre(1, 2, 3));
  EXPECT_THAT(parseProfile("0\t1\n1\t2\n2\t3\n", "p.csv").height, ElementsAre(1, 2, 3));
}

TEST(ProfileFile, BadFilesAreRefusedWithTheirRow) {
  EXPECT_THAT(errorOf("x,z\n0,1\n"), HasSubstr("p.csv: has 1 rows"));
  EXPECT_THAT(errorOf(""), HasSubstr("has 0 rows"));
  EXPECT_THAT(errorOf("1\n2\nthree\n"), HasSubstr("row 3: column 1 is not a number"));
  EXPECT_THAT(errorOf("1\n2\nnan\n"), HasSubstr("row 3: column 1 is not a finite number"));
  EXPECT_THAT(errorOf("0,1\n1\n2,3\n"), HasSubstr("row 2: has 1 columns"));
  EXPECT_THAT(errorOf("0,1,2\n1,1,2\n2,1,2\n"), HasSubstr("3 columns"));
  EXPECT_THAT(errorOf("0,1\n1,1\n2.1,1\n3.1,1\n"), HasSubstr("uniform"));
  EXPECT_THAT(errorOf("2,1\n1,1\n0,1\n"), HasSubstr("must increase"));
  EXPECT_THAT(errorOf("a\nb\n1\n2\n3\n"), HasSubstr("row 2: column 1 is not a number"));
}

/// A scene may name any file: what stands in it is nobody's business but its owner's.
TEST(ProfileFile, MessagesHoldNothingOfTheFile) {
  for (const char* text :
       {"root:secret:19000:0\nbin:secret\n", "1\n2\nsecret\n", "0,1\n1,secret\n2,3\n"})
    EXPECT_THAT(errorOf(text), Not(HasSubstr("secret")));
  for (const char* text : {"1\n2\n7e77\n", "0,1\n1,7e77\n2,3\n"})
    EXPECT_THAT(errorOf(text), Not(HasSubstr("7e77")));
}

/// Four gigabytes of nothing on the disk: refused by their size, unread.
TEST(ProfileFile, AFarTooLargeFileIsRefusedUnread) {
  const TemporaryFolder folder;
  const auto file = folder.write("p.csv", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 32);
  try {
    readProfile(file);
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("p.csv: is larger than the 268435456 bytes allowed"));
  }
}

TEST(ProfileFile, SpacingUniformToOnePartInAMillionIsAccepted) {
  EXPECT_EQ(errorOf("0,1\n1,1\n2.0000005,1\n3,1\n"), "no error");
}

}  // namespace
}  // namespace asperity
