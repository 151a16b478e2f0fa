// Archives in memory: files come back as they were packed, and archives that lie are refused.
#include "core/measured/zip_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/stop.h"
#include "tests/core/error_from.h"
#include "tests/core/measured/written_surface.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kNoLimit = std::uint64_t{1} << 40;

/// Reads one file of an archive in memory.
std::string unpacked(const std::string& archive, const std::string& file,
                     std::uint64_t limit = kNoLimit, const std::stop_token& stop = {},
                     const ReadingProgress& progress = {}) {
  const std::string name = "surface.x3p";
  const ReadingChoices choices;
  return ZipArchive({archive, name, choices, stop, progress}).read(file, limit);
}

std::string refusal(const std::string& archive, std::uint64_t limit = kNoLimit) {
  return errorFrom([&] { unpacked(archive, "data.bin", limit); });
}

/// More bytes than are unpacked at once, and hardly two alike in a row.
std::string manyBytes() {
  std::string bytes(3'000'000, '\0');
  std::uint32_t state = 1;
  for (char& byte : bytes) byte = static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
  return bytes;
}

TEST(ZipArchive, FilesComeBackAsTheyWerePacked) {
  const std::string large = manyBytes();
  for (const bool isDeflated : {false, true}) {
    const std::string archive =
        zipped({{"data.bin", large}, {"Empty.txt", ""}, {"a/b.txt", "text"}}, isDeflated);
    EXPECT_EQ(unpacked(archive, "data.bin"), large);
    EXPECT_EQ(unpacked(archive, "data.bin", large.size()), large);
    EXPECT_EQ(unpacked(archive, "a/b.txt"), "text");
    // Instruments write names in any case.
    EXPECT_EQ(unpacked(archive, "empty.TXT"), "");
  }
}

TEST(ZipArchive, WhatIsMissingOrTooLargeIsNamed) {
  EXPECT_THAT(refusal(zipped({{"other.bin", "text"}})),
              HasSubstr("has no file 'data.bin' in its archive"));
  EXPECT_THAT(refusal(zipped({{"data.bin", "text"}}), 3),
              HasSubstr("'data.bin' in its archive is larger than the 3 bytes allowed"));
}

/// The directory states more bytes, or fewer, than there are: neither is believed.
TEST(ZipArchive, StatedSizesAreNotBelieved) {
  for (const std::uint32_t size : {1U, 5U, 0x7fffffffU, 0xfffffffeU})
    EXPECT_THAT(refusal(zipped({{"data.bin", "text"}}, true, size)),
                HasSubstr("'data.bin' in its archive cannot be unpacked"))
        << size;
}

TEST(ZipArchive, DamagedBytesAreRefused) {
  std::string archive = zipped({{"data.bin", "text"}}, false);
  archive[archive.find("text")] = 'n';
  EXPECT_THAT(refusal(archive), HasSubstr("cannot be unpacked"));
  const std::string whole = zipped({{"data.bin", "text"}});
  for (const std::size_t size : {std::size_t{10}, whole.size() - 1})
    EXPECT_THAT(refusal(whole.substr(0, size)), HasSubstr("is not a whole ZIP archive")) << size;
}

/// Unpacking is half of the work of a reader.
TEST(ZipArchive, ReportsItsPartAndStops) {
  const std::string archive = zipped({{"data.bin", manyBytes()}});
  std::vector<double> parts;
  unpacked(archive, "data.bin", kNoLimit, {}, [&parts](double part) { parts.push_back(part); });
  ASSERT_GE(parts.size(), 2U);
  EXPECT_TRUE(std::ranges::is_sorted(parts));
  EXPECT_EQ(parts.back(), 0.5);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(unpacked(archive, "data.bin", kNoLimit, stop.get_token()), StopRequested);
}

}  // namespace
}  // namespace asperity::written
