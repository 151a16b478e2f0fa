// Text tables whose parts belong together or apart: tables between blank lines, points that repeat
// or miss a grid, units and dates in the cells, and names of other quantities.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

/// The known heights as a matrix, with a number added to each; `unit` stands behind each number.
std::string matrix(double added = 0, const std::string& separator = ",",
                   const std::string& unit = "") {
  std::string text;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format("{:.6f}{}{}", micrometres(row, column) + added, unit,
                          column + 1 < kColumns ? separator : "\n");
  return text;
}

/// One row of the known heights, with its positions, as a profile in two columns.
std::string profile(int row, double step = 2) {
  std::string text;
  for (int column = 0; column < kColumns; ++column)
    text += fmt::format("{} {:.6f}\n", step * column, micrometres(row, column));
  return text;
}

/// A line for each point of the known surface: "x,y,z", in micrometres.
std::string points(const std::string& betweenRows = "", double offset = 0) {
  std::string text;
  for (int row = 0; row < kRows; ++row) {
    if (row > 0) text += betweenRows;
    for (int column = 0; column < kColumns; ++column) {
      const double away = offset * std::cos(2.1 * (row + 3 * column));
      text += fmt::format("{:.6f},{:.6f},{:.6f}\n", 2 * (column + away), 5 * (row - away),
                          micrometres(row, column));
    }
  }
  return text;
}

// ---- Blank lines -------------------------------------------------------------------------------

/// Two matrices were one of twice as many rows.
TEST(BlankLines, SeparateMatrices) {
  const std::string head = "X spacing: 2 um\nY spacing: 5 um\nZ unit: um\n";
  for (const std::string between : {"\n", "\n\n", "\n# intensity\n"})
    for (const double added : {0.0, 1000.0}) {
      if (added > 0 && between.find('#') == between.npos) continue;  // below
      const MeasuredFile file = read(head + matrix() + between + matrix(added));
      expectKnown(file, "matrix", false, 1e-11);
      EXPECT_TRUE(
          says(file, "Blank lines separate 2 tables; the first one, up to line 7, is read."));
    }
  // Without a comment, both may be one, unless the header or the user says so.
  const std::string both = matrix() + "\n" + matrix(1000);
  EXPECT_THAT(errorOf(head + both),
              HasSubstr("surface.format: is needed: blank lines separate 2 parts of 4 rows"));
  ReadingChoices one;
  one.format = "matrix";
  for (const MeasuredFile& file : {read(head + both, one), read(head + "Rows: 8\n" + both)}) {
    EXPECT_EQ(file.topography.rows, 2 * kRows);
    EXPECT_TRUE(says(file, "all rows are taken for one table."));
  }
  EXPECT_EQ(read(head + "Rows: 4\n" + both).topography.rows, kRows);
  // Blank lines between all rows, or between parts of other sizes, mean nothing.
  std::string spaced = matrix();
  for (std::size_t at = spaced.find('\n'); at != std::string::npos; at = spaced.find('\n', at + 2))
    spaced.insert(at, "\n");
  const MeasuredFile made = read(head + spaced);
  expectKnown(made, "matrix", false, 1e-11);
  EXPECT_FALSE(says(made, "Blank lines"));
  const MeasuredFile whole = read(head + matrix() + "\n" + matrix() + matrix());
  EXPECT_EQ(whole.topography.rows, 3 * kRows);
  EXPECT_TRUE(says(whole,
                   "Blank lines stand between the rows, the first one above line 9: all rows are "
                   "taken for one table."));
}

