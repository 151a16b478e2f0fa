// Files that are broken or meant to break a reader: one line each time, no crash, no giant
// allocation. And the sizes that must be read in time.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "core/base/jobs.h"
#include "core/base/stop.h"
#include "tests/core/error_from.h"
#include "tests/core/measured/binary_writers.h"
#include "tests/core/measured/instrument_writers.h"
#include "tests/core/measured/surface_expectations.h"
#include "tests/core/measured/x3p_writer.h"
#include "tests/core/temporary_folder.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

/// One small file of each format.
std::map<std::string, std::string> samples() {
  X3pOptions listed, masked, profile;
  listed.listed = true;
  masked.withGap = masked.maskFile = true;
  profile.feature = "PRF";
  profile.rows = 1;
  profile.absoluteX = true;
  SurOptions packed;
  packed.packed = true;
  return {{"sdf binary", binarySdf<std::int16_t>(5, true)},
          {"sdf double", binarySdf<double>(7, true, true)},
          {"sdf text",
           "aISO-1.0\nManufacID = T\nNumPoints = 3\nNumProfiles = 2\nXscale = 1e-6\nYscale = "
           "1e-6\nZscale = "
           "1e-6\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n1 2 3\n4 5 BAD\n*\n"},
          {"sur", sur({})},
          {"sur packed", sur(packed)},
          {"smd", smd(SmdForm::Steps)},
          {"prf", smd(SmdForm::Pairs)},
          {"zygo points", zygo({.withGap = true})},
          {"zygo phases", zygo({.hasPoints = false})},
          {"zygo binary", binaryZygo({.withGap = true})},
          {"wyko", wyko({.withGap = true})},
          {"gsf", gsf(gsfHeader(), true)},
          {"gwy", gwyOfThree(true)},
          {"x3p", x3p({})},
          {"x3p listed", x3p(listed)},
          {"x3p masked", x3p(masked)},
          {"x3p profile", x3p(profile)},
          {"text", "# x [mm]\tz [um]\n0,0\t1,5\n0,1\t1,6\n0,2\tBAD\n0,3\t-1,5\n"},
          {"utf-16", std::string("\xFF\xFEx\0;\0z\0\n\0"
                                 "0\0;\0"
                                 "1\0\n\0"
                                 "1\0;\0"
                                 "2\0\n\0"
                                 "2\0;\0"
                                 "3\0\n\0",
                                 34)}};
}

/// Reads or refuses in one short line; anything else fails the test.
void readOrRefuse(const std::string& bytes, const std::string& what) {
  try {
    const MeasuredFile file = read(bytes);
    EXPECT_EQ(file.topography.height.size(), static_cast<std::size_t>(file.facts.points)) << what;
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << what;
    EXPECT_LT(text.size(), 400u) << what;
  }
}

