// Tables of heights that can be taken for another form: numbers of rows and columns beside the
// heights, axes around them, counts above them, and tables of other quantities in the same file.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

/// Expects the known surface with the same step along both axes.
void expectSquareGrid(MeasuredFile file, const std::string& format, double step) {
  EXPECT_NEAR(file.topography.columnSpacing, step, 1e-9 * step);
  EXPECT_NEAR(file.topography.rowSpacing, step, 1e-9 * step);
  file.topography.columnSpacing = kColumnSpacing;
  file.topography.rowSpacing = kRowSpacing;
  expectKnown(file, format, false, 1e-13);
}

// ---- Numbers of rows and columns ---------------------------------------------------------------

/// A line for each point of the known surface, the points of a row or of a column one after
/// another.
template <class Line>
std::string pointLines(const Line& line, bool rowByRow = true) {
  std::string text;
  for (int i = 0; i < kColumns * kRows; ++i)
    text += rowByRow ? line(i / kColumns, i % kColumns) : line(i % kRows, i / kRows);
  return text;
}

TEST(GridNumbers, AreNoProfile) {
  for (const bool rowByRow : {true, false})
    for (const int first : {0, 1}) {
      const auto rowFirst = pointLines(
          [first](int row, int column) {
            return fmt::format("{},{},{}\n", row + first, column + first, micrometres(row, column));
          },
          rowByRow);
      const auto columnFirst = pointLines(
          [first](int row, int column) {
            return fmt::format("{};{};{}\n", column + first, row + first, micrometres(row, column));
          },
          rowByRow);
      for (const char* names : {"row,col,z (um)", "Line,Column,Height (um)", "pixel_y,pixel_x,z_um",
                                "Y (px),X (px),Z (um)"}) {
        SCOPED_TRACE(names);
        const std::string text = std::string(names) + "\n" + rowFirst;
        expectSquareGrid(read(text, {.spacing = 3e-6}), "points", 3e-6);
        expectSquareGrid(read("Point spacing: 4 um\n" + text), "points", 4e-6);
        EXPECT_THAT(errorOf(text), HasSubstr("surface.point_spacing: is needed"));
      }
      for (const char* names :
           {"Spalte;Zeile;H\u00F6he [\u00B5m]", "col;row;z (um)", "ix;iy;height (um)"}) {
        SCOPED_TRACE(names);
        const std::string text = std::string(names) + "\n" + columnFirst;
        expectSquareGrid(read(text, {.spacing = 3e-6}), "points", 3e-6);
        EXPECT_THAT(errorOf(text), HasSubstr("surface.point_spacing: is needed"));
      }
      // Without names they are numbers where the step is known.
      expectSquareGrid(read("Point spacing: 4 um\nZ unit: um\n\n" + columnFirst), "points", 4e-6);
    }
}

/// Of two names that say nothing, the one whose numbers run faster is along the rows.
TEST(GridNumbers, MayHaveAnyName) {
  const std::string rows = pointLines([](int row, int column) {
    return fmt::format("{},{},{},7\n", row, column, micrometres(row, column));
  });
  const std::string text = "i,j,z (um),gain\n" + rows;
  const MeasuredFile file = read(text, {.spacing = 3e-6});
  expectSquareGrid(file, "points", 3e-6);
  EXPECT_TRUE(says(file,
                   "Columns of the grid are numbered by column 2 'j', rows by column 1 'i'; "
                   "heights are column 3 'z'."));
  // The user may say that the numbers are lengths.
  const MeasuredFile inMillimetres = read(text, {.positionUnit = "mm"});
  EXPECT_EQ(inMillimetres.facts.format, "points");
  EXPECT_NEAR(inMillimetres.topography.columnSpacing, 1e-3, 1e-12);
  EXPECT_NEAR(inMillimetres.topography.rowSpacing, 1e-3, 1e-12);
}