/// As gnuplot draws several curves from one file.
TEST(BlankLines, SeparateProfilesThatAreRows) {
  for (const std::string between : {"\n", "\n\n", "\n\n# next\n"}) {
    const MeasuredFile file = read("# x(um) z(um)\n" + profile(0) + between + profile(1) + between +
                                   profile(2) + between + profile(3));
    const Topography& grid = file.topography;
    ASSERT_EQ(grid.columns, kColumns);
    ASSERT_EQ(grid.rows, kRows);
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        EXPECT_NEAR(grid.at(row, column), height(row, column), 1e-12);
    EXPECT_NEAR(grid.columnSpacing, 2e-6, 1e-15);
    EXPECT_EQ(grid.rowSpacing, 0);
    EXPECT_TRUE(
        says(file, "points. Points are 2 \u00B5m apart; how far the rows are apart is not known."));
    EXPECT_TRUE(says(file, "The file has 4 profiles, which are the rows of the surface"));
  }
  // Profiles at other positions are no rows.
  const MeasuredFile first = read("x (um) z (um)\n" + profile(0) + "\n" + profile(1, 3));
  EXPECT_EQ(first.topography.rows, 1);
  EXPECT_EQ(first.topography.columns, kColumns);
  EXPECT_TRUE(says(first, "the first one, up to line 8, is read."));
  // Nor are those of other lengths.
  const MeasuredFile longer =
      read("x (um) z (um)\n" + profile(0) + "14 1\n\n" + profile(1) + "\n" + profile(2));
  EXPECT_EQ(longer.topography.rows, 1);
  EXPECT_EQ(longer.topography.columns, kColumns + 1);
  EXPECT_TRUE(says(longer, "Blank lines separate 3 tables; the first one, up to line 9, is read."));
  const MeasuredFile one = read("x (um) z (um)\n" + profile(0) + "\n14 1\n16 2\n18 1\n20 3\n");
  EXPECT_EQ(one.topography.columns, kColumns + 4);
  // A profile that goes on behind a blank line is one, also where that line is in its middle.
  const std::string more = "14 1 2\n16 2 1\n18 1 2\n20 3 1\n22 1 1\n24 2 1\n26 1 2\n";
  std::string columns = profile(0);
  for (std::size_t at = columns.find('\n'); at != std::string::npos;
       at = columns.find('\n', at + 5))
    columns.insert(at, " 0.5");
  EXPECT_EQ(read("x (um) z (um) z2 (um)\n" + columns + "\n" + more).topography.columns, 14);
  EXPECT_EQ(read("x (um) z (um)\n" + profile(0) + "\n14 1\n16 2\n18 1\n20 3\n22 1\n24 2\n26 1\n")
                .topography.columns,
            14);
}

/// The heights of a row, one below the other.
std::string list(int row) {
  std::string text;
  for (int column = 0; column < kColumns; ++column)
    text += fmt::format("{:.6f}\n", micrometres(row, column));
  return text;
}

/// A list below "Profile 2" was no number, and a position that begins anew went back.
TEST(Profiles, ThatFollowEachOtherAreRows) {
  const std::string step = "Step: 2 um\nUnit: um\n", names = "x (um) z (um)\n";
  for (const std::string& text : std::vector<std::string>{
           names + profile(0) + profile(1) + profile(2),
           "z (um) x (um)\n8 0\n7 2\n6 4\n8 6\n5 0\n4 2\n5 4\n6 6\n8 0\n7 2\n6 4\n8 6\n",
           step + "Profile 1\n" + list(0) + "Profile 2\n" + list(1) + "Profile 3\n" + list(2),
           step + "# Profile 1\n" + list(0) + "\n# Profile 2\n" + list(1) + "# Profile 3\n" +
               list(2),
           "Profil 1\n" + names + profile(0) + "Profil 2\n" + names + profile(1) + "\nProfil 3\n" +
               names + profile(2)}) {
    const MeasuredFile file = read(text);
    const Topography& grid = file.topography;
    ASSERT_EQ(grid.rows, 3) << text;
    EXPECT_NEAR(grid.columnSpacing, 2e-6, 1e-15);
    if (grid.columns == kColumns) {
      EXPECT_NEAR(grid.at(2, 4), height(2, 4), 1e-12) << text;
    } else {
      EXPECT_NEAR(grid.at(1, 3), 6e-6, 1e-15);
    }
    EXPECT_TRUE(says(file, "The file has 3 profiles, which are the rows of the surface")) << text;
    EXPECT_FALSE(says(file, "tables of numbers"));
  }
  // The user's spacing is that of the points.
  ReadingChoices spacing;
  spacing.spacing = 2e-6;
  const Topography spaced =
      read("z (um)\nProfile 1\n" + list(0) + "Profile 2\n" + list(1), spacing).topography;
  EXPECT_EQ(spaced.rows, 2);
  EXPECT_EQ(spaced.columnSpacing, 2e-6);
  EXPECT_EQ(spaced.rowSpacing, 0);
  // Positions that go back, or begin elsewhere, are an error as before.
  EXPECT_THAT(errorOf(names + profile(0) + profile(1, 3)), HasSubstr("goes back"));
  EXPECT_THAT(errorOf(names + profile(0) + "0 1\n2 1\n"), HasSubstr("goes back"));
  // A profile of another length is no row.
  const MeasuredFile longer =
      read(step + "Profile 1\n" + list(0) + "Profile 2\n" + list(1) + "1\n");
  EXPECT_EQ(longer.topography.rows, 1);
  EXPECT_TRUE(says(longer, "The file has 2 tables of numbers; the largest one"));
  EXPECT_THAT(errorOf(step + "Profile 1\n" + list(0) + "Force 2\n" + list(1)),
              HasSubstr("'Force' in column 1 is not a number"));
}

