// Surfaces as text: a known profile and a known topography in the forms that instruments, programs
// and people write.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/core/measured/surface_expectations.h"

namespace asperity::written {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A profile of `count` points: z in micrometres at x = i * 2 um.
double profileMicrometres(int i) {
  return 3 * std::sin(0.7 * i) + 0.01 * i;
}
constexpr int kPoints = 40;

void expectProfile(const MeasuredFile& file, double tolerance = 1e-11) {
  const Topography& grid = file.topography;
  EXPECT_EQ(file.facts.format, "profile");
  ASSERT_EQ(grid.columns, kPoints);
  ASSERT_EQ(grid.rows, 1);
  EXPECT_NEAR(grid.columnSpacing, 2e-6, 1e-9 * 2e-6);
  for (int i = 0; i < kPoints; ++i)
    if (!std::isnan(grid.at(0, i))) {
      EXPECT_NEAR(grid.at(0, i), 1e-6 * profileMicrometres(i), tolerance) << i;
    }
}

std::string withComma(std::string text) {
  std::ranges::replace(text, '.', ',');
  return text;
}

/// Rows of the profile by a function of the point.
template <class Row>
std::string rows(const Row& row) {
  std::string text;
  for (int i = 0; i < kPoints; ++i) text += row(i) + "\n";
  return text;
}

// ---- Profiles ----------------------------------------------------------------------------------

/// A power of ten in front of the unit was left to the name, and its factor was lost.
TEST(TextProfile, ReadsPowersOfTenInUnits) {
  const std::string body =
      rows([](int i) { return fmt::format("{};{:.9f}", 2e-3 * i, profileMicrometres(i)); });
  for (const char* names : {"x (mm);z (10^-3 mm)", "x (mm);z in 10^-3 mm", "x (mm);z / 10^-3 mm",
                            "x (mm);z 10\u207B\u00B3 mm", "x (mm);z (1e-3 mm)"}) {
    SCOPED_TRACE(names);
    expectProfile(read(std::string(names) + "\n" + body));
  }
}

TEST(TextProfile, ReadsUnitsWhereverTheyStand) {
  const auto body = [](const std::string& separator, double ofX, double ofZ) {
    return rows([&](int i) {
      return fmt::format("{:.12g}{}{:.9g}", 2.0 * i * ofX, separator, profileMicrometres(i) * ofZ);
    });
  };
  expectProfile(read("x (mm),z (um)\n" + body(",", 1e-3, 1)));
  expectProfile(read("x;z\nmm;\u00B5m\n" + body(";", 1e-3, 1)));
  expectProfile(read("x\tz\n[\u00B5m]\t[nm]\n" + body("\t", 1, 1e3)));
  expectProfile(read("# x [mm]  z [\u03BCm]\n" + body(" ", 1e-3, 1)));
  expectProfile(read("X_(microns),Height_(microns)\n" + body(",", 1, 1)));
  expectProfile(read("Distance / mm;Height / nm\n" + body(";", 1e-3, 1e3)));
  expectProfile(read("x_in,z_um\n" + body(",", 1 / 25400.0, 1)), 1e-10);
  expectProfile(read("x (1e-6 m) z (10^-6 m)\n" + body(" ", 1, 1)));
  expectProfile(read("x,z\n" + body(",", 1e-6, 1e-6)));
  expectProfile(read("Unit: mm\n\n" + body(" ", 1e-3, 1e-3)));
  expectProfile(read("# X-axis unit: mm\n# Z-axis unit: \u00B5m\nX;Z\n" + body(";", 1e-3, 1)));
  for (const std::string separator : {",", ";", " "}) {
    const std::string text = body(separator, 1e-3, 1e3);
    for (const char* units : {"# units: x in mm, z in nm\n", "# Units: mm, nm\n"}) {
      const MeasuredFile file = read(units + ("x" + separator + "z\n") + text);
      expectProfile(file);
      EXPECT_THAT(file.facts.positionColumn, testing::Not(HasSubstr("units"))) << units;
    }
    expectProfile(read("# units: x in mm; z in nm\n" + text));
  }
  expectProfile(read("X unit = mm\nZ unit = nm\nx,z\n" + body(",", 1e-3, 1e3)));
  expectProfile(read("L\u00E4nge (mm);H\u00F6he (\u00B5m)\n" + withComma(body(";", 1e-3, 1))));
  expectProfile(read("L\xE4nge (mm);H\xF6he (\xB5m)\r\n" + withComma(body(";", 1e-3, 1))));
}

TEST(TextProfile, TakesUnitsFromTheUserFirst) {
  const std::string text = "x (m),z (m)\n" + rows([](int i) {
                             return fmt::format("{},{:.9g}", 2 * i, profileMicrometres(i));
                           });
  ReadingChoices choices;
  choices.positionUnit = choices.heightUnit = "um";
  const MeasuredFile file = read(text, choices);
  expectProfile(file);
  EXPECT_EQ(file.facts.positionUnit.source, UnitSource::Choice);
  EXPECT_TRUE(says(file, "Positions are in \u00B5m, as surface.position_unit says."));
  EXPECT_TRUE(says(file, "Heights are in \u00B5m, as surface.height_unit says."));
  EXPECT_TRUE(says(read("z (um)\n1\n2\n1\n2\n3\n", {.spacing = 2e-6}),
                   "The points are 2 \u00B5m apart, as surface.point_spacing says."));
}

/// Two profiles side by side, the second with other distances.
TEST(TextProfile, TakesThePositionsBesideTheChosenHeights) {
  const std::string text =
      "x1 (um);z1 (um);x2 (um);z2 (um)\n" + rows([](int i) {
        return fmt::format("{};{:.6f};{};{:.6f}", 0.5 * i, profileMicrometres(i), 2 * i,
                           profileMicrometres(i) + 1);
      });
  for (const auto& [column, spacing] : {std::pair{2, 0.5e-6}, std::pair{4, 2e-6}}) {
    ReadingChoices choices;
    choices.heightColumn = column;
    EXPECT_NEAR(read(text, choices).topography.columnSpacing, spacing, 1e-12) << column;
  }
}

TEST(TextProfile, AsksForUnitsThatCannotBeMetres) {
  const auto text = [](double ofX, double ofZ) {
    return rows([&](int i) {
      return fmt::format("{:.9g} {:.9g}", 2 * i * ofX, profileMicrometres(i) * ofZ);
    });
  };
  EXPECT_THAT(errorOf(text(1, 1)),
              HasSubstr("surface.position_unit: is needed (m, mm, \u00B5m, nm, in, mil)"));
  EXPECT_THAT(errorOf(text(1e-6, 1)), HasSubstr("surface.height_unit: is needed"));
  ReadingChoices choices;
  choices.positionUnit = "um";
  EXPECT_THAT(errorOf(text(1, 1), choices), HasSubstr("surface.height_unit: is needed"));
  choices.heightUnit = "um";
  expectProfile(read(text(1, 1), choices));
  EXPECT_THAT(errorOf("z\n1e-6\n2e-6\n1e-6\n3e-6\n"), HasSubstr("how far its points are apart"));
  // Stated units are believed, however long or steep.
  EXPECT_EQ(errorOf("x (m),z (m)\n0,0\n10,1000\n20,-1000\n"), "no error");
  choices.heightUnit = "furlong";
  EXPECT_THAT(errorOf(text(1, 1), choices), HasSubstr("surface.height_unit"));
  EXPECT_THAT(errorOf("x (s),z (um)\n0,1\n1,2\n2,3\n"),
              HasSubstr("'s', which is not a unit of length; surface.position_unit can name"));
}

TEST(TextProfile, FindsTheColumnsAmongOthers) {
  const auto value = [](int i) { return fmt::format("{:.9g}", profileMicrometres(i)); };
  // Row numbers before the others, with and without names; a column of validity after them.
  expectProfile(read("index,x (um),z (um)\n" +
                     rows([&](int i) { return fmt::format("{},{},{}", i + 1, 2 * i, value(i)); })));
  expectProfile(read("#;x;z\n;um;um\n" +
                     rows([&](int i) { return fmt::format("{};{};{}", i + 1, 2 * i, value(i)); })));
  expectProfile(read(",x (um),z (um)\n" +
                     rows([&](int i) { return fmt::format("{},{},{}", i, 2 * i, value(i)); })));
  ReadingChoices um;
  um.positionUnit = um.heightUnit = "um";
  expectProfile(read(rows([&](int i) { return fmt::format("{} {} {}", i, 2 * i, value(i)); }), um));
  // Names in another order, and time beside them.
  expectProfile(read("time (s),z (um),x (um)\n" + rows([&](int i) {
                       return fmt::format("{},{},{}", 0.1 * i, value(i), 2 * i);
                     })));
  const MeasuredFile flagged =
      read("x (um),z (um),valid\n" + rows([&](int i) {
             return fmt::format("{},{},{}", 2 * i, i == 5 ? "99" : value(i), i == 5 ? 0 : 1);
           }));
  expectProfile(flagged);
  EXPECT_EQ(flagged.facts.gaps, 1);
  EXPECT_TRUE(std::isnan(flagged.topography.at(0, 5)));
  const MeasuredFile words =
      read("x (um);z (um);status\n" + rows([&](int i) {
             return fmt::format("{};{};{}", 2 * i, value(i), i == 7 ? "BAD" : "OK");
           }));
  EXPECT_TRUE(std::isnan(words.topography.at(0, 7)));
  EXPECT_EQ(words.facts.gaps, 1);
}

TEST(TextProfile, LetsTheUserChooseColumns) {
  const std::string text = "x (um),raw (um),filtered (um)\n" + rows([](int i) {
                             return fmt::format("{},{:.9g},{:.9g}", 2 * i,
                                                5 + profileMicrometres(i), profileMicrometres(i));
                           });
  ReadingChoices choices;
  choices.heightColumn = 3;
  expectProfile(read(text, choices));
  EXPECT_NEAR(read(text).topography.at(0, 0), 5e-6, 1e-12);
  EXPECT_TRUE(says(read(text), "surface.height_column"));
  choices.positionColumn = 4;
  EXPECT_THAT(errorOf(text, choices), HasSubstr("surface.position_column: the file has 3 columns"));
  choices.positionColumn = 3;
  EXPECT_THAT(errorOf(text, choices), HasSubstr("surface.height_column"));
}

TEST(TextProfile, TakesHeightsAlone) {
  const std::string heights =
      rows([](int i) { return fmt::format("{:.9g}", profileMicrometres(i)); });
  expectProfile(read("Spacing = 2 um\nz (um)\n" + heights));
  expectProfile(read("# dx: 0,002 mm\n# Unit Z: um\n" + withComma(heights)));
  expectProfile(read("Spacing (um);2\nz (um)\n" + heights));
  ReadingChoices choices;
  choices.positionUnit = "um";
  const MeasuredFile file = read("Height [um]\n" + heights, choices);
  EXPECT_NEAR(file.topography.columnSpacing, 1e-6, 1e-18);
  EXPECT_TRUE(says(file, "how far"));
  choices.positionUnit = "auto";
  choices.spacing = 2e-6;
  expectProfile(read("Height [um]\n" + heights, choices));
  // Where the file says it, the file counts.
  choices.spacing = 7e-6;
  expectProfile(read("Spacing = 2 um\nz (um)\n" + heights, choices));
}

TEST(TextProfile, KeepsGaps) {
  for (const char* missing : {"NaN", "BAD", "", "-", "***", "inf"}) {
    const MeasuredFile file =
        read("x (um);z (um)\n" + rows([&](int i) {
               return fmt::format("{};{}", 2 * i,
                                  i == 3 ? missing : fmt::format("{:.9g}", profileMicrometres(i)));
             }));
    expectProfile(file);
    EXPECT_EQ(file.facts.gaps, 1) << missing;
  }
  // Rows that are left out.
  std::string text = "x (um);z (um)\n";
  for (int i = 0; i < kPoints; ++i)
    if (i != 10 && i != 11) text += fmt::format("{};{:.9g}\n", 2 * i, profileMicrometres(i));
  const MeasuredFile file = read(text);
  expectProfile(file);
  EXPECT_EQ(file.facts.gaps, 2);
  EXPECT_TRUE(says(file, "2 places have no row"));
}

// ---- Positions ---------------------------------------------------------------------------------

TEST(TextProfile, TakesRoundedPositionsForUniform) {
  constexpr int kMany = 3000;
  constexpr double kStep = 0.38619;  // um
  for (const char* format : {"{:.2f}", "{:.1f}", "{:.4f}", "{:.3e}", "{:.6g}"}) {
    std::string text = "x (um),z (nm)\n";
    for (int i = 0; i < kMany; ++i)
      text += fmt::format(fmt::runtime(std::string(format) + ",{}\n"), i * kStep, i % 17);
    const MeasuredFile file = read(text);
    ASSERT_EQ(file.topography.columns, kMany) << format;
    EXPECT_FALSE(file.facts.resampled) << format;
    EXPECT_NEAR(file.topography.columnSpacing, kStep * 1e-6, 2e-5 * kStep * 1e-6) << format;
    for (int i = 0; i < kMany; i += 7)
      ASSERT_NEAR(file.topography.at(0, i), (i % 17) * 1e-9, 1e-18) << format;
  }
}

TEST(TextProfile, InterpolatesPositionsThatAreNotUniform) {
  // A straight line is kept by linear interpolation, wherever its points are.
  std::string text = "x (um),z (um)\n";
  std::mt19937 random(7);
  double x = 5;
  for (int i = 0; i < 50; ++i) {
    text += fmt::format("{:.7f},{:.7f}\n", x, 0.3 * x - 4);
    x += 0.5 + static_cast<double>(random() % 1000) / 1000;
  }
  const MeasuredFile file = read(text);
  EXPECT_TRUE(file.facts.resampled);
  EXPECT_TRUE(says(file, "not uniform"));
  EXPECT_GT(file.facts.spacingVariation, 0.1);
  const Topography& grid = file.topography;
  ASSERT_EQ(grid.columns, 50);
  for (int i = 0; i < 50; ++i) {
    const double at = 5e-6 + i * grid.columnSpacing;
    EXPECT_NEAR(grid.at(0, i), 0.3 * at - 4e-6, 1e-12);
  }
}

TEST(TextProfile, TurnsFallingPositionsRound) {
  const MeasuredFile file = read("x (um),z (um)\n" + rows([](int i) {
                                   return fmt::format("{},{:.9g}", 2 * (kPoints - 1 - i),
                                                      profileMicrometres(kPoints - 1 - i));
                                 }));
  expectProfile(file);
  EXPECT_TRUE(says(file, "turned round"));
}

TEST(TextProfile, NamesTheLineOfPositionsThatGoBack) {
  EXPECT_THAT(errorOf("x (um),z (um)\n0,1\n1,2\n2,3\n1.5,4\n3,5\n"),
              HasSubstr("line 5: the position goes back"));
  EXPECT_THAT(errorOf("x (um),z (um)\n1,1\n1,2\n1,3\n1,4\n"), HasSubstr("same"));
  EXPECT_THAT(errorOf("x (um),z (um)\n0,1\n,2\n2.5,3\n3,4\n"),
              HasSubstr("line 3: the position is missing"));
  const MeasuredFile repeated = read("x (um),z (um)\n0,1\n1,2\n1,4\n2,5\n3,6\n");
  EXPECT_TRUE(says(repeated, "One row repeats a position"));
  EXPECT_NEAR(repeated.topography.at(0, 1), 3e-6, 1e-15);
}

TEST(TextProfile, SaysWhatItLeavesOut) {
  const MeasuredFile file =
      read("x (um),z (um)\n" +
           rows([](int i) { return fmt::format("{},{:.9g}", 2 * i, profileMicrometres(i)); }) +
           "\nMotif table\n1,2,3\n4,5,6\n");
  expectProfile(file);
  EXPECT_TRUE(says(file, "2 tables of numbers"));
  EXPECT_THAT(errorOf("x (um),z (um)\n0,1\n1,2x\n2,3\n"),
              HasSubstr("line 3: '2x' in column 2 is not a number"));
  EXPECT_THAT(errorOf("x (um),z (um)\n0,1\n1,2\n"), HasSubstr("at least 3"));
}

// ---- Topographies ------------------------------------------------------------------------------

std::string matrix(const std::string& separator, double unit, bool gap, char decimal = '.') {
  std::string text;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      std::string number = gap && isGap(row, column)
                               ? "NaN"
                               : fmt::format("{:.9g}", micrometres(row, column) * unit);
      if (decimal == ',') std::ranges::replace(number, '.', ',');
      text += (column > 0 ? separator : "") + number;
    }
    text += "\n";
  }
  return text;
}

