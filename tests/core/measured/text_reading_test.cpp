// What a person is told, or asked, where the text of a profile can be taken for something else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

constexpr int kRowCount = 60;

double micrometresAt(int i) {
  return 3 * std::sin(0.7 * i) + 0.01 * i;
}

/// Lines made from the number of a point.
template <class Line>
std::string linesOf(const Line& line, int count = kRowCount) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line(i) + "\n";
  return text;
}

void expectSpacing(const MeasuredFile& file, double spacing) {
  EXPECT_NEAR(file.topography.columnSpacing, spacing, 1e-9 * spacing);
  ASSERT_EQ(file.topography.columns, kRowCount);
  for (int i = 0; i < kRowCount; ++i)
    EXPECT_NEAR(file.topography.at(0, i), 1e-6 * micrometresAt(i), 1e-10) << i;
}

/// A first column 0, 1, 2, ... beside a stated distance numbers the points.
TEST(PointNumbers, AreNoPositionsWhereADistanceIsStated) {
  for (const int first : {0, 1}) {
    const std::string rows =
        linesOf([&](int i) { return fmt::format("{}\t{:.4f}", i + first, micrometresAt(i)); });
    expectSpacing(read("Point spacing: 2 \u00B5m\nUnit: \u00B5m\n\n" + rows), 2e-6);
    expectSpacing(read("Pitch\t0.002 mm\nUnit\tum\n[Data]\n" + rows), 2e-6);
    expectSpacing(read("Unit\tum\n" + rows, {.spacing = 3e-6}), 3e-6);
    // With the name of a position, chosen by the user, or without a distance they are positions.
    expectSpacing(read("x [um]\tz [um]\n" + rows, {.spacing = 3e-6}), 1e-6);
    expectSpacing(read("Unit\tum\n" + rows, {.positionColumn = 1, .spacing = 3e-6}), 1e-6);
    expectSpacing(read("Unit\tum\n" + rows), 1e-6);
  }
  const std::string rows =
      linesOf([](int i) { return fmt::format("{}\t{:.4f}", 2 * i, micrometresAt(i)); });
  expectSpacing(read("Point spacing: 5 um\nUnit: um\n\n" + rows), 2e-6);
}

TEST(PointDistances, MayBeStatedForEachPixel) {
  const std::string rows = linesOf([](int i) { return fmt::format("{:.4f}", micrometresAt(i)); });
  for (const std::string unit : {"nm", "nm/pixel", "nm/px", "nm/Point"})
    expectSpacing(read("Pixel size: 1500 " + unit + "\nUnit: um\n" + rows), 1.5e-6);
}

TEST(EmptyLines, InAListOfHeightsAreGaps) {
  const MeasuredFile file =
      read("z [um]\n" + linesOf([](int i) {
             return i % 7 == 2 ? std::string() : fmt::format("{:.4f}", micrometresAt(i));
           }) + "\n\n",
           {.spacing = 2e-6});
  ASSERT_EQ(file.topography.columns, kRowCount);
  for (int i = 0; i < kRowCount; ++i)
    if (i % 7 == 2)
      EXPECT_TRUE(std::isnan(file.topography.at(0, i))) << i;
    else
      EXPECT_NEAR(file.topography.at(0, i), 1e-6 * micrometresAt(i), 1e-10) << i;
}

TEST(Assumptions, AreToldApart) {
  const auto row = [](int i) { return fmt::format("{:.3f};{:.4f}", 2e-3 * i, micrometresAt(i)); };
  EXPECT_FALSE(says(read("x [mm];z [um]\n" + linesOf(row)), "left out"));
  EXPECT_FALSE(says(read("x [mm];z [um]\n" + linesOf(row)), "taken"));
  EXPECT_TRUE(
      says(read("x [mm];z [um]\n" + linesOf(row) + "0.120;1.2.3\n"), "Line 62 is left out"));
  EXPECT_TRUE(says(read("x [mm];z [um]\n0.120;broken\n" + linesOf(row)), "Line 2 is left out"));
  // All have three digits after the mark, and none of them is below 1.
  const auto marked = [](int i) { return fmt::format("{};{:.3f}", i, 5 + micrometresAt(i)); };
  EXPECT_TRUE(says(read("x [um];z [um]\n" + linesOf(marked)), "'.' is taken for the decimal mark"));
}

TEST(Heights, BeyondEveryLengthAreRefused) {
  EXPECT_THAT(errorOf("x [um];z [um]\n0;1\n2;1.70141e38\n4;1\n6;2\n"),
              HasSubstr("line 3: 1.70141e38 is not a height"));
}

/// Steps of 1.3 in whole numbers look like missing points, and nothing tells them apart.
TEST(Positions, RoundedTooCoarselyAreRefused) {
  const auto file = [](double step, int decimals) {
    return "x [um],z [um]\n" + linesOf([&](int i) {
             return fmt::format("{:.{}f},{:.4f}", step * i, decimals, micrometresAt(i));
           });
  };
  EXPECT_THAT(errorOf(file(1.3, 0)), HasSubstr("the positions are rounded to 1, too coarsely"));
  expectSpacing(read(file(1.3, 1)), 1.3e-6);
  // Points that are missing here and there are gaps.
  const MeasuredFile missing =
      read("x [um],z [um]\n" + linesOf([](int i) {
             return fmt::format("{},{:.4f}", i < 20 ? i : i + i / 20 * 6, micrometresAt(i));
           }));
  EXPECT_EQ(missing.facts.gaps, 12);
}

/// Whole numbers may be rounded steps of 1.4 or steps of 1 with missing points.
TEST(Positions, WithFewDigitsAreNamed) {
  const auto file = [](const std::string& positions, double step) {
    return read("x [um],z [um]\n" + linesOf([&](int i) {
                  return fmt::format("{},{:.4f}", fmt::format(fmt::runtime(positions), step * i),
                                     micrometresAt(i));
                }));
  };
  EXPECT_TRUE(says(file("{:.0f}", 1.4), "few digits"));
  EXPECT_TRUE(says(file("{:.1f}", 0.37), "steps differ by up to"));
  EXPECT_FALSE(says(file("{:.1f}", 1.4), "few digits"));
  EXPECT_FALSE(says(file("{:.2f}", 0.377), "few digits"));
  EXPECT_TRUE(says(read("x [um],z [um]\n0,1\n1,2\n3,4\n4,1\n"), "few digits"));
}

TEST(RoadFiles, AreNamed) {
  const std::string rows =
      linesOf([](int i) { return fmt::format("{:.4f} 0.1", micrometresAt(i)); });
  EXPECT_THAT(errorOf("$CT\nComment\n$\n$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 0.01\n$$$$\n" + rows),
              HasSubstr("is a road file (OpenCRG)"));
  EXPECT_THAT(errorOf("ERDFILEV2.00\n 2, 60, -1, 1, 5, 0.25, -1,\nEND\n" + rows),
              HasSubstr("is a road file (ERD)"));
}

}  // namespace
}  // namespace asperity::written
