// SDF, SUR, GSF and GWY: a known surface written in every variant comes back, units included.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/measured/binary_writers.h"
#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

TEST(SdfFile, ReadsEveryDataType) {
  for (const bool gap : {false, true})
    for (const bool second : {false, true})
      for (const char* kind : {"ISO", "BCR"}) {
        expectKnown(read(binarySdf<float>(3, gap, second, kind)), "sdf", gap, 1e-12);
        expectKnown(read(binarySdf<std::int8_t>(4, gap, second, kind)), "sdf", gap, 1e-15);
        expectKnown(read(binarySdf<std::int16_t>(5, gap, second, kind)), "sdf", gap, 1e-15);
        expectKnown(read(binarySdf<std::int32_t>(6, gap, second, kind)), "sdf", gap, 1e-15);
        expectKnown(read(binarySdf<double>(7, gap, second, kind)), "sdf", gap, 1e-20);
      }
  expectKnown(read(binarySdf<double>(7, false, false, "ISO", 1)), "sdf", false, 1e-20, 1e-12, 1);
}

TEST(SdfFile, ReadsUnsignedNumbersOfBcr) {
  std::string bytes = binarySdf<std::uint16_t>(1, false);
  // Heights below zero do not exist there: the numbers are put in by hand.
  const std::size_t begin = 81;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const auto value = static_cast<std::uint16_t>(60000 - 7 * i);
    std::memcpy(bytes.data() + begin + 2 * i, &value, 2);
  }
  const MeasuredFile file = read(bytes);
  EXPECT_NEAR(file.topography.at(0, 0), 60000e-9, 1e-15);
  EXPECT_NEAR(file.topography.at(1, 3), (60000 - 7 * 10) * 1e-9, 1e-15);
}

/// Returns a file of SDF with the bytes of each number in reverse order.
std::string bigEndian(std::string bytes, bool second, std::size_t size) {
  std::size_t at = 42;
  const auto reverseNext = [&](std::size_t count) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + count));
    at += count;
  };
  for (const std::size_t count : {second ? 4 : 2, second ? 4 : 2, 8, 8, 8, 8}) reverseNext(count);
  at += 3;
  for (int i = 0; i < kColumns * kRows; ++i) reverseNext(size);
  return bytes;
}

/// Against the standard, but clear.
TEST(SdfFile, ReadsBigEndianNumbersAndSaysSo) {
  for (const bool second : {false, true}) {
    const MeasuredFile file = read(bigEndian(binarySdf<double>(7, true, second), second, 8));
    expectKnown(file, "sdf", true, 1e-20);
    EXPECT_TRUE(says(file, "The numbers begin with their highest byte (big-endian)"));
    expectKnown(read(bigEndian(binarySdf<std::int16_t>(5, true, second), second, 2)), "sdf", true,
                1e-15);
    EXPECT_FALSE(says(read(binarySdf<double>(7, true, second)), "big-endian"));
  }
}

std::string textSdf(bool gap, const std::string& end, bool manyLines, const std::string& version) {
  std::string text =
      version + end + "ManufacID   = TEST" + end + "; a comment" + end +
      "CreateDate = 010120200000" + end + "ModDate = 010120200000" + end +
      fmt::format("NumPoints = {}{}NumProfiles = {}{}", kColumns, end, kRows, end) +
      fmt::format("Xscale = {}{}Yscale = {}{}", kColumnSpacing, end, kRowSpacing, end) +
      "Zscale = 1.0E-6" + end + "Zresolution = -1" + end + "Compression = 0" + end +
      "DataType = 7" + end + "CheckType = 0" + end + "*" + end;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      text += gap && isGap(row, column) ? std::string("BAD")
                                        : fmt::format("{:.5f}", micrometres(row, column));
      text += manyLines && column % 3 == 2 ? end : " ";
    }
    text += end;
  }
  return text + "*" + end + "<Operator>N.N.</Operator>" + end + "*" + end;
}

TEST(SdfFile, ReadsText) {
  for (const bool gap : {false, true})
    for (const std::string end : {"\n", "\r\n", "\r"})
      for (const bool manyLines : {false, true})
        for (const char* version : {"aISO-1.0", "aISO-2.0", "aBCR-1.0"})
          expectKnown(read(textSdf(gap, end, manyLines, version)), "sdf", gap, 1e-15);
}