TEST(HostileFiles, AreReadOrRefusedWhereverTheyAreCutOff) {
  for (const auto& [name, bytes] : samples()) {
    EXPECT_TRUE(errorOf(bytes) == "no error" || name == "utf-16") << name << ": " << errorOf(bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      readOrRefuse(bytes.substr(0, size), fmt::format("{} cut off at {}", name, size));
  }
}

TEST(HostileFiles, AreReadOrRefusedWhicheverByteIsWrong) {
  for (const auto& [name, bytes] : samples())
    for (std::size_t at = 0; at < bytes.size(); ++at)
      for (const int change : {0x01, 0x80, 0xFF}) {
        std::string other = bytes;
        other[at] = static_cast<char>(other[at] ^ change);
        readOrRefuse(other, fmt::format("{} changed at {}", name, at));
      }
}

TEST(HostileFiles, ThatAreNoFilesAreRefused) {
  const TemporaryFolder folder;
  const auto errorOfFile = [](const std::filesystem::path& file) {
    return errorFrom([&] { readMeasuredFile(file); });
  };
  EXPECT_THAT(errorOfFile(folder.path()), HasSubstr("is a folder"));
  EXPECT_THAT(errorOfFile(folder / "none.txt"), HasSubstr("none.txt"));
  EXPECT_THAT(errorOfFile(folder.write("empty.txt", "")), HasSubstr("is empty"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(errorOfFile(folder / "pipe"), HasSubstr("is a pipe"));
}

TEST(HostileFiles, OfSizesThatOverflowAreRefused) {
  EXPECT_THAT(errorOf(gsf("XRes = 9223372036854775807\nYRes = 9223372036854775807\n", false)),
              HasSubstr("at most"));
  EXPECT_THAT(errorOf(gsf("XRes = 99999999999999999999\nYRes = 1\n", false)), HasSubstr("XRes"));
  std::string bytes = binarySdf<double>(7, false, true);
  for (std::size_t i = 42; i < 50; ++i) bytes[i] = '\xFF';
  EXPECT_THAT(errorOf(bytes), HasSubstr("at most"));
  const std::string field =
      gwyObject("GwyDataField", gwyInt("xres", 2000000000) + gwyInt("yres", 2000000000));
  EXPECT_NE(errorOf(gwy(gwyMember("/0/data", field))), "no error");
}

TEST(HostileFiles, StopWhereTheyAreAsked) {
  std::stop_source stop;
  stop.request_stop();
  for (const auto& [name, bytes] : samples())
    EXPECT_THROW(readMeasuredBytes(bytes, name, {}, stop.get_token()), StopRequested) << name;
}

// ---- Gwyddion ----------------------------------------------------------------------------------

/// Lets a script be the only program of that name while it lives.
class FakeGwyddion {
 public:
  FakeGwyddion(const TemporaryFolder& folder, const std::string& script)
      : path_(std::getenv("PATH")) {
    const std::filesystem::path bin = folder / "bin";
    std::filesystem::create_directory(bin);
    if (!script.empty()) {
      std::ofstream(bin / "gwyddion") << "#!/bin/sh\nPATH=" << path_ << "\n" << script << "\n";
      std::filesystem::permissions(bin / "gwyddion", std::filesystem::perms::owner_all);
    }
    ::setenv("PATH", bin.c_str(), 1);
  }
  ~FakeGwyddion() { ::setenv("PATH", path_.c_str(), 1); }
  FakeGwyddion(const FakeGwyddion&) = delete;
  FakeGwyddion& operator=(const FakeGwyddion&) = delete;

 private:
  std::string path_;
};

TEST(Gwyddion, ReadsWhatIsOfNoKnownKind) {
  const TemporaryFolder folder;
  const auto file = folder.write("scan.xyz", std::string("\x01\x02\x00\x03 some instrument", 20));
  const auto converted = folder.write("converted.gwy", gwyOfThree(true));
  const FakeGwyddion program(folder, "for word; do case $word in --convert-to-gwy=*) cp " +
                                         converted.string() + " \"${word#*=}\";; esac; done");
  const MeasuredFile made = readMeasuredFile(file);
  expectKnown(made, "gwyddion", true, 1e-20);
}

/// NanoScope and others write lines of text in front of their numbers as bytes.
TEST(Gwyddion, ReadsNumbersAsBytesBelowAHeaderOfText) {
  std::string scan = "\\*File list\r\n\\Version: 0x09200201\r\n\\Data offset: 8192\r\n";
  scan.resize(8192, '\x1A');
  for (int i = 0; i < 4000; ++i) put(scan, static_cast<std::int16_t>(37 * i % 2000 - 1000));
  EXPECT_THAT(errorOf(scan), HasSubstr("is a binary file; text (profiles, matrices, points)"));
  const TemporaryFolder folder;
  const auto file = folder.write("scan.spm", scan);
  {
    const TemporaryFolder empty;
    const FakeGwyddion none(empty, "");
    EXPECT_THAT(errorFrom([&] { readMeasuredFile(file); }),
                HasSubstr("is of a kind that only Gwyddion reads, which is not installed"));
  }
  const auto converted = folder.write("converted.gwy", gwyOfThree(true));
  const FakeGwyddion program(folder, "for word; do case $word in --convert-to-gwy=*) cp " +
                                         converted.string() + " \"${word#*=}\";; esac; done");
  expectKnown(readMeasuredFile(file), "gwyddion", true, 1e-20);
  // Zeros that fill up a text, and one among its numbers, make no binary file.
  std::string text = "x (um),z (um)\n";
  for (int i = 0; i < 2000; ++i) text += fmt::format("{},{}\n", i, i % 7);
  EXPECT_EQ(read(text + std::string(5000, '\0')).topography.columns, 2000);
}

TEST(ZipArchives, WithoutASurfaceAreNamed) {
  const std::string archive = zipped({{"xl/workbook.xml", "<workbook/>"}});
  EXPECT_THAT(
      errorOf(archive),
      HasSubstr("is a ZIP archive (as of a spreadsheet); text (profiles, matrices, points)"));
  EXPECT_THAT(errorOf(archive, {.format = "x3p"}), HasSubstr("has no file 'main.xml'"));
}

TEST(Gwyddion, IsNamedWhereItIsNotInstalled) {
  const TemporaryFolder folder;
  const auto file = folder.write("scan.xyz", std::string("\x01\x02\x00\x03 some instrument", 20));
  const auto error = [&file]() { return errorFrom([&] { readMeasuredFile(file); }); };
  {
    const FakeGwyddion none(folder, "");
    EXPECT_THAT(error(), HasSubstr("is a binary file; without Gwyddion, which is not installed"));
    for (const auto& [bytes, kind] : {std::pair{"\x89PNG\r\n", "a PNG picture"},
                                      {"%PDF-1.4", "a PDF document"},
                                      {"\x1F\x8B\x08 packed", "a gzip archive"}}) {
      const auto foreign = folder.write("foreign", bytes);
      EXPECT_THAT(errorFrom([&] { readMeasuredFile(foreign); }),
                  HasSubstr(std::string("is ") + kind + "; without Gwyddion"));
    }
  }
  const TemporaryFolder other;
  const FakeGwyddion failing(other, "exit 1");
  EXPECT_THAT(error(), HasSubstr("Gwyddion does not read either"));
}

// ---- Size --------------------------------------------------------------------------------------

/// Sanitizers and builds without optimization are no measure of time.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr double kPatience = 20;
#else
constexpr double kPatience = 1;
#endif

TEST(LargeFiles, BinaryTopographiesAreReadInTime) {
  constexpr int kWide = 4096;
  const auto heights = [](auto& bytes, auto number) {
    using Number = decltype(number);
    bytes.reserve(bytes.size() + std::size_t{kWide} * kWide * sizeof(Number));
    for (int i = 0; i < kWide * kWide; ++i)
      put(bytes, static_cast<Number>(i * 2654435761U % 20000));
  };
  std::map<std::string, std::string> files;
  std::string& text = files["gsf"];
  text = fmt::format(
      "Gwyddion Simple Field 1.0\nXRes = {0}\nYRes = {0}\nXReal = 1e-3\nYReal = 1e-3\nXYUnits = m\n"
      "ZUnits = nm\n",
      kWide);
  text.append(4 - text.size() % 4, '\0');
  heights(text, float{});
  std::string& sdf = files["sdf"];
  sdf = "bISO-1.0";
  putText(sdf, "T", 34);
  put<std::uint16_t>(sdf, kWide);
  put<std::uint16_t>(sdf, kWide);
  for (const double number : {1e-6, 1e-6, 1e-9, -1.0}) put(sdf, number);
  sdf += std::string("\0\7\0", 3);
  heights(sdf, double{});
  const auto usedMegabytes = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
  };
  for (const auto& [format, bytes] : files) {
    const double before = threadSeconds();
    const MeasuredFile file = read(bytes);
    const double seconds = threadSeconds() - before;
    RecordProperty(format + "_seconds", fmt::format("{:.3f}", seconds));
    EXPECT_LT(seconds, 2 * kPatience) << format;
    ASSERT_EQ(file.topography.columns, kWide);
    EXPECT_NEAR(file.topography.at(1, 1), 1e-9 * ((kWide + 1) * 2654435761U % 20000), 1e-16);
  }
  // The files themselves are 192 MB of this.
  if (kPatience == 1) {
    EXPECT_LT(usedMegabytes(), 1024);
  }
}

TEST(LargeFiles, AMillionRowsAreReadInTime) {
  std::string text = "x (mm),z (um)\n";
  for (int i = 0; i < 1'000'000; ++i)
    text += fmt::format("{:.4f},{:.5f}\n", 5e-4 * i, std::sin(0.01 * i));
  const double before = threadSeconds();
  const MeasuredFile file = read(text);
  const double seconds = threadSeconds() - before;
  RecordProperty("text_seconds", fmt::format("{:.3f}", seconds));
  EXPECT_LT(seconds, kPatience);
  EXPECT_EQ(file.topography.columns, 1'000'000);
  EXPECT_FALSE(file.facts.resampled);
  EXPECT_NEAR(file.topography.columnSpacing, 5e-7, 1e-13);
}

}  // namespace
}  // namespace asperity::written