TEST(TextMatrix, ReadsTheExportOfGwyddionInItsLanguages) {
  const std::vector<std::array<std::string, 4>> languages{
      {"Channel: ", "Width: ", "Height: ", "Value units: "},
      {"Kanal: ", "Breite: ", "H\u00F6he: ", "Einheiten: "},
      {"Kanal: ", "Breite: ", "H\u00F6he: ", "Werteinheiten: "},
      {"Canal : ", "Largeur : ", "Hauteur : ", "Unit\u00E9s : "},
      {"Canal : ", "Largeur : ", "Hauteur : ", "Unit\u00E9s des valeurs : "},
      {"Kan\u00E1l: ", "\u0160\u00ED\u0159ka: ", "V\u00FD\u0161ka: ", "Jednotky hodnot: "},
      {"\u041A\u0430\u043D\u0430\u043B: ", "\u0428\u0438\u0440\u0438\u043D\u0430: ",
       "\u0412\u044B\u0441\u043E\u0442\u0430: ",
       "\u0415\u0434\u0438\u043D\u0438\u0446\u044B "
       "\u0438\u0437\u043C\u0435\u0440\u0435\u043D\u0438\u044F: "},
      {"\u30C1\u30E3\u30CD\u30EB\uFF1A ", "\u5E45: ", "\u9AD8\u3055\uFF1A ",
       "\u5024\u306E\u5358\u4F4D: "}};
  for (const auto& [channel, width, height, values] : languages)
    for (const char* separator : {" ", "\t"}) {
      const std::string header =
          fmt::format("# {}Raw\n# {}{} \u00B5m\n# {}{} nm\n# {}nm\n", channel, width,
                      1e6 * kColumns * kColumnSpacing, height, 1e9 * kRows * kRowSpacing, values);
      expectKnown(read(header + matrix(separator, 1e3, true)), "matrix", true, 1e-14);
    }
}

