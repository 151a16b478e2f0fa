// X3P: a known surface written in every variant comes back; archives that lie are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/measured/surface_expectations.h"
#include "tests/core/measured/x3p_writer.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

TEST(X3pFile, TheTestsHaveAnMd5OfTheirOwn) {
  // RFC 1321, appendix A.5.
  EXPECT_EQ(md5(""), "d41d8cd98f00b204e9800998ecf8427e");
  EXPECT_EQ(md5("abcdefghijklmnopqrstuvwxyz"), "c3fcd3d76192e4007dfb496cca67e13b");
}

TEST(X3pFile, ReadsEveryVariant) {
  for (const char type : {'I', 'L', 'F', 'D'})
    for (const bool incremental : {false, true})
      for (const bool listed : {false, true})
        for (const bool gap : {false, true})
          for (const bool packed : {false, true}) {
            X3pOptions options;
            options.zType = type;
            options.zIncremental = incremental;
            options.listed = listed;
            options.withGap = gap;
            options.maskFile = gap && !listed && (type == 'I' || type == 'L' || packed);
            options.packed = packed;
            options.checksums = packed || type == 'D';
            options.prefix = packed ? "p:" : "";
            expectKnown(read(x3p(options)), "x3p", gap, 1e-12);
          }
}

/// The rotation of the axes is not applied, which is said where there is one.
TEST(X3pFile, SaysThatItDoesNotTurnAxes) {
  const auto turned = [](const char* r11, const char* r22, const char* r33) {
    const X3pOptions options{.checksums = false};
    X3pParts parts = x3pParts(options);
    const std::string matrix = fmt::format(
        "<Rotation><r11>{}</r11><r12>0</r12><r13>0</r13><r21>0</r21><r22>{}</r22><r23>0</r23>"
        "<r31>0</r31><r32>0</r32><r33>{}</r33></Rotation>",
        r11, r22, r33);
    parts.main.insert(parts.main.find("</Axes>"), matrix);
    return read(x3pArchive(options, parts));
  };
  const MeasuredFile plain = turned("1", "1.0", "1");
  expectKnown(plain, "x3p", false, 1e-12);
  EXPECT_FALSE(says(plain, "turns its axes"));
  const MeasuredFile level = turned("-1", "-1", "1");
  expectKnown(level, "x3p", false, 1e-12);
  EXPECT_TRUE(says(level, "The file turns its axes (Rotation in main.xml). The program does not"));
  EXPECT_FALSE(says(level, "count downwards"));
  EXPECT_TRUE(says(turned("-1", "1", "-1"), "its heights would count downwards"));
}

/// Some programs pack a folder and not what is in it.
TEST(X3pFile, ReadsFilesInOneFolder) {
  X3pOptions options;
  options.withGap = options.maskFile = true;
  const X3pParts parts = x3pParts(options);
  const auto archive = [&parts](const std::string& folder, const std::string& other) {
    return zipped({{folder + "main.xml", parts.main},
                   {other, parts.main},
                   {folder + "bindata/data.bin", parts.points},
                   {folder + "bindata/valid.bin", parts.valid},
                   {folder + "md5checksum.hex", md5(parts.main) + " *main.xml\r\n"}},
                  true);
  };
  for (const std::string folder : {"scan 3/", "a/b/"})
    expectKnown(read(archive(folder, "__MACOSX/._main.xml")), "x3p", true, 1e-12);
  EXPECT_THAT(errorOf(archive("scan 3/", "scan 4/main.xml")),
              HasSubstr("has no file 'main.xml' in its archive"));
}

TEST(X3pFile, ReadsStoredPositions) {
  for (const bool listed : {false, true})
    for (const bool absoluteY : {false, true}) {
      X3pOptions options;
      options.absoluteX = true;
      options.absoluteY = absoluteY;
      options.listed = listed;
      expectKnown(read(x3p(options)), "x3p", false, 1e-12, 1e-9);
    }
}

