#include "core/surface/profile_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string errorOf(const std::string& text) {
  return errorFrom([&] { parseProfile(text, "p.csv"); });
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

/// On both sides of one part in a million, in the step before a moved position and in the one
/// after.
TEST(ProfileFile, SpacingIsUniformToOnePartInAMillion) {
  const auto errorWith = [](const std::string& third) {
    return errorOf("0,1\n1,1\n" + third + ",1\n3,1\n");
  };
  for (const char* accepted : {"2", "2.0000005", "1.9999995", "2.0000009", "1.9999991"})
    EXPECT_EQ(errorWith(accepted), "no error") << accepted;
  for (const char* refused : {"2.0000011", "1.9999989", "2.00001", "2.001", "1.99"})
    EXPECT_THAT(errorWith(refused), HasSubstr("positions must be uniform to 1e-6")) << refused;
}

/// A first row is a header only where it names columns.
TEST(ProfileFile, AMalformedFirstRowIsAnErrorWithItsLine) {
  for (const char* row : {"0;1..2", "0,1e", "x,1", "1,x", "1.2.3,4", "12abc", "0 1", "-,-", ",",
                          "1e-3m,2", ".5.", "0,NA", "N/A", "null", "0,1,", "?", "--"})
    EXPECT_THAT(errorOf(std::string(row) + "\n1,2\n2,3\n3,4\n"), HasSubstr("p.csv: row 1: "))
        << row;
  EXPECT_THAT(errorOf("nan,1\n1,2\n2,3\n3,4\n"),
              HasSubstr("row 1: column 1 is not a finite number"));
  EXPECT_THAT(errorOf("# made by hand\n\n0;1..2\n1;2\n2;3\n3;4\n"),
              HasSubstr("row 3: column 2 is not a number"));
  for (const char* header : {"x,z", "position,height", "x (m),z (m)", "\"Weg\";\"Höhe\"", "Höhe",
                             "x [m]\tz [m]", "distance / m, height / m", ",height", "x in metres"})
    EXPECT_EQ(errorOf(std::string(header) + "\n0;1\n1;2\n2;3\n"), "no error") << header;
}

/// Lengths are metres: what a header says of another unit is never passed over.
TEST(ProfileFile, AUnitThatIsNotMetresIsRefused) {
  for (const char* header :
       {"x (mm),z (um)", "x [mm]\tz [m]", "x/mm;z/mm", "distance / mm,height / µm", "x_mm,z_um",
        "x mm,z mm", "mm,um", "x(MM),z(m)", "Position [nm],Height", "x,z (Å)", "x (in),z (in)",
        "x,z (1e-6 m)", "x,z [10^-9 m]", "lateral (pixels),z", "x,height in micrometres",
        "x (\xB5m),z", "t (s),z (m)", "# x (mm),z (um)", "# z (nm)"})
    EXPECT_THAT(errorOf(std::string(header) + "\n0;1\n1;2\n2;3\n"),
                testing::ContainsRegex(
                    "row 1: column [12] is in '.*'; positions and heights are in metres"))
        << header;
  for (const char* comment :
       {"# tip of 2 um radius", "# 10 mm stylus, 1 mm/s", "# rate (1/s), 4 mm",
        "# asperity: {\"length\":0.02,\"x\":\"mm\",\"y\":1}"})
    EXPECT_EQ(errorOf(std::string(comment) + "\n0;1\n1;2\n2;3\n"), "no error") << comment;
  EXPECT_LT(errorOf("x (m " + std::string(600, 'y') + " =-6\n1.1\n2\n3\n").size(), 400U);
}

/// A comma divides columns; where it may as well stand in a number nobody can tell.
TEST(ProfileFile, ACommaThatMayStandInANumberIsRefused) {
  const std::string says = "may divide columns, thousands or decimals";
  for (const char* rows :
       {"1,000\n2,000\n3,000\n", "1,250\n2,250\n3,250\n", "0,05\n1,05\n2,05\n",
        "0,0000012\n1,0000013\n2,0000014\n", "-1,000\n0,000\n1,000\n", "height\n1,5\n2,5\n3,5\n",
        "0,1;1,2\n0,2;1,3\n0,3;1,4\n", "0;1,5\n1;2,5\n2;3,5\n", "1\t2,5\n2\t3,5\n3\t4,5\n",
        "x,z\n1,000\n2,000\n3,000\n"})
    EXPECT_THAT(errorOf(rows), HasSubstr(says)) << rows;
  EXPECT_THAT(errorOf("0,1\n1,1\n2,001\n"), HasSubstr("row 3: the comma may divide"));
  for (const char* rows :
       {"0,1\n1,2\n2,3\n", "0,10\n1,20\n2,30\n", "0,0.05\n1,0\n2,0\n", "x,z\n1,250\n2,300\n3,350\n",
        "0, 005\n1, 006\n2, 007\n", "0,1e-6\n0.5,-2e-6\n1.0,3e-6\n"})
    EXPECT_EQ(errorOf(rows), "no error") << rows;
}

