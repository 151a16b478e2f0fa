// The lengths and the numbers of points that the lines above the numbers of a text state.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

constexpr int kRowsOfField = 9, kPointsOfRow = 12;

double heightAt(int row, int column) {
  return std::sin(0.7 * column + 0.4 * row) + 0.1 * std::cos(1.9 * column * row);
}

/// A field of heights in micrometres; `between` separates the points of a row.
std::string field(const std::string& between = "\t") {
  std::string text;
  for (int row = 0; row < kRowsOfField; ++row)
    for (int column = 0; column < kPointsOfRow; ++column)
      text += fmt::format("{:.4f}", heightAt(row, column)) +
              (column + 1 < kPointsOfRow ? between : "\n");
  return text;
}

/// A list of 400 heights in micrometres.
std::string list() {
  std::string text = "z (um)\n";
  for (int i = 0; i < 400; ++i) text += fmt::format("{:.4f}\n", std::sin(0.31 * i) + 0.001 * i);
  return text;
}

void expectSpacings(const std::string& header, double x, double y) {
  const Topography& grid = read(header + field()).topography;
  EXPECT_NEAR(grid.columnSpacing, x, 1e-9 * x) << header;
  EXPECT_NEAR(grid.rowSpacing, y, 1e-9 * y) << header;
}

TEST(AxesOfAHeader, HaveTheirOwnLengths) {
  for (const std::string form : {"{}-axis:", "{}-Achse", "Axe {}", "[{} axis]"}) {
    const auto named = [&form](const char* axis) {
      std::string line = form;
      return line.replace(line.find("{}"), 2, axis) + "\n";
    };
    expectSpacings(named("X") + "Spacing: 2.0 \u00B5m\n" + named("Y") + "Spacing: 3.0 \u00B5m\n" +
                       named("Z") + "Spacing: 7 nm\nUnit: \u00B5m\n",
                   2e-6, 3e-6);
    expectSpacings(named("X") + "Length:\t24\t\u00B5m\nSize:\t12\tdigits\n" + named("Y") +
                       "Length:\t27\t\u00B5m\nSize:\t9\n" + named("Z") + "Unit: \u00B5m\n",
                   2e-6, 3e-6);
  }
}

TEST(AxesOfAHeader, LineSpacingIsThatOfTheRows) {
  expectSpacings("Line spacing: 2 um\nPoint spacing: 0.5 um\nHeight in um\n", 0.5e-6, 2e-6);
}

TEST(PointDistances, FollowFromALengthWithItsSymbol) {
  EXPECT_NEAR(read("Taststrecke lt = 199.5 um\nPunkte = 400\n" + list()).topography.columnSpacing,
              0.5e-6, 1e-15);
}

TEST(PointDistances, MayBeInAbbreviatedInches) {
  const Topography grid =
      read("x (in.),z (in.)\n0,0.001\n0.1,0.002\n0.2,0.001\n0.3,0.003\n").topography;
  EXPECT_NEAR(grid.columnSpacing, 2.54e-3, 1e-12);
  EXPECT_NEAR(grid.height[1], 5.08e-5, 1e-15);
}

/// What counts into the material has the other sign than a height.
TEST(Depths, AreAskedForInManyLanguages) {
  for (const char* name :
       {"Profiltiefe", "Profondeur", "\u0413\u043B\u0443\u0431\u0438\u043D\u0430"})
    EXPECT_THAT(errorOf(std::string("x (mm);") + name + " (um)\n0;1\n1;2\n2;1\n3;3\n"),
                HasSubstr("may count into the material"))
        << name;
}

/// Heights in one column are rows where the header says how many.
TEST(AxesOfAHeader, CountsMakeRowsOfAColumn) {
  const Topography grid =
      read("nx 12\nny 9\ndx 0.5 um\ndy 2 um\nz_unit = um\n" + field("\n")).topography;
  EXPECT_EQ(grid.columns, kPointsOfRow);
  EXPECT_EQ(grid.rows, kRowsOfField);
  EXPECT_NEAR(grid.rowSpacing, 2e-6, 1e-15);
  EXPECT_NEAR(grid.at(2, 3), heightAt(2, 3) * 1e-6, 1e-10);
}