/// Points without a height may be left out where the names leave no doubt; many points must not
/// occur twice.
TEST(GridNumbers, MayLackPointsAndAreUnique) {
  std::string text = "row,col,z (um)\n" + pointLines([](int row, int column) {
                       return isGap(row, column) ? std::string()
                                                 : fmt::format("{},{},{}\n", row, column,
                                                               micrometres(row, column));
                     });
  MeasuredFile file = read(text, {.spacing = 2e-6});
  file.topography.rowSpacing = kRowSpacing;
  expectKnown(file, "points", true, 1e-13);
  EXPECT_THAT(errorOf(text + "0,0,1\n0,1,1\n0,2,1\n0,3,1\n", {.spacing = 2e-6}),
              HasSubstr("line 29: there is a point at this position already"));
  // A whole row may be missing; numbers in steps of two are no grid of this spacing.
  const auto withRows = [](const std::vector<int>& numbers) {
    std::string points = "row,col,z (um)\n";
    for (const int row : numbers)
      for (int column = 0; column < kColumns; ++column)
        points += fmt::format("{},{},{}\n", row, column, micrometres(row, column));
    return points;
  };
  const MeasuredFile without = read(withRows({0, 1, 3, 4}), {.spacing = 2e-6});
  EXPECT_EQ(without.topography.rows, 5);
  EXPECT_EQ(without.facts.gaps, kColumns);
  EXPECT_THAT(errorOf(withRows({0, 2, 4, 6}), {.spacing = 2e-6}),
              HasSubstr("the points do not lie on a grid"));
}

TEST(GridNumbers, MayHaveHeightsThatRiseAllAlong) {
  const std::string text = "line,sample,z (um)\n" + pointLines([](int row, int column) {
                             return fmt::format("{},{},{}\n", row, column, kColumns * row + column);
                           });
  const MeasuredFile file = read(text, {.spacing = 2e-6});
  EXPECT_EQ(file.topography.columns, kColumns);
  ASSERT_EQ(file.topography.rows, kRows);
  EXPECT_NEAR(file.topography.at(1, 2), 1e-6 * (kColumns + 2), 1e-12);
}

/// A column that counts the lines numbers no rows of a grid; "Line 1" is the name of a profile.
TEST(GridNumbers, AreNoColumnsOfOtherKinds) {
  std::string counted, other;
  for (int i = 0; i < 30; ++i) {
    counted += fmt::format("{},{},{}\n", i, i * i % 7, i * i % 5);
    other += fmt::format("{},{},{}.5\n", 3 * i % 7, i * i % 5, i * i % 11);
  }
  for (const std::string& text :
       {"Row,Column,z\n" + counted, "Line,Height,Col\n" + counted, "Line 1,Column 2,z\n" + other}) {
    SCOPED_TRACE(text.substr(0, text.find('\n')));
    const MeasuredFile file = read(text, {.heightUnit = "nm", .spacing = 2e-6});
    EXPECT_EQ(file.facts.format, "profile");
    EXPECT_EQ(file.topography.columns, 30);
  }
}

// ---- A count above a list ----------------------------------------------------------------------

TEST(Count, AboveAListIsNoHeight) {
  std::string list;
  for (int i = 0; i < 40; ++i) list += fmt::format("{:.4f}\n", std::sin(0.3 * i));
  const ReadingChoices choices{.heightUnit = "um", .spacing = 2e-6};
  for (const char* head : {"40\n", "z (um)\n40\n", "40.0\n"}) {
    const MeasuredFile file = read(head + list, choices);
    ASSERT_EQ(file.topography.columns, 40);
    EXPECT_NEAR(file.topography.at(0, 1), 1e-6 * std::sin(0.3), 1e-10);
    EXPECT_TRUE(says(file, "is left out: it is the number of the heights below it."));
  }
  EXPECT_EQ(read("39\n" + list, choices).topography.columns, 41);
}

// ---- Axes around a matrix ----------------------------------------------------------------------