/// Some programs write numbers in the style of the country.
TEST(SdfFile, ReadsDecimalCommas) {
  std::string text = textSdf(true, "\r\n", false, "aISO-1.0");
  const std::size_t numbers = text.find("NumPoints");
  std::replace(text.begin() + static_cast<std::ptrdiff_t>(numbers),
               text.begin() + static_cast<std::ptrdiff_t>(text.find("<Operator>")), '.', ',');
  expectKnown(read(text), "sdf", true, 1e-15);
  // A table with both marks is damaged.
  text[text.rfind(',')] = '.';
  EXPECT_THAT(errorOf(text), HasSubstr("is not a number"));
}

TEST(SdfFile, NamesWhatIsWrong) {
  std::string text = textSdf(false, "\n", false, "aISO-1.0");
  EXPECT_THAT(errorOf(text.substr(0, text.size() / 2)), HasSubstr("ends"));
  const auto replaced = [&text](const std::string& what, const std::string& by) {
    std::string changed = text;
    return changed.replace(changed.find(what), what.size(), by);
  };
  EXPECT_THAT(errorOf(replaced("Compression = 0", "Compression = 1")), HasSubstr("compressed"));
  EXPECT_THAT(errorOf(replaced("DataType = 7", "DataType = 9")), HasSubstr("DataType 9"));
  EXPECT_THAT(errorOf(replaced("NumPoints = 7", "NumPoints = 0")), HasSubstr("NumPoints"));
  EXPECT_THAT(errorOf(replaced("NumPoints = 7", "NumPoints = 999999999")), HasSubstr("at most"));
  EXPECT_THAT(errorOf(replaced("NumPoints = 7", "NumPoints = 6")),
              HasSubstr("more than the 24 heights"));
  EXPECT_THAT(errorOf(replaced("Xscale", "Wscale")), HasSubstr("no Xscale"));
  EXPECT_THAT(errorOf(replaced("-2.00000", "-2.x")),
              HasSubstr("line 16: height 1 is not a number"));
}

TEST(SurFile, ReadsEveryVariant) {
  for (const int bits : {16, 32})
    for (const bool gap : {false, true})
      for (const bool packed : {false, true})
        for (const std::string comment : {"", "A comment of the measurement"}) {
          SurOptions options;
          options.bits = bits;
          options.withGap = gap;
          options.packed = packed;
          options.comment = comment;
          expectKnown(read(sur(options)), "sur", gap, 1e-12, 1e-6);
        }
  SurOptions profile;
  profile.type = 1;
  profile.rows = 1;
  expectKnown(read(sur(profile)), "sur", false, 1e-12, 1e-6, 1);
}

TEST(SurFile, TakesTheUnitOfEachStep) {
  SurOptions options;
  options.xUnit = "nm";
  options.xMetres = 1e-9;
  options.yUnit = "um";
  options.yMetres = 1e-6;
  options.zUnit = "mm";
  options.zMetres = 1e-3;
  const MeasuredFile file = read(sur(options));
  expectKnown(file, "sur", false, 1e-12, 1e-6);
  EXPECT_EQ(file.facts.positionUnit.unit, "nm");
  EXPECT_EQ(file.facts.positionUnit.source, UnitSource::File);
  options.zUnit = "V";
  EXPECT_THAT(errorOf(sur(options)), HasSubstr("surface.height_unit"));
}

TEST(SurFile, NamesWhatIsWrong) {
  SurOptions options;
  std::string bytes = sur(options);
  const auto changed = [&bytes](std::size_t at, auto value) {
    std::string other = bytes;
    std::memcpy(other.data() + at, &value, sizeof value);
    return other;
  };
  EXPECT_THAT(errorOf(changed(98, std::int16_t{24})), HasSubstr("24 bits"));
  EXPECT_THAT(errorOf(changed(108, std::int32_t{-1})), HasSubstr("above 0"));
  EXPECT_THAT(errorOf(changed(108, std::int32_t{0x7fffffff})), HasSubstr("at most"));
  EXPECT_THAT(errorOf(changed(108, std::int32_t{1000})), HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(changed(120, 0.0F)), HasSubstr("X spacing"));
  EXPECT_THAT(errorOf(changed(18, std::int16_t{12})), HasSubstr("type"));
  options.packed = true;
  bytes = sur(options);
  bytes[bytes.size() - 9] = static_cast<char>(bytes[bytes.size() - 9] ^ 0x55);
  EXPECT_THAT(errorOf(bytes), HasSubstr("cannot be unpacked"));
}