/// Several profiles of one measurement often stand side by side, with a number in their names.
TEST(Profiles, ThatStandSideBySideAreRows) {
  const auto table = [](const std::string& names, bool lacksLast = false) {
    std::string text = names + "\n";
    for (int column = 0; column < kColumns; ++column) {
      text += fmt::format("{}", 2 * column);
      for (int row = 0; row < kRows; ++row)
        text += lacksLast && row == 1 && column + 1 == kColumns
                    ? ","
                    : fmt::format(",{:.6f}", micrometres(row, column));
      text += "\n";
    }
    return text;
  };
  const auto named = [](const std::string& before, const std::string& after) {
    std::string names = "x (um)";
    for (int row = 0; row < kRows; ++row) names += fmt::format(",{}{}{}", before, row + 1, after);
    return names;
  };
  for (const auto& [before, after] : {std::pair("Profil ", " (um)"), std::pair("z", " (um)"),
                                      std::pair("Laser ", " left (um)")}) {
    const MeasuredFile file = read(table(named(before, after)));
    ASSERT_EQ(file.topography.rows, kRows) << before;
    ASSERT_EQ(file.topography.columns, kColumns) << before;
    EXPECT_EQ(file.topography.rowSpacing, 0);
    for (int row = 0; row < kRows; ++row)
      EXPECT_NEAR(file.topography.at(row, 3), 1e-6 * micrometres(row, 3), 1e-15) << before;
    EXPECT_TRUE(says(file, fmt::format("The file has {} profiles side by side, column 2", kRows)));
    EXPECT_FALSE(says(file, "columns that could be")) << before;
  }
  const std::string text = table(named("z", " (um)"));
  // The user may choose one, or a single profile.
  EXPECT_EQ(read(text, {.heightColumn = 3}).topography.rows, 1);
  EXPECT_EQ(read(text, {.format = "profile"}).topography.rows, 1);
  // Other quantities, names that do not count, and profiles of other lengths are no rows.
  EXPECT_EQ(read(table(named("Sensor ", "")), {.heightUnit = "um"}).topography.rows, 1);
  const std::string shorter = table(named("z", " (um)"), true);
  EXPECT_EQ(read(shorter).topography.rows, kRows - 1);
  EXPECT_TRUE(says(read(shorter), "column 3 'z2' is left out: a height is missing"));
  EXPECT_FALSE(says(read(text), "is left out"));
}

TEST(BlankLines, BetweenLinesOfPointsMeanNothing) {
  for (const std::string names : {"x (um),y (um),z (um)\n", ""})
    for (const double offset : {0.0, 0.01}) {
      const MeasuredFile file = read(names + points("\n", offset), kInMicrometres);
      EXPECT_EQ(file.topography.rows, kRows);
      EXPECT_EQ(file.topography.columns, kColumns);
      EXPECT_FALSE(says(file, "Blank lines"));
    }
  // Where the points are on no grid, no line of them is a table.
  EXPECT_FALSE(says(read(points("\n", 0.2), kInMicrometres), "the first one, up to line"));
}

// ---- Points ------------------------------------------------------------------------------------