/// A length of x alone says nothing about the rows; one without an axis is taken for both, and that
/// is said.
TEST(AxesOfAHeader, MayBeOneOfBothOrNone) {
  const std::string said = "rows are taken to be as far apart as points";
  const auto rowSpacing = [&](const std::string& line, bool isSaid) {
    const MeasuredFile file = read(line + "\nZ unit: um\n" + field());
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-15) << line;
    EXPECT_EQ(says(file, said), isSaid) << line;
    return file.topography.rowSpacing;
  };
  for (const char* line : {"dx: 2 um", "X spacing: 2 um", "Width: 24 um"})
    EXPECT_EQ(rowSpacing(line, false), 0) << line;
  EXPECT_NEAR(rowSpacing("Spacing: 2 um", true), 2e-6, 1e-15);
  EXPECT_NEAR(rowSpacing("XY calibration: 2 um", false), 2e-6, 1e-15);
  EXPECT_FALSE(says(read("Spacing: 2 um\nZ unit: um\n1 2 3 2 1 4 3 2 1\n"), said));
  const MeasuredFile ofRows = read("dy: 2 um\nZ unit: um\n" + field());
  EXPECT_NEAR(ofRows.topography.columnSpacing, 2e-6, 1e-15);
  EXPECT_TRUE(says(ofRows, "along y alone: points are taken to be as far apart as rows"));
}

TEST(AxesOfAHeader, FollowWidthAndLength) {
  expectSpacings("Width: 24 um\nLength: 27 um\nZ unit: um\n", 2e-6, 3e-6);
  expectSpacings("L\u00E4nge: 24 um\nBreite: 27 um\nZ unit: um\n", 2e-6, 3e-6);
  expectSpacings("Width: 24 um\nHeight: 27 um\nLength: 5 mm\nZ unit: um\n", 2e-6, 3e-6);
}

TEST(AxesOfAHeader, RefuseContradictions) {
  const std::string twice = "Spacing: 0.5 um\nSpacing: 2 um\n";
  EXPECT_THAT(errorOf(twice + list()),
              HasSubstr("surface.point_spacing: is needed (in m): lines 1 and 2 state different "
                        "lengths of one axis"));
  EXPECT_NEAR(read(twice + list(), {.spacing = 3e-6}).topography.columnSpacing, 3e-6, 1e-15);
  // Rounding is no contradiction.
  EXPECT_EQ(errorOf("Spacing: 0.5 um\nSpacing: 501 nm\n" + list()), "no error");
}

TEST(PointDistances, HaveManyNames) {
  for (const std::string line :
       {"\u0394x = 0.5 \u00B5m",
        "Sample distance: 500 nm",
        "X-Resolution: 0.5 \u00B5m/pt",
        "Points per mm: 2000",
        "Sampling interval 0.0005 mm (2000 pt/mm)",
        "Grid spacing (mm): 0.0005",
        "Abtastschritt [\u00B5m]: 0,5",
        "X-Abstand: 0,5 \u00B5m",
        "Aufl\u00F6sung X: 0,5 \u00B5m",
        "Digitalisierungsabstand: 0,5 \u00B5m",
        "Pas d'\u00E9chantillonnage : 0,5 \u00B5m",
        "Intervalle: 0,5 \u00B5m",
        "Passo: 0,5 \u00B5m",
        "Paso de muestreo: 0,5 \u00B5m",
        "\u30D4\u30C3\u30C1,0.5,um",
        "\u30B5\u30F3\u30D7\u30EA\u30F3\u30B0\u30D4\u30C3\u30C1: 0.5 \u00B5m",
        "Spacing;0,5;\u00B5m",
        "Punktabstand dx = 0,500 \u00B5m",
        "Step \u0394x: 0.5 \u00B5m",
        "Number of points: 400\nLength: 0.1995 mm"})
    EXPECT_NEAR(read(line + "\n" + list()).topography.columnSpacing, 5e-7, 1e-12) << line;
  expectSpacings("X Amplitude: 24 um\nY Amplitude: 27 um\nZ unit: um\n", 2e-6, 3e-6);
}