TEST(GsfFile, ReadsAField) {
  for (const bool gap : {false, true}) {
    // Paddings of one to four bytes.
    for (const std::string title : {"", "a", "ab", "abc", "abcd"})
      expectKnown(read(gsf(gsfHeader() + "Comment = " + title + "\n", gap)), "gsf", gap, 1e-12);
  }
  EXPECT_EQ(read(gsf(gsfHeader(), false)).facts.heightColumn, "Height");
  // Arithmetic on a NaN that signals is an invalid operation.
  std::string signalling = gsf(gsfHeader(), true);
  ASSERT_EQ(signalling.find("\xC0\x7F"), signalling.rfind("\xC0\x7F"));
  signalling[signalling.find("\xC0\x7F")] = '\xA0';
  expectKnown(read(signalling), "gsf", true, 1e-12);
}

TEST(GsfFile, NamesWhatIsWrong) {
  EXPECT_THAT(errorOf(gsf("XRes = 7\n", false)), HasSubstr("no YRes"));
  EXPECT_THAT(errorOf(gsf("XRes = seven\nYRes = 4\n", false)), HasSubstr("XRes"));
  EXPECT_THAT(errorOf(gsf("XRes = 7\nYRes = 5\n", false)), HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(gsf("XRes = 4294967296\nYRes = 4294967296\n", false)), HasSubstr("at most"));
  // Without a size the points are metres apart, which is hardly meant.
  EXPECT_THAT(errorOf(gsf("XRes = 7\nYRes = 4\n", false)), HasSubstr("surface.point_spacing"));
  ReadingChoices choices;
  choices.positionUnit = "um";
  EXPECT_NEAR(
      read(gsf("XRes = 7\nYRes = 4\nZUnits = m\n", false), choices).topography.columnSpacing, 1e-6,
      1e-15);
}

TEST(GwyFile, ChoosesTheFirstChannelOfLengths) {
  const MeasuredFile file = read(gwyOfThree());
  expectKnown(file, "gwy", false, 1e-20);
  EXPECT_EQ(file.facts.heightColumn, "Height");
  ReadingChoices third;
  third.heightColumn = 3;
  EXPECT_NEAR(read(gwyOfThree(), third).topography.at(0, 0), 2 * height(0, 0), 1e-20);
  third.heightColumn = 4;
  EXPECT_THAT(errorOf(gwyOfThree(), third), HasSubstr("surface.height_column"));
  ReadingChoices volts;
  volts.heightColumn = 1;
  EXPECT_THAT(errorOf(gwyOfThree(), volts), HasSubstr("surface.height_unit"));
  volts.heightUnit = "um";
  EXPECT_NEAR(read(gwyOfThree(), volts).topography.at(0, 0), 1e-6 * height(0, 0), 1e-20);
}

/// Microscopes write amplitudes and deflections in units of length, too.
TEST(GwyFile, PassesOverOtherLengthsThanHeights) {
  const auto both = [](const std::string& second) {
    return gwy(gwyMember("/0/data", gwyField("m", 2)) +
               gwyText("/0/data/title", "Amplitude Error") + gwyMember("/1/data", gwyField("m")) +
               gwyText("/1/data/title", second));
  };
  const MeasuredFile file = read(both("ZSensor"));
  expectKnown(file, "gwy", false, 1e-20);
  EXPECT_EQ(file.facts.heightColumn, "ZSensor");
  EXPECT_NEAR(read(both("Deflection")).topography.at(0, 0), 2 * height(0, 0), 1e-20);
}

TEST(GwyFile, NamesWhatIsWrong) {
  EXPECT_THAT(errorOf(gwy("")), HasSubstr("no channel"));
  EXPECT_THAT(errorOf(gwy(gwyMember("/0/data", gwyObject("GwyDataField", gwyInt("xres", 7))))),
              HasSubstr("no yres"));
  std::string data = std::string("data") + '\0' + 'D';
  put(data, std::uint32_t{0});
  const std::string withoutRows = gwyInt("xres", 7) + gwyInt("yres", 0) + data;
  EXPECT_THAT(errorOf(gwy(gwyMember("/0/data", gwyObject("GwyDataField", withoutRows)))),
              HasSubstr("yres in the header is not a number above 0"));
  EXPECT_THAT(errorOf("GWYPGwyContainer"), HasSubstr("no end"));
}

// ---- NPY ---------------------------------------------------------------------------------------

