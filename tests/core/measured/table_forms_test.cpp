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

bool tells(const MeasuredFile& file, const std::string& part) {
  return std::ranges::any_of(file.facts.notes, [&part](const Message& note) {
    return note.english().find(part) != std::string::npos;
  });
}

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
  EXPECT_TRUE(tells(file,
                    "Columns of the grid are numbered by column 2 'j', rows by column 1 'i'; "
                    "heights are column 3 'z'."));
  // The user may say that the numbers are lengths.
  const MeasuredFile inMillimetres = read(text, {.positionUnit = "mm"});
  EXPECT_EQ(inMillimetres.facts.format, "points");
  EXPECT_NEAR(inMillimetres.topography.columnSpacing, 1e-3, 1e-12);
  EXPECT_NEAR(inMillimetres.topography.rowSpacing, 1e-3, 1e-12);
}

/// Points without a height may be left out where the names leave no doubt; a point must not occur
/// twice.
TEST(GridNumbers, MayLackPointsAndAreUnique) {
  std::string text = "row,col,z (um)\n" + pointLines([](int row, int column) {
                       return isGap(row, column) ? std::string()
                                                 : fmt::format("{},{},{}\n", row, column,
                                                               micrometres(row, column));
                     });
  MeasuredFile file = read(text, {.spacing = 2e-6});
  file.topography.rowSpacing = kRowSpacing;
  expectKnown(file, "points", true, 1e-13);
  EXPECT_THAT(errorOf(text + "0,0,1\n", {.spacing = 2e-6}),
              HasSubstr("there is a point at this position already"));
}

}  // namespace
}  // namespace asperity::written