TEST(PointDistances, AreNoOtherLengths) {
  expectSpacings("X Resolution: 12\nY Resolution: 9\nX range: 24 um\nY range: 27 um\nZ unit: um\n",
                 2e-6, 3e-6);
  for (const std::string line :
       {"Step height: 1.2 um", "Mean spacing RSm: 12.3 um", "Spacing Sm = 12.3 um",
        "Line spacing: 10 um", "Resolution: 0.01 um", "Position resolution: 0.5 um",
        "Lateral resolution of the instrument: 0.5 um", "Stylus radius: 2 um",
        "Sampling length: 80 um", "Filter spacing: 8 um"})
    EXPECT_THAT(errorOf(line + "\n" + list()), HasSubstr("does not say how far")) << line;
}

/// A line may state the points with their length, the ends of the axis, or how fast a stylus moves.
TEST(PointDistances, FollowFromOtherStatements) {
  for (const std::string line :
       {"Total length: 199.5 um, 400 points", "Length: 199.5 um; points: 400",
        "Points: 400, Step: 0.5 um", "Range X: 0..199.5 um",
        "Speed: 0,5 mm/s; Sampling rate: 1 kHz", "Messl\u00E4nge: 0,1995 mm; 400 Punkte",
        "x from 0 to 199.5 um", "X range: 0 - 199.5 um", "x von 0 bis 199,5 \u00B5m",
        "x-axis (mm): 0.1 ... 0.2995", "X: -10 um to 189.5 um", "x de 0 \u00E0 199,5 \u00B5m",
        "Scan speed: 0.5 mm/s\nSampling rate: 1000 Hz",
        "Vorschubgeschwindigkeit: 0,5 mm/s\nAbtastrate: 1 kHz"})
    EXPECT_NEAR(read(line + "\n" + list()).topography.columnSpacing, 5e-7, 1e-12) << line;
  EXPECT_TRUE(says(read("Scan speed: 0.5 mm/s\nSampling rate: 1000 Hz\n" + list()),
                   "The points are as far apart as the speed and the sampling rate"));
  // The length between the ends may stand in two lines.
  for (const std::string lines :
       {"Start X = 0 um\nEnd X = 199.5 um", "Start X (mm): 0.1\nStop X (mm): 0.2995",
        "X first: 10 um\nX last: 209.5 um", "X0 = 0\nX1 = 199.5\nUnit: um",
        "Start X: 0\nEnd X: 199.5 um", "x_min = -10 um\nx_max = 189.5 um",
        "Xstart: 0 um\nXend: 199.5 um\nPoints: 400"}) {
    const MeasuredFile file = read(lines + "\n" + list());
    EXPECT_NEAR(file.topography.columnSpacing, 5e-7, 1e-12) << lines;
    EXPECT_TRUE(says(file, "apart as their first and last position in the header say.")) << lines;
  }
  expectSpacings("Start X: 0 um\nEnd X: 22 um\nStart Y: 0 um\nEnd Y: 24 um\nZ unit: um\n", 2e-6,
                 3e-6);
  for (const std::string line :
       {"Start X = 0 um\nEnd X = 199.5 s", "Start X = 0 um", "Start X = 5 um\nEnd X = 0 um",
        "Start = 0 um\nEnd = 199.5 um", "Start X = 0 mm\nEnd X = 199.5 um",
        "Start Z = 0 um\nEnd Z = 199.5 um", "Start X = 0 um\nEnd X = 199.5 um\nPoints: 800",
        "Total length: 199.5 um, 800 points", "y from 0 to 199.5 um", "z from 0 to 5 um",
        "x from 0 to 199.5 s", "x from 5 to 0 um", "Scan speed: 0.5 mm/s",
        "Scan speed: 0.5 mm/s\nScan rate: 1 Hz", "Max. 0 to 3 um"})
    EXPECT_THAT(errorOf(line + "\n" + list()), HasSubstr("does not say how far")) << line;
  expectSpacings("x from 0 to 22 um\ny from 0 to 24 um\nZ unit: um\n", 2e-6, 3e-6);
}