TEST(TextMatrix, ReadsMatricesWithSpacings) {
  for (const char* separator : {",", ";", "\t", " ", ", "}) {
    expectKnown(
        read(fmt::format("dx = 2 um\ndy = 5 um\nValue units = um\n") + matrix(separator, 1, false)),
        "matrix", false, 1e-14);
  }
  expectKnown(read("dx: 2 um\ndy: 5 um\nz unit: um\n" + matrix(";", 1, true, ',')), "matrix", true,
              1e-14);
  // ESRI: one cell size, a number for what is missing.
  std::string esri = matrix(" ", 1e-6, true);
  esri.replace(esri.find("NaN"), 3, "-9999");
  const MeasuredFile file = read(
      "ncols 7\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 2e-6\nNODATA_value -9999\n" + esri);
  EXPECT_EQ(file.facts.gaps, 1);
  EXPECT_NEAR(file.topography.rowSpacing, 2e-6, 1e-18);
}

TEST(TextMatrix, ReadsPositionsInFirstRowAndColumn) {
  for (const char* corner : {"", "y\\x", "NaN"}) {
    std::string text = corner;
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format(";{:g}", column * kColumnSpacing);
    text += "\n";
    for (int row = 0; row < kRows; ++row) {
      text += fmt::format("{:g}", row * kRowSpacing);
      for (int column = 0; column < kColumns; ++column)
        text += fmt::format(";{:.9g}", height(row, column));
      text += "\n";
    }
    expectKnown(read(text), "matrix", false, 1e-14, 1e-9);
  }
}