void expectKnownArray(const std::string& bytes, const std::string& unit, bool withGap,
                      double tolerance) {
  ReadingChoices choices;
  choices.heightUnit = unit;
  choices.spacing = kColumnSpacing;
  MeasuredFile file = read(bytes, choices);
  EXPECT_NEAR(file.topography.rowSpacing, kColumnSpacing, 1e-12 * kColumnSpacing);
  file.topography.rowSpacing = kRowSpacing;  // the file has one spacing for both directions
  expectKnown(file, "npy", withGap, tolerance);
}

TEST(NpyFile, ReadsEveryTypeOrderAndVersion) {
  for (const bool isFortran : {false, true})
    for (const int version : {1, 2, 3}) {
      expectKnownArray(npy<double>("<f8", version, isFortran, true), "um", true, 1e-20);
      expectKnownArray(npy<double>(">f8", version, isFortran), "um", false, 1e-20);
      expectKnownArray(npy<float>("<f4", version, isFortran, true), "um", true, 1e-12);
      expectKnownArray(npy<float>(">f4", version, isFortran), "um", false, 1e-12);
      expectKnownArray(npy<std::int16_t>("<i2", version, isFortran), "nm", false, 1e-9);
      expectKnownArray(npy<std::int32_t>(">i4", version, isFortran), "nm", false, 1e-9);
      expectKnownArray(npy<std::int64_t>("<i8", version, isFortran), "nm", false, 1e-9);
    }
}

TEST(NpyFile, ReadsUnsignedNumbersAndProfiles) {
  for (const char* shape : {"(4,)", "(1, 4)", "(4, 1)"}) {
    std::string bytes = npy<std::uint16_t>(">u2", 1, false, false, shape);
    const std::size_t begin = bytes.size() - 2 * kColumns * kRows;
    for (int i = 0; i < 4; ++i) {
      bytes[begin + 2 * i] = static_cast<char>(0xEA);  // 0xEA60 is 60000
      bytes[begin + 2 * i + 1] = static_cast<char>(0x60 + i);
    }
    bytes.resize(begin + 8);
    ReadingChoices choices;
    choices.heightUnit = "nm";
    choices.spacing = 1e-6;
    const MeasuredFile file = read(bytes, choices);
    EXPECT_EQ(file.topography.rows, 1);
    ASSERT_EQ(file.topography.columns, 4);
    EXPECT_NEAR(file.topography.at(0, 3), 60003e-9, 1e-15);
  }
}

TEST(NpyFile, NamesWhatIsWrong) {
  ReadingChoices choices;
  choices.spacing = 1e-6;
  choices.heightUnit = "nm";
  EXPECT_THAT(errorOf(npy<double>("<f8")),
              HasSubstr("surface.point_spacing: is needed (in m): the file does not say"));
  for (const char* type : {"|O", "<c16", "<U4", "|b1", "<M8[s]"})
    EXPECT_THAT(errorOf(npy<double>(type), choices),
                HasSubstr(std::string("holds an array of the type ") + type +
                          "; floating-point numbers of 4 or 8 bytes and whole numbers"));
  const std::string structured = replaced(npy<double>("<f8"), "'<f8'", "[('x', '<f8')]");
  EXPECT_THAT(errorOf(structured, choices), HasSubstr("holds an array of the type [('x', '<f8')"));
  EXPECT_THAT(errorOf(npy<double>("<f8", 1, false, false, "(2, 3, 4)"), choices),
              HasSubstr("holds an array of 3 dimensions"));
  EXPECT_THAT(errorOf(npy<double>("<f8", 1, false, false, "()"), choices),
              HasSubstr("holds an array of 0 dimensions"));
  EXPECT_THAT(errorOf(npy<double>("<f8", 1, false, false, "(0, 4)"), choices),
              HasSubstr("shape in the header is not a number above 0"));
  EXPECT_THAT(errorOf(npy<double>("<f8", 1, false, false, "(400, 400)"), choices),
              HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(replaced(npy<double>("<f8"), "'shape'", "'size_'"), choices),
              HasSubstr("the header has no shape"));
  EXPECT_THAT(errorOf(npy<double>("<f8", 9), choices), HasSubstr("is of version 9; 1 to 3"));
  EXPECT_THAT(errorOf(npy<double>("<f8") + "\x93NUMPY", choices),
              HasSubstr("has 6 bytes after its array"));
  for (const char* shape : {"(2, 6)", "(6, 2)"})
    EXPECT_THAT(errorOf(npy<double>("<f8", 1, false, false, shape), choices),
                HasSubstr("it should have heights alone"));
  expectCutOffIsNoHarm(npy<double>("<f8"));
}

}  // namespace
}  // namespace asperity::written