/// The known surface, or a plane, with axes; no text: without this axis.
std::string withAxes(const std::string& corner, int columns, int rows, bool hasRow, bool hasColumn,
                     double first = 0, bool isPlane = false) {
  std::string text = hasRow ? corner : "";
  for (int column = 0; hasRow && column < columns; ++column)
    text += (column > 0 || hasColumn ? "," : "") + fmt::format("{:.3f}", first + 2.0 * column);
  text += hasRow ? "\n" : "";
  for (int row = 0; row < rows; ++row) {
    if (hasColumn) text += fmt::format("{:.3f},", first + 5.0 * row);
    for (int column = 0; column < columns; ++column)
      text += (column > 0 ? "," : "") +
              fmt::format("{:.6f}", isPlane ? 0.7 * column - 0.3 * row : micrometres(row, column));
    text += "\n";
  }
  return text;
}

TEST(Axes, AreNoHeightsWhateverIsInTheCorner) {
  for (const char* corner : {"0", "0.000", "7", "-1.5", "9999"})
    for (const double first : {0.0, 12.5, -3.0}) {
      SCOPED_TRACE(corner);
      constexpr int kWidth = 9, kLength = 6;
      const std::string text = withAxes(corner, kWidth, kLength, true, true, first);
      const MeasuredFile file = read(text, kInMicrometres);
      const Topography& grid = file.topography;
      ASSERT_EQ(grid.columns, kWidth);
      ASSERT_EQ(grid.rows, kLength);
      EXPECT_NEAR(grid.columnSpacing, 2e-6, 1e-15);
      EXPECT_NEAR(grid.rowSpacing, 5e-6, 1e-15);
      for (int i = 0; i < kWidth * kLength; ++i)
        EXPECT_NEAR(grid.at(i / kWidth, i % kWidth), height(i / kWidth, i % kWidth), 1e-13) << i;
      EXPECT_TRUE(says(file, "are evenly spaced and are taken as positions; the number "));
      EXPECT_THAT(errorOf(text, {.heightUnit = "um"}),
                  HasSubstr("surface.position_unit: is needed"));
    }
}

TEST(Axes, OnOneSideAloneAreAskedFor) {
  ReadingChoices choices{.heightUnit = "um", .spacing = 2e-6};
  for (const double first : {0.0, 12.5}) {
    const std::string row = withAxes("", 10, 12, true, false, first);
    EXPECT_THAT(errorOf(row, choices), HasSubstr("surface.format: is needed: the first row is "
                                                 "evenly spaced and may hold positions"));
    const std::string column = withAxes("", 14, 12, false, true, first);
    EXPECT_THAT(errorOf(column, choices), HasSubstr("surface.format: is needed: the first column "
                                                    "is evenly spaced and may hold positions"));
    ReadingChoices asMatrix = choices;
    asMatrix.format = "matrix";
    EXPECT_EQ(read(row, asMatrix).topography.rows, 13);
    EXPECT_EQ(read(column, asMatrix).topography.columns, 15);
  }
}

/// All rows and columns of a plane are evenly spaced: they are heights.
TEST(Axes, AreNoRowsOfAPlane) {
  const MeasuredFile file =
      read(withAxes("", 14, 12, false, false, 0, true), {.heightUnit = "um", .spacing = 2e-6});
  EXPECT_EQ(file.topography.columns, 14);
  EXPECT_EQ(file.topography.rows, 12);
}

// ---- Grids of ESRI -----------------------------------------------------------------------------

std::string esriHeader(int columns, int rows, const std::string& step = "2") {
  return fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize {}\n", columns, rows,
                     step);
}

/// The heights of the first rows, so many of them in a line.
std::string esriHeights(std::size_t perLine, int rows = kRows, char decimal = '.') {
  std::string text;
  for (int i = 0; i < kColumns * rows; ++i) {
    std::string number = fmt::format("{:.4f}", micrometres(i / kColumns, i % kColumns));
    std::ranges::replace(number, '.', decimal);
    text += number + ((static_cast<std::size_t>(i) + 1) % perLine == 0 ? "\n" : " ");
  }
  return text;
}

