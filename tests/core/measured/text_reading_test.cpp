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

// ---- Missing values of several words ------------------------------------------------------------

TEST(MissingWords, AreGapsWhereBlanksSeparateTheNumbers) {
  for (const std::string words :
       {"No Data", "no value", "missing value", "Not measured", "out of range", "no signal",
        "Kein Wert", "nicht  gemessen", "invalid data", "bad point"}) {
    const auto orGap = [&words](int i, int last) {
      return i % 10 == last ? words : fmt::format("{:.4f}", micrometresAt(i));
    };
    const MeasuredFile profile = read(
        "X_um Z_um\n" + linesOf([&](int i) { return fmt::format("{} {}", 2 * i, orGap(i, 3)); }));
    EXPECT_EQ(profile.topography.columns, kRowCount) << words;
    EXPECT_EQ(profile.facts.gaps, kRowCount / 10) << words;
    EXPECT_NEAR(profile.topography.at(0, 4), 1e-6 * micrometresAt(4), 1e-10) << words;
    // In most rows of a matrix, also in its first one.
    const MeasuredFile matrix =
        read("# Width: 12 um\n# Height: 60 um\n# Value units: um\n" + linesOf([&](int i) {
               std::string row;
               for (int j = 0; j < 12; ++j) row += (j > 0 ? " " : "") + orGap(7 * i + j, 3 * i % 8);
               return row;
             }));
    EXPECT_EQ(matrix.topography.columns, 12) << words;
    EXPECT_EQ(matrix.topography.rows, kRowCount) << words;
    EXPECT_GE(matrix.facts.gaps, kRowCount) << words;
    EXPECT_FALSE(says(matrix, "tables of numbers")) << words;
    const MeasuredFile points = read("X (um) Y (um) Z (um)\n" + linesOf([&](int i) {
                                       return fmt::format("{} {} {}", i % 10, i / 10, orGap(i, 3));
                                     }));
    EXPECT_EQ(points.facts.points, kRowCount) << words;
    EXPECT_EQ(points.facts.gaps, kRowCount / 10) << words;
  }
}

TEST(MissingWords, AboveTheNumbersAreNoRow) {
  const MeasuredFile file = read("X_um Z_um\nMissing data 12\n" + linesOf([](int i) {
                                   return fmt::format("{} {:.4f}", 2 * i, micrometresAt(i));
                                 }));
  EXPECT_EQ(file.topography.columns, kRowCount);
  EXPECT_EQ(file.facts.gaps, 0);
  EXPECT_FALSE(says(file, "left out"));
}

/// Words that are not known leave no part of a table out.
TEST(MissingWords, ThatAreNotKnownAreRefused) {
  for (const std::string words : {"no echo", "bad echo", "laser dropout", "no echo here"}) {
    const auto orWords = [&words](int i, int period) {
      return i % period == 0 ? words : fmt::format("{:.4f}", micrometresAt(i));
    };
    for (const int period : {2, 7}) {
      const std::string profile =
          errorOf("X_um Z_um\n0 1\n" + linesOf([&](int i) {
                    return fmt::format("{} {}", i + 1, orWords(i + 1, period));
                  }));
      EXPECT_THAT(profile, HasSubstr("' in column 2 is not a number")) << words << period;
    }
    // Few rows of a matrix are whole.
    std::string matrix = "# Width: 6 um\n# Height: 60 um\n# Value units: um\n";
    matrix += linesOf([&](int i) {
      std::string row;
      for (int j = 0; j < 6; ++j)
        row += fmt::format("{}{}", j > 0 ? " " : "", orWords(6 * i + j + 1, i % 5 < 2 ? 999 : 4));
      return row;
    });
    EXPECT_THAT(errorOf(matrix), HasSubstr("line 6: '" + words.substr(0, 2))) << words;
  }
}

TEST(Statements, AreNoNamesOfTheOnlyColumn) {
  const std::string rows =
      linesOf([](int i) { return fmt::format("{:.7f}", 1e-3 * micrometresAt(i)); });
  for (const std::string line : {"Speed 0.25 mm/s", "Range 12.5 um", "Load 1 mN"})
    expectSpacing(read("Spacing: 0.5 um\nZ unit: mm\n" + line + "\n\n" + rows), 0.5e-6);
}

// ---- Lines in columns ---------------------------------------------------------------------------

TEST(LinesInColumns, HaveTheirOwnSpacing) {
  const std::string rows = linesOf([](int i) {
    std::string row;
    for (int line = 0; line < 5; ++line)
      row += fmt::format("{}{:.3f}", line > 0 ? "," : "", 0.1 * micrometresAt(i + 11 * line));
    return row;
  });
  const auto expectLines = [](const MeasuredFile& file, double along, double between, double unit) {
    ASSERT_EQ(file.topography.columns, kRowCount);
    ASSERT_EQ(file.topography.rows, 5);
    EXPECT_NEAR(file.topography.columnSpacing, along, 1e-12);
    EXPECT_NEAR(file.topography.rowSpacing, between, 1e-12);
    EXPECT_NEAR(file.topography.at(3, 7), 0.1 * micrometresAt(7 + 33) * unit, 1e-3 * unit);
    EXPECT_TRUE(says(file, "The 5 columns are taken for the lines"));
  };
  const std::string spacings =
      "Scan line spacing (mm),1.0\nSample spacing (mm),0.5\nElevation (mm)\n";
  expectLines(read(spacings + rows), 0.5e-3, 1e-3, 1e-3);
  expectLines(read("Sample spacing (in),0.01\nNumber of lines,5\nElevation units: mils\n\n" + rows),
              0.254e-3, 0, 25.4e-6);
  const MeasuredFile matrix = read(spacings + rows, {.format = "matrix"});
  EXPECT_EQ(matrix.topography.columns, 5);
  EXPECT_NEAR(matrix.topography.columnSpacing, 0.5e-3, 1e-12);
  EXPECT_NEAR(matrix.topography.rowSpacing, 1e-3, 1e-12);
}

TEST(Mils, AreAUnitOfHeights) {
  const std::string rows = linesOf([](int i) { return fmt::format("{:.4f}", micrometresAt(i)); });
  const MeasuredFile chosen = read("Spacing: 0.5 mm\n" + rows, {.heightUnit = "mil"});
  EXPECT_NEAR(chosen.topography.at(0, 4), 25.4e-6 * micrometresAt(4), 1e-8);
  for (const std::string unit : {"mil", "mils", "thou"})
    EXPECT_NEAR(read("Spacing: 0.5 mm\nElevation units: " + unit + "\n" + rows).topography.at(0, 4),
                25.4e-6 * micrometresAt(4), 1e-8)
        << unit;
}

}  // namespace
}  // namespace asperity::written