/// A stage states where it stood, not where it should have stood.
TEST(PointsNearAGrid, AreTakenOnIt) {
  for (const std::string names : {"x (um),y (um),z (um)\n", ""}) {
    const MeasuredFile file = read(names + points("", 0.01), kInMicrometres);
    expectKnown(file, "points", false, 1e-11, 0.01);
    EXPECT_TRUE(says(file, "% of a step off an even grid, on which they are taken."));
  }
  EXPECT_THAT(errorOf("x (um),y (um),z (um)\n" + points("", 0.05)),
              HasSubstr("the points do not lie on a grid"));
  EXPECT_FALSE(says(read("x (um),y (um),z (um)\n" + points()), "off an even grid"));
}

/// It was taken for the last point of its row.
TEST(PointsFarFromAGrid, AreRefused) {
  std::string text = "x (um),y (um),z (um)\n";
  for (int i = 0; i < 11; ++i)
    text += fmt::format("{},{},{}\n", 2 * (i % 4), 2 * (i / 4), (5 * i) % 7);
  EXPECT_EQ(errorOf(text + "6,4,1\n"), "no error");
  EXPECT_THAT(errorOf(text + "1e300,4,1\n"), HasSubstr("the points do not lie on a grid"));
}

TEST(PointsAtOnePosition, HaveTheMeanOfTheirHeights) {
  const std::string text = "x (um),y (um),z (um)\n" + points();
  const MeasuredFile file =
      read(text + fmt::format("4,10,{}\n4,10,{}\n", micrometres(2, 2) + 3, micrometres(2, 2) - 3));
  expectKnown(file, "points", false, 1e-11);
  EXPECT_TRUE(says(file, "2 rows repeat a position: the mean of their heights is taken."));
  const MeasuredFile moved = read(text + fmt::format("4,10,{}\n", micrometres(2, 2) + 1));
  EXPECT_NEAR(moved.topography.at(2, 2), height(2, 2) + 0.5e-6, 1e-12);
  // Many of them may be another surface.
  EXPECT_THAT(errorOf(text + points()),
              HasSubstr("line 30: there is a point at this position already"));
}

// ---- Cells -------------------------------------------------------------------------------------

TEST(UnitsInCells, AreThoseOfTheNumbers) {
  for (const std::string separator : {",", ";", "\t", "  "}) {
    std::string text = "x" + separator + "z\n";
    for (int column = 0; column < kColumns; ++column)
      text +=
          fmt::format("{} um{}{:.3f} nm\n", 2.0 * column, separator, 1e3 * micrometres(0, column));
    expectKnown(read(text), "profile", false, 1e-12, 1e-9, 1);
  }
  std::string list = "Spacing: 2 um\n";
  for (int column = 0; column < kColumns; ++column)
    list += fmt::format("{:.6f} um\n", micrometres(0, column));
  expectKnown(read(list), "profile", false, 1e-12, 1e-9, 1);
  // A cell in another unit of length counts in that unit.
  const MeasuredFile mixed = read("x,z\n0 um,1 um\n1 um,2000 nm\n2 um,3 um\n3 um,1 um\n");
  EXPECT_NEAR(mixed.topography.at(0, 1), 2e-6, 1e-15);
  EXPECT_NE(errorOf("x,z\n0 um,1 um\n1 um,2\n2 um,3 um\n3 um,1 um\n"), "no error");
  const MeasuredFile grid =
      read("X spacing: 2 um\nY spacing: 5 um\nheights\n" + matrix(0, ",", " um"));
  expectKnown(grid, "matrix", false, 1e-11);
}

TEST(UnitsInCells, MayStandAtTheAxesOfAMatrix) {
  std::string text;
  for (int column = 0; column < kColumns; ++column) text += fmt::format(",{} um", 2.0 * column);
  for (int row = 0; row < kRows; ++row) {
    text += fmt::format("\n{} mm", 0.005 * row);
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format(",{:.6f}", micrometres(row, column));
  }
  expectKnown(read(text + "\n", {.heightUnit = "um"}), "matrix", false, 1e-11, 1e-9);
}