TEST(EsriGrids, HaveTheRowsThatTheirHeaderStates) {
  for (const std::size_t perLine : {7u, 1u, 3u, 5u, 14u, 28u}) {
    SCOPED_TRACE(perLine);
    expectSquareGrid(read(esriHeader(kColumns, kRows) + esriHeights(perLine), kInMicrometres),
                     "matrix", 2e-6);
  }
  const std::string text = "NROWS\t4\r\nNCOLS\t7\r\nCELLSIZE\t2\r\n" + esriHeights(5);
  expectSquareGrid(read(text, kInMicrometres), "matrix", 2e-6);
  expectCutOffIsNoHarm(text, kInMicrometres);
}

TEST(EsriGrids, MayHaveADecimalComma) {
  for (const char* step : {"2,0", "2,5", "2"})
    expectSquareGrid(
        read(esriHeader(kColumns, kRows, step) + esriHeights(7, kRows, ','), kInMicrometres),
        "matrix", std::string_view(step) == "2,5" ? 2.5e-6 : 2e-6);
}

TEST(EsriGrids, MustNotContradictTheirHeader) {
  const auto error = [](const std::string& text) { return errorOf(text, kInMicrometres); };
  EXPECT_THAT(error(esriHeader(kColumns, kRows) + esriHeights(7, 3)),
              HasSubstr("line 8: ends after 21 of 28 heights"));
  EXPECT_THAT(error(esriHeader(6, kRows) + esriHeights(7)),
              HasSubstr("line 9: has more than the 24 heights that the header says"));
  EXPECT_THAT(error(esriHeader(kRows, kColumns) + "1 2 3 4 5 6 7\n" + esriHeights(7, 3)),
              HasSubstr("the header says 4 x 7 pixels; the file has 7 x 4 numbers"));
  EXPECT_THAT(error("ncols 7\nnrows 2.5\ncellsize 2\n" + esriHeights(7)),
              HasSubstr("nrows in the header is not a number above 0"));
  EXPECT_THAT(error(esriHeader(kColumns, kRows) + "1 2 x 4\n" + esriHeights(7)),
              HasSubstr("line 6: height 3 is not a number"));
}

// ---- Several tables ----------------------------------------------------------------------------