TEST(X3pFile, MayNotStateHowFarItsRowsAreApart) {
  const X3pOptions options;
  X3pParts parts = x3pParts(options);
  const auto eraseIncrement = [&parts](const char* axis) {
    const std::size_t begin = parts.main.find("<Increment>", parts.main.find(axis));
    const std::string end = "</Increment>";
    parts.main.erase(begin, parts.main.find(end, begin) + end.size() - begin);
  };
  eraseIncrement("<CY>");
  const Topography rows = read(x3pArchive(options, parts)).topography;
  EXPECT_NEAR(rows.columnSpacing, kColumnSpacing, 1e-15);
  EXPECT_EQ(rows.rowSpacing, 0);
  // The user's spacing is that of both where the file states neither.
  eraseIncrement("<CX>");
  ReadingChoices spacing;
  spacing.spacing = 2e-6;
  EXPECT_EQ(read(x3pArchive(options, parts), spacing).topography.rowSpacing, 2e-6);
}

TEST(X3pFile, ReadsProfiles) {
  for (const bool absolute : {false, true})
    for (const bool listed : {false, true}) {
      X3pOptions options;
      options.feature = "PRF";
      options.rows = 1;
      options.absoluteX = absolute;
      options.listed = listed;
      expectKnown(read(x3p(options)), "x3p", false, 1e-12, 1e-9, 1);
      options.rowSpacing = 0;  // there is no other row
      expectKnown(read(x3p(options)), "x3p", false, 1e-12, 1e-9, 1);
    }
}

/// Some programs separate the folders of an archive by a backslash.
TEST(X3pFile, ReadsFoldersOfWindows) {
  const std::string windows = "bindata\\data.bin";
  X3pOptions options;
  for (std::string* const name : {&options.link, &options.entry}) {
    *name = windows;
    expectKnown(read(x3p(options)), "x3p", false, 1e-12, 1e-9);
  }
}

TEST(X3pFile, ComparesChecksums) {
  X3pOptions options;
  options.upperCase = true;
  expectKnown(read(x3p(options)), "x3p", false, 1e-12);
  options.pointMd5 = "00000000000000000000000000000000";
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("data.bin' in its archive does not have the MD5"));
  options.pointMd5.clear();
  options.mainMd5 = "d41d8cd98f00b204e9800998ecf8427e";
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("main.xml' in its archive does not have the MD5"));
}

TEST(X3pFile, RefusesWhatHasNoGrid) {
  X3pOptions options;
  options.feature = "PCL";
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("PCL"));
  options.feature = "XYZ";
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("FeatureType"));
}

TEST(X3pFile, RefusesArchivesThatLie) {
  X3pOptions options;
  // Sizes beyond what is there, and beyond every memory.
  options.claimedColumns = 8;
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("ends too early"));
  options.claimedColumns = 2000000000;
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("at most"));
  options.claimedColumns = kColumns;
  const X3pParts parts = x3pParts(options);
  EXPECT_THAT(errorOf(zipped({{"other.xml", parts.main}})), HasSubstr("is a ZIP archive"));
  EXPECT_THAT(errorOf(zipped({{"other.xml", parts.main}}), {.format = "x3p"}),
              HasSubstr("no file 'main.xml'"));
  EXPECT_THAT(errorOf(zipped({{"main.xml", parts.main}})), HasSubstr("no file 'bindata/data.bin'"));
  EXPECT_THAT(errorOf(zipped({{"main.xml", "<a><b></a>"}})), HasSubstr("not valid XML"));
  EXPECT_THAT(errorOf(zipped({{"main.xml", "<a/>"}})), HasSubstr("ISO5436_2"));
}

TEST(X3pFile, DoesNotUnpackBombs) {
  // 200 MB of blanks pack to 200 kB; heights as text never pack that well.
  const std::string bomb = zipped({{"main.xml", std::string(200'000'000, ' ')}});
  ASSERT_LT(bomb.size(), 400'000u);
  EXPECT_THAT(errorOf(bomb), HasSubstr("larger than"));
  X3pOptions options;
  const X3pParts parts = x3pParts(options);
  EXPECT_THAT(errorOf(zipped(
                  {{"main.xml", parts.main}, {"bindata/data.bin", std::string(50'000'000, '\0')}})),
              HasSubstr("larger than"));
}

TEST(X3pFile, ExpandsNoEntities) {
  X3pOptions options;
  options.checksums = false;
  options.prologue =
      "<!DOCTYPE lolz [<!ENTITY a \"lol\"><!ENTITY b \"&a;&a;&a;&a;\"><!ENTITY f SYSTEM "
      "\"file:///etc/passwd\">]>";
  options.extra = "<Comment>&b;&f;</Comment>";
  expectKnown(read(x3p(options)), "x3p", false, 1e-12);
}

}  // namespace
}  // namespace asperity::written