TEST(TextMatrix, ReadsUnitsInItsCorner) {
  const auto framed = [](const std::string& corner, double ofX, double ofY) {
    std::string text = corner;
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format(",{:g}", column * 2 * ofX);
    text += "\n";
    for (int row = 0; row < kRows; ++row) {
      text += fmt::format("{:g}", row * 5 * ofY);
      for (int column = 0; column < kColumns; ++column)
        text += fmt::format(",{:.9g}", micrometres(row, column));
      text += "\n";
    }
    return text;
  };
  ReadingChoices choices;
  choices.heightUnit = "um";
  expectKnown(read(framed("y\\x [\u00B5m]", 1, 1), choices), "matrix", false, 1e-14, 1e-9);
  expectKnown(read(framed("mm", 1e-3, 1e-3), choices), "matrix", false, 1e-14, 1e-9);
  expectKnown(read(framed("z (\u00B5m) \\ x (mm)", 1e-3, 1e-3)), "matrix", false, 1e-14, 1e-9);
  expectKnown(read(framed("Z [\u00B5m] | X [mm] / Y [um]", 1e-3, 1)), "matrix", false, 1e-14, 1e-9);
  EXPECT_THAT(errorOf(framed("mm", 1e-3, 1e-3)), HasSubstr("surface.height_unit: is needed"));
  EXPECT_THAT(errorOf(framed("y\\x [furlong]", 1e-6, 1e-6), choices),
              HasSubstr("surface.position_unit: is needed"));
}