/// The known heights, or an intensity in their place.
std::string tableOf(bool areHeights, int times = 1) {
  std::string text;
  for (int row = 0; row < times * kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      text += (areHeights ? fmt::format("{:.6f}", micrometres(row, column))
                          : fmt::format("{}", (17 * row + 5 * column * column) % 101)) +
              (column + 1 < kColumns ? "," : "\n");
  return text;
}

TEST(SeveralTables, AreChosenByTheirNames) {
  const std::string head = "Spacing: 2 um\nUnit: um\n";
  for (const char* other :
       {"Intensity", "\"Light\"", "Laser", "Optical image", "Channel: Light", "Intensit\u00E4t"})
    for (const char* name : {"Height", "\"Height\"", "Z", "[Height]", "Height,um", "Image: Height",
                             "Height (um)", "H\u00F6he"}) {
      SCOPED_TRACE(std::string(other) + " " + name);
      const std::string heights = std::string(name) + "\n" + tableOf(true);
      for (const int times : {1, 2}) {
        const std::string light = std::string(other) + "\n" + tableOf(false, times);
        for (const std::string& text : {head + light + heights, head + heights + light}) {
          const MeasuredFile file = read(text);
          expectSquareGrid(file, "matrix", 2e-6);
          EXPECT_TRUE(says(file, "The file has 2 tables of numbers; that of heights, from line "));
        }
      }
    }
}

/// Some programs repeat the names of the columns on each page.
TEST(SeveralTables, ThatGoOnAlongXAreOneProfile) {
  const auto page = [](int from, int to, double step) {
    std::string text = fmt::format("Page {}\nx (um),z (um)\n", from);
    for (int i = from; i < to; ++i) text += fmt::format("{},{}\n", step * i, i * i % 7);
    return text;
  };
  for (const double step : {0.5, -0.5}) {
    const MeasuredFile file = read(page(0, 20, step) + page(20, 40, step) + page(40, 45, step));
    ASSERT_EQ(file.topography.columns, 45);
    EXPECT_NEAR(file.topography.columnSpacing, 0.5e-6, 1e-15);
    EXPECT_NEAR(file.topography.height[step > 0 ? 44 : 0], 44 * 44 % 7 * 1e-6, 1e-15);
    EXPECT_TRUE(
        says(file, "3 tables of the file follow each other along x: they are read as one."));
  }
  // A gap between them, or another step, makes them others.
  EXPECT_EQ(read(page(0, 20, 0.5) + page(25, 40, 0.5)).topography.columns, 20);
  EXPECT_EQ(read(page(0, 20, 0.5) + page(10, 25, 1)).topography.columns, 20);
}

/// Long waves decide where the load is carried, and a filter takes them out.
TEST(SeveralColumns, OfOneProfileGiveThePrimaryProfile) {
  for (const char* names : {"R (um),W (um),P (um)", "R-Profil (um),W-Profil (um),P-Profil (um)",
                            "Rauheitsprofil (um),Welligkeit (um),Prim\u00E4rprofil (um)",
                            "Filtered profile (um),Waviness (um),Raw profile (um)"}) {
    std::string text = "x (um)," + std::string(names) + "\n";
    for (int i = 0; i < 20; ++i)
      text += fmt::format("{},{},{},{}\n", 0.5 * i, i % 2, i % 3, 3 + i % 5);
    const MeasuredFile file = read(text);
    EXPECT_NEAR(file.topography.height[4], 7e-6, 1e-15) << names;
    EXPECT_TRUE(says(file, "one of 3 columns that could be")) << names;
  }
}

TEST(SeveralColumns, OfOneHeightAloneGiveWayToOthers) {
  std::string text = "X-Pos (um);Z-Pos (mm);Z (um)\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{};10.0;{}\n", 0.5 * i, i % 5);
  EXPECT_NEAR(read(text).topography.height[4], 4e-6, 1e-15);
}

/// A position in counts of an encoder is none beside one in a unit of length.
TEST(SeveralColumns, OfPositionsGiveTheOneInAUnitOfLength) {
  std::string text = "Encoder (counts),Distance (um),Z (um)\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{},{},{}\n", 40 * i, 0.5 * i, i % 5);
  const MeasuredFile file = read(text);
  EXPECT_NEAR(file.topography.columnSpacing, 5e-7, 1e-15);
  EXPECT_NEAR(file.topography.height[4], 4e-6, 1e-15);
}

TEST(SeveralTables, OfOneSizeWithoutANameAreTold) {
  const std::string head = "Spacing: 2 um\nZ unit: um\nz: um\n";
  const MeasuredFile file = read(head + "A\n" + tableOf(true) + "B\n" + tableOf(false));
  expectSquareGrid(file, "matrix", 2e-6);
  EXPECT_TRUE(says(file,
                   "The file has 2 tables of numbers; the first of 2 equally large ones, from "
                   "line 5 on, is read."));
  // What is no height gives way to a table without a name.
  expectSquareGrid(read(head + "Light\n" + tableOf(false) + "B\n" + tableOf(true)), "matrix", 2e-6);
  // A small table beside a large one does not count.
  const MeasuredFile large = read(head + "Height\n1,2,3\n4,5,7\nData\n" + tableOf(true));
  expectSquareGrid(large, "matrix", 2e-6);
  EXPECT_TRUE(says(large, "the largest one, from line 8 on, is read."));
}

}  // namespace
}  // namespace asperity::written