/// The name above a matrix states the unit of its numbers, in several languages.
TEST(NamesOfTables, StateAUnit) {
  const std::string spacings = "X-Abstand: 2 um\nY-Abstand: 3 um\n";
  for (const std::string line :
       {"H\u00F6he in \u00B5m", "Hauteur en \u00B5m", "Altura en \u00B5m", "Altezza in \u00B5m",
        "Height (um)", "z [um]", "H\u00F6hen in \u00B5m", "Hauteurs (\u00B5m)", "Hoogte in \u00B5m",
        "Height data (um)", "Altura em \u00B5m", "Vertical unit: um", "\u5358\u4F4D: \u03BCm"})
    EXPECT_NEAR(read(spacings + line + "\n" + field()).topography.at(4, 7), 1e-6 * heightAt(4, 7),
                1e-10)
        << line;
  for (const std::string line : {"Height 27 um", "Height of the sample in um", "Width in um"})
    EXPECT_THAT(errorOf(spacings + line + "\n" + field()), HasSubstr("surface.height_unit"))
        << line;
  const MeasuredFile profile = read("x en mm;hauteur en \u00B5m\n0;1\n1;2\n2;1\n3;2\n");
  EXPECT_NEAR(profile.topography.columnSpacing, 1e-3, 1e-15);
  EXPECT_NEAR(profile.topography.at(0, 1), 2e-6, 1e-18);
}

/// What a header states beside the columns is not lost in silence, nor what the user replaces.
TEST(Contradictions, AreNoted) {
  const std::string rows = "x (um),z (um)\n0,1\n0.5,2\n1,1\n1.5,2\n2,3\n";
  const MeasuredFile file = read("X unit: mm\nZ unit: nm\nSpacing: 2 um\n" + rows);
  EXPECT_NEAR(file.topography.columnSpacing, 5e-7, 1e-15);
  EXPECT_NEAR(file.topography.at(0, 1), 2e-6, 1e-18);
  EXPECT_TRUE(
      says(file, "The header states mm for positions, and their column \u00B5m, which is taken."));
  EXPECT_TRUE(
      says(file, "The header states nm for heights, and their column \u00B5m, which is taken."));
  EXPECT_TRUE(says(file, "The header states a step of 2 \u00B5m, and the positions are 500 nm"));
  for (const std::string header : {"", "X unit: um\nZ unit: \u00B5m\nSpacing: 500 nm\n"}) {
    const MeasuredFile alike = read(header + rows, {.heightUnit = "um"});
    EXPECT_FALSE(says(alike, "The header states")) << header;
    EXPECT_FALSE(says(alike, "replaces it")) << header;
  }
  const MeasuredFile chosen = read(rows, {.positionUnit = "mm", .heightUnit = "nm"});
  EXPECT_TRUE(
      says(chosen, "The file states positions in \u00B5m: surface.position_unit replaces it."));
  EXPECT_TRUE(says(chosen, "The file states heights in \u00B5m: surface.height_unit replaces it."));
}

TEST(StatedNumbersOfPoints, AreComparedWithThosePresent) {
  const std::string spacing = "Spacing: 0.5 um\n";
  for (const std::string key : {"Number of points", "Anzahl Punkte", "\u30C7\u30FC\u30BF\u6570"}) {
    EXPECT_TRUE(says(read(key + ": 800\n" + spacing + list()),
                     "The header states 800 points, and the table has 400"))
        << key;
    EXPECT_FALSE(says(read(key + ": 400\n" + spacing + list()), "cut off")) << key;
  }
  const auto sized = [](const std::string& rows) {
    return read("Horizontal: 12\nVertical: " + rows + "\nSpacing: 2 um\nZ unit: um\n" + field());
  };
  EXPECT_TRUE(
      says(sized("40"), "The header states 12 x 40 points, and the table has 12 x 9: the file"));
  EXPECT_FALSE(says(sized("9"), "cut off"));
}