/// Rows and columns that count the points are no heights.
TEST(TextMatrix, LeavesNumbersOfRowsAndColumnsOut) {
  const auto numbered = [](bool row, bool column, int first, const std::string& corner) {
    std::string text = row && column ? corner + "," : "";
    for (int i = 0; i < kColumns && row; ++i)
      text += fmt::format("{}{}", i + first, i + 1 < kColumns ? "," : "\n");
    for (int i = 0; i < kRows; ++i) {
      if (column) text += fmt::format("{},", i + first);
      for (int j = 0; j < kColumns; ++j)
        text += fmt::format("{:.9g}{}", micrometres(i, j), j + 1 < kColumns ? "," : "\n");
    }
    return text;
  };
  ReadingChoices choices;
  choices.heightUnit = "um";
  const std::string steps = "dx: 2 um\ndy: 5 um\n";
  for (const int first : {0, 1}) {
    for (const char* corner : {"", "0"}) {
      const std::string text = numbered(true, true, first, corner);
      expectKnown(read(steps + text, choices), "matrix", false, 1e-14);
      EXPECT_THAT(errorOf(text, choices), HasSubstr("surface.point_spacing: is needed"));
    }
    const MeasuredFile row = read(steps + numbered(true, false, first, ""), choices);
    expectKnown(row, "matrix", false, 1e-14);
    EXPECT_TRUE(says(row, "The first row numbers the points."));
    const MeasuredFile column = read(steps + numbered(false, true, first, ""), choices);
    expectKnown(column, "matrix", false, 1e-14);
    EXPECT_TRUE(says(column, "The first column numbers the points."));
  }
  // Few whole numbers may be either, a ramp is none.
  const std::string unclear = steps + "1 2 3 4\n5 5 6 9\n7 1 2 8\n";
  EXPECT_THAT(errorOf(unclear, choices), HasSubstr("surface.format: is needed: the first row may"));
  choices.format = "matrix";
  EXPECT_EQ(read(unclear, choices).topography.rows, 3);
  choices.format = "auto";
  EXPECT_EQ(read(steps + "1 2 3 4\n5 6 7 8\n4 5 6 7\n", choices).topography.rows, 3);
}