TEST(ProfileFile, FilesOfAnotherKindAreNamed) {
  EXPECT_THAT(errorOf(std::string("1\0\n\0002\0\n\0003\0", 10)),
              HasSubstr("p.csv: is text in UTF-16; a profile is CSV in UTF-8"));
  EXPECT_THAT(errorOf("PK\3\4"), HasSubstr("is a ZIP archive (as of a spreadsheet); a profile"));
}

/// A scene may name any file, so that its content must not appear in a message.
TEST(ProfileFile, MessagesNamePlacesAndNotContent) {
  EXPECT_EQ(errorOf("1\n2\n\x1b[31m\xff\n"), "p.csv: row 3: column 1 is not a number");
}

// ---- Parts of a file ----------------------------------------------------------------------------

/// A slow wave and a fast one, 5 um apart; with positions or without.
std::string waves(std::size_t rows, bool hasPositions) {
  std::string text = hasPositions ? "x (m),z (m)\n" : "z (m)\n";
  for (std::size_t i = 0; i < rows; ++i) {
    const auto x = static_cast<double>(i);
    const double height = 1e-6 * std::sin(6.283185307179586 * x / static_cast<double>(rows)) +
                          1e-7 * std::sin(0.7 * x);
    text += hasPositions ? fmt::format("{},{}\n", 5e-6 * x, height) : fmt::format("{}\n", height);
  }
  return text;
}

TEST(ProfileExtent, IsThatOfTheWholeFile) {
  const TemporaryFolder folder;
  for (const std::size_t rows : {3U, 500U, 900U, 40000U, 300000U})
    for (const bool hasPositions : {true, false}) {
      const auto file = folder.write("p.csv", waves(rows, hasPositions));
      const ProfileExtent extent = profileExtent(file);
      const auto exact = static_cast<double>(rows);
      if (hasPositions) {
        EXPECT_EQ(extent.rows, static_cast<std::int64_t>(rows));
        EXPECT_NEAR(extent.length, 5e-6 * exact, 5e-6 * exact * 1e-9);
      } else {
        EXPECT_NEAR(static_cast<double>(extent.rows), exact, 0.03 * exact);
        EXPECT_EQ(extent.length, 0);
      }
      EXPECT_NEAR(extent.rmsHeight, 1e-6 * std::sqrt(0.505), rows > 3 ? 5e-8 : 1e-6) << rows;
    }
}

TEST(ProfileExtent, AFaultAtEitherEndIsFoundWithItsRow) {
  const TemporaryFolder folder;
  const std::string good = waves(40000, true);
  const auto complaint = [&](const std::string& text) {
    return errorFrom([&] { profileExtent(folder.write("p.csv", text)); });
  };
  EXPECT_EQ(complaint(good), "no error");
  EXPECT_THAT(complaint(good + "high,1\n"), HasSubstr("row 40002: column 1 is not a number"));
  EXPECT_THAT(complaint(good + "0,1\n"), HasSubstr("positions must increase"));
  EXPECT_THAT(complaint(good + "9,1\n"), HasSubstr("positions must be uniform"));
  EXPECT_THAT(complaint("a\nb\n" + good), HasSubstr("row 2: column 1 is not a number"));
}

/// What stands in the middle is left to the run, unless it looks like no rows at all.
TEST(ProfileExtent, PartsThatDoNotFitAreReadWhole) {
  const TemporaryFolder folder;
  std::string text = waves(40000, true);
  text += std::string(text.size(), '\n');  // half of the file is empty lines
  EXPECT_EQ(profileExtent(folder.write("p.csv", text)).rows, 40000);
}

TEST(ProfileStart, IsTheFirstRows) {
  const TemporaryFolder folder;
  const auto file = folder.write("p.csv", waves(5000, true));
  const Profile whole = readProfile(file);
  for (const std::int64_t rows : {3, 100, 2500, 5000}) {
    const Profile start = readProfileStart(file, rows);
    ASSERT_EQ(start.height.size(), static_cast<std::size_t>(rows));
    EXPECT_TRUE(std::equal(start.height.begin(), start.height.end(), whole.height.begin()));
    EXPECT_NEAR(start.length, 5e-6 * static_cast<double>(rows), 1e-9);
  }
  EXPECT_EQ(readProfileStart(file, 6000).height, whole.height);
}

}  // namespace
}  // namespace asperity