/// Heights were too large by a hundred in silence. What a factor multiplies no header says.
TEST(StatedFactors, AreNoted) {
  const std::string spacing = "Spacing: 0.5 um\n";
  for (const std::string line :
       {"Scaling factor: 0.01", "Skalierung: 0,01 \u00B5m", "Z scale = 50"})
    EXPECT_TRUE(says(read(spacing + line + "\n" + list()), "which is not applied")) << line;
  EXPECT_FALSE(says(read(spacing + "Scaling factor: 1\n" + list()), "factor"));
  for (const std::string name :
       {"z (um) x100", "z (um) * 0.01", "z x 10^-2 (um)", "z*100 [um]", "z (\u00D7100) (um)",
        "Height x0,1 (um)", "100*z (um)", "z/100 (um)"})
    EXPECT_TRUE(
        says(read(spacing + replaced(list(), "z (um)", name)), "The header states a factor"))
        << name;
  EXPECT_TRUE(says(read("Spacing: 2 um\nZ unit: um\nHeight (um) x100\n" + field()),
                   "The header states a factor of 100 (Height x100), which is not applied"));
  for (const std::string name : {"z (um)", "z x 2 (um)", "z max (um)", "z x1 (um)"})
    EXPECT_FALSE(says(read(spacing + replaced(list(), "z (um)", name)), "factor")) << name;
}

/// Columns in pixels, or whole numbers without a unit beside a stated spacing, number the points.
TEST(PixelCoordinates, NeedTheSpacingAlone) {
  const auto points = [](const std::string& names) {
    std::string text = names;
    for (int row = 0; row < kRowsOfField; ++row)
      for (int column = 0; column < kPointsOfRow; ++column)
        text += fmt::format("{},{},{:.4f}\n", column, row, heightAt(row, column));
    return text;
  };
  for (const std::string names :
       {"X (px),Y (px),Z (um)\n", "x [pixel],y [pixel],z [um]\n", "X,Y,Z (um)\n"}) {
    const MeasuredFile file = read(points(names), {.spacing = 2e-6});
    ASSERT_EQ(file.topography.columns, kPointsOfRow) << names;
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-15) << names;
    EXPECT_NEAR(file.topography.rowSpacing, 2e-6, 1e-15) << names;
    EXPECT_FALSE(says(file, "is not used")) << names;
    EXPECT_TRUE(says(file, "are numbered by")) << names;
  }
  EXPECT_THAT(errorOf(points("X (px),Y (px),Z (um)\n")), HasSubstr("does not say how far"));
  EXPECT_NEAR(read(points("X (um),Y (um),Z (um)\n"), {.spacing = 2e-6}).topography.columnSpacing,
              1e-6, 1e-15);
  std::string profile = "X (px),Z (um)\n";
  for (int i = 0; i < 50; ++i) profile += fmt::format("{},{:.4f}\n", i, heightAt(0, i));
  EXPECT_NEAR(read(profile, {.spacing = 2e-6}).topography.columnSpacing, 2e-6, 1e-15);
  EXPECT_THAT(errorOf(profile), HasSubstr("does not say how far"));
}

/// NanoScope writes one point in each line, row by row, and its header in quotes.
TEST(RowsInOneColumn, AreAFieldWhereTheHeaderStatesItsSize) {
  const std::string header =
      "\"\\*File list\"\n\"\\Scan Size: 24 27 ~m\"\n\"\\Samps/line: 12\"\n\"\\Lines: 9\"\n"
      "\"\\*File list end\"\nHeight(um)\n";
  const MeasuredFile file = read(header + field("\n"));
  ASSERT_EQ(file.topography.columns, kPointsOfRow);
  ASSERT_EQ(file.topography.rows, kRowsOfField);
  EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-15);
  EXPECT_NEAR(file.topography.rowSpacing, 3e-6, 1e-15);
  EXPECT_NEAR(file.topography.at(4, 7), 1e-6 * heightAt(4, 7), 1e-10);
  EXPECT_THAT(errorOf(header + "0.5\n" + field("\n")),
              HasSubstr("the header states 9 rows of 12 points; the file has 109 heights"));
}

}  // namespace
}  // namespace asperity::written