TEST(TextMatrix, AsksHowFarThePointsAreApart) {
  EXPECT_THAT(errorOf(matrix(" ", 1, false)), HasSubstr("surface.point_spacing: is needed"));
  ReadingChoices choices;
  choices.positionUnit = choices.heightUnit = "um";
  const MeasuredFile file = read(matrix(" ", 1, false), choices);
  EXPECT_EQ(file.topography.columns, kColumns);
  EXPECT_NEAR(file.topography.rowSpacing, 1e-6, 1e-18);
  ReadingChoices stated;
  stated.spacing = 3e-6;
  stated.heightUnit = "um";
  EXPECT_NEAR(read(matrix(" ", 1, false), stated).topography.columnSpacing, 3e-6, 1e-18);
}

// ---- Points ------------------------------------------------------------------------------------

TEST(TextPoints, ReadsPointsInAnyOrder) {
  std::vector<int> order(kColumns * kRows);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(3);
  for (int way = 0; way < 5; ++way) {
    if (way == 1) std::ranges::reverse(order);
    if (way == 2)  // column by column
      for (int i = 0; i < kColumns * kRows; ++i)
        order[static_cast<std::size_t>(i)] = i % kRows * kColumns + i / kRows;
    if (way > 2) std::shuffle(order.begin(), order.end(), random);
    for (const bool gap : {false, true})
      for (const std::string header :
           {"x (um),y (um),z (nm)\n", "X [\u00B5m];Y [\u00B5m];Z [nm]\n", ""}) {
        const std::string separator = header.starts_with("X") ? ";" : ",";
        std::string text = header;
        for (const int point : order) {
          const int row = point / kColumns, column = point % kColumns;
          if (gap && isGap(row, column)) continue;  // is left out
          const double unit = header.empty() ? 1e-6 : 1;
          text += fmt::format("{:.10g}{}{:.10g}{}{:.10g}\n", column * 2.0 * unit, separator,
                              row * 5.0 * unit, separator,
                              micrometres(row, column) * (header.empty() ? 1e-6 : 1e3));
        }
        expectKnown(read(text), "points", gap, 1e-13, 1e-9);
      }
  }
}