TEST(Dates, AreNoPositions) {
  for (const std::string date : {"2024-03-12 10:22:0{}", "12.03.2024 10:22:0{}", "10:22:0{}.500",
                                 "2024-03-1{}", "3/1{}/2024"})
    for (const std::string names :
         {"Timestamp,X (um),Z (um)\n", "when,x (um),z (um)\n", "# um\n"}) {
      std::string text = names;
      for (int column = 0; column < kColumns; ++column)
        text += fmt::format("{},{},{:.6f}\n", fmt::format(fmt::runtime(date), column), 2 * column,
                            micrometres(0, column));
      expectKnown(read(text, kInMicrometres), "profile", false, 1e-12, 1e-9, 1);
    }
  std::string times = "Time (s),Z (um)\n";
  for (int column = 0; column < kColumns; ++column)
    times += fmt::format("{},{:.6f}\n", 0.01 * column, micrometres(0, column));
  expectKnown(read(times, {.spacing = 2e-6}), "profile", false, 1e-12, 1e-9, 1);
  EXPECT_THAT(errorOf(times), HasSubstr("surface.point_spacing: is needed"));
}

// ---- Numbers of profiles -----------------------------------------------------------------------

/// The rows of the known heights, each with its number, in this order of the columns.
std::string numbered(const std::string& names, const std::vector<int>& rows) {
  std::string text = names + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format("{};{};{:.6f}\n", i + 1, 2 * column, micrometres(rows[i], column));
  return text;
}

TEST(NumbersOfProfiles, AreNoHeightsAndNoPositions) {
  std::vector<int> all;
  for (int row = 0; row < kRows; ++row) all.push_back(row);
  for (const std::string name : {"Profile", "Profil Nr.", "Track", "Scan", "Line no."}) {
    const std::string names = name + ";x (um);z (um)";
    const MeasuredFile one = read(numbered(names, {0}));
    EXPECT_TRUE(one.topography.isProfile()) << name;
    EXPECT_NEAR(one.topography.at(0, 3), 1e-6 * micrometres(0, 3), 1e-12) << name;
    const MeasuredFile several = read(numbered(names, all));
    ASSERT_EQ(several.topography.rows, kRows) << name;
    EXPECT_NEAR(several.topography.columnSpacing, kColumnSpacing, 1e-15);
    EXPECT_NEAR(several.topography.at(2, 3), 1e-6 * micrometres(2, 3), 1e-12) << name;
    EXPECT_TRUE(says(several, "profiles, which are the rows of the surface")) << name;
  }
  // A profile with a number for each point.
  std::string points = "Profile;x (um);z (um)\n";
  for (int column = 0; column < kColumns; ++column)
    points += fmt::format("{};{};{:.6f}\n", column + 1, 2 * column, micrometres(0, column));
  EXPECT_NEAR(read(points).topography.at(0, 3), 1e-6 * micrometres(0, 3), 1e-12);
}

// ---- Other quantities --------------------------------------------------------------------------

TEST(OtherQuantities, AreNoHeights) {
  const std::string head = "Spacing: 2 um\nUnit: um\n";
  for (const std::string name :
       {"Intensity", "Intensity (a.u.)", "Channel: Amplitude", "[Phase]", "Phase image"}) {
    EXPECT_THAT(
        errorOf(head + name + "\n" + matrix()),
        HasSubstr("surface.height_unit: is needed (m, mm, \u00B5m, nm, in, mil): the numbers "
                  "are named '"))
        << name;
    EXPECT_TRUE(says(read(head + name + "\n" + matrix(), {.heightUnit = "um"}),
                     "which are no heights: they are taken as such all the same."))
        << name;
  }
  for (const std::string name : {"Height", "Amplitude (um)", "Optical profiler", "Intensity 50 %"})
    EXPECT_EQ(errorOf(head + name + "\n" + matrix()), "no error") << name;
  std::string columns = "Unit: um\nx (um) Intensity\n" + profile(0);
  EXPECT_THAT(errorOf(columns), HasSubstr("the numbers are named 'Intensity'"));
  EXPECT_EQ(errorOf(replaced(columns, "Intensity", "Amplitude")), "no error");
}

}  // namespace
}  // namespace asperity::written