TEST(TextPoints, ReadsRoundedPositions) {
  // Steps of a third, printed with three decimals.
  std::string text = "x (mm) y (mm) z (mm)\n";
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 30; ++column)
      text += fmt::format("{:.3f} {:.3f} {}\n", column / 3.0, row / 7.0, row + 0.1 * column);
  const MeasuredFile file = read(text);
  ASSERT_EQ(file.topography.columns, 30);
  ASSERT_EQ(file.topography.rows, 20);
  EXPECT_NEAR(file.topography.columnSpacing, 1e-3 / 3, 1e-7);
  EXPECT_NEAR(file.topography.rowSpacing, 1e-3 / 7, 1e-7);
  EXPECT_NEAR(file.topography.at(3, 4), 3.4e-3, 1e-12);
}

TEST(TextPoints, RefusesPointsWithoutAGrid) {
  std::string text = "x (um),y (um),z (um)\n";
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) text += fmt::format("{},{},{}\n", random() % 997, random() % 991, i);
  EXPECT_THAT(errorOf(text), HasSubstr("do not lie on a grid"));
  EXPECT_THAT(errorOf("x (um),y (um),z (um)\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n1,1,5\n2,0,1\n2,1,1\n"),
              HasSubstr("line 6: there is a point at this position already"));
}

/// Clouds of points have colours or normals after their heights.
TEST(TextPoints, MayHaveColoursAndNormals) {
  ReadingChoices choices;
  choices.positionUnit = choices.heightUnit = "um";
  for (const bool hasNormals : {false, true}) {
    std::string text;
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        text += fmt::format("{} {} {:.10g} {}\n", column * 2, row * 5, micrometres(row, column),
                            hasNormals ? "0.1 -0.2 0.97" : "128 120 110");
    expectKnown(read(text, choices), "points", false, 1e-13, 1e-9);
  }
}

/// Columns of different quantities are no matrix of heights, unless the user says so.
TEST(TextPoints, WithoutAGridAreNoMatrix) {
  std::string text;
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
    text += fmt::format("{} {} {} 128 120 110\n", 0.001 * static_cast<double>(random() % 997),
                        0.001 * static_cast<double>(random() % 991),
                        1e-4 * static_cast<double>(random() % 97));
  EXPECT_THAT(errorOf(text), HasSubstr("surface.format: is needed (profile, matrix or points): "
                                       "columns 3 and 4 of 6 are too different"));
  ReadingChoices choices;
  choices.format = "matrix";
  choices.positionUnit = choices.heightUnit = "um";
  EXPECT_EQ(read(text, choices).topography.columns, 6);
}

TEST(TextPoints, AreNoLengthsInDegrees) {
  std::string rows;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 10; ++column)
      rows += fmt::format("{:.3f},{:.3f},{:.4f}\n", 0.001 * column, 0.005 * row,
                          1e-4 * (row + column % 3));
  EXPECT_THAT(errorOf("Longitude,Latitude,z\n" + rows),
              HasSubstr("column 1 'Longitude' and column 2 'Latitude' are angles"));
  const MeasuredFile file = read("Easting,Northing,Elevation\n" + rows);
  EXPECT_EQ(file.facts.format, "points");
  EXPECT_EQ(file.topography.columns, 10);
  EXPECT_EQ(file.topography.rows, 8);
}

// ---- Real files --------------------------------------------------------------------------------

MeasuredFile readExample(const std::string& name, const ReadingChoices& choices = {}) {
  return readMeasuredFile(std::string(ASPERITY_TESTS_DIR) + "/core/measured/files/" + name,
                          choices);
}

TEST(RealFiles, AreReadOrAskForTheirUnits) {
  ReadingChoices um;
  um.positionUnit = um.heightUnit = "um";
  // 0.0386, 0.0772, 0.1158, 0.1544, 0.1931: rounded, and uniform.
  EXPECT_THROW(readExample("csv-1.csv"), InputError);
  ReadingChoices heights;
  heights.heightUnit = "um";
  const MeasuredFile csv = readExample("csv-1.csv", heights);
  EXPECT_EQ(csv.facts.format, "profile");
  EXPECT_EQ(csv.facts.positionUnit.unit, "microns");
  EXPECT_FALSE(csv.facts.resampled);
  EXPECT_EQ(csv.topography.columns, 8);
  EXPECT_NEAR(csv.topography.columnSpacing, 38.62e-9, 0.01e-9);
  EXPECT_NEAR(csv.topography.at(0, 7), 1.94981e-6, 1e-18);

  const MeasuredFile exported = readExample("gwyddion-export-english.txt");
  EXPECT_EQ(exported.topography.columns, 3);
  EXPECT_EQ(exported.topography.rows, 4);
  EXPECT_NEAR(exported.topography.length(), 12.34e-6, 1e-17);
  EXPECT_NEAR(exported.topography.width(), 5678.9e-9, 1e-17);
  EXPECT_EQ(exported.topography.at(1, 2), -6);

  const MeasuredFile tabs = readExample("txt_example.txt");
  EXPECT_EQ(tabs.topography.columns, 6);
  EXPECT_NEAR(tabs.topography.length(), 1e-6, 1e-18);
  EXPECT_EQ(tabs.topography.at(0, 0), 1e-7);

  EXPECT_THROW(readExample("matrix-5.txt"), InputError);
  EXPECT_EQ(readExample("matrix-5.txt", um).topography.at(4, 9), 2e-6);
  EXPECT_EQ(readExample("matrix-5.txt", um).topography.at(5, 0), 0);

  EXPECT_THROW(readExample("xy-1.txt"), InputError);
  const MeasuredFile profile = readExample("xy-1.txt", um);
  EXPECT_TRUE(profile.facts.resampled);
  EXPECT_EQ(profile.topography.columns, 132);
  EXPECT_NEAR(profile.topography.at(0, 0), 17.85497e-6, 1e-15);

  const MeasuredFile sdf = readExample("sdf-1.sdf");
  EXPECT_EQ(sdf.topography.columns, 7);
  EXPECT_EQ(sdf.topography.rows, 4);
  EXPECT_NEAR(sdf.topography.at(3, 5), 0.94907e-6, 1e-18);
}

}  // namespace
}  // namespace asperity::written
