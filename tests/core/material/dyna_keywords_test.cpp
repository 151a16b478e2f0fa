// Prony series in the keywords of LS-DYNA.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/core/material/prony_reading.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// *MAT_076: density, bulk modulus, ..., TREF, A, B; a blank card; G_i, beta_i, K_i, beta_Ki.
const std::string kGeneral =
    "*KEYWORD\n*MAT_GENERAL_VISCOELASTIC_TITLE\nTread\n"
    "$#     mid        ro      bulk       pcf        ef      tref         a         b\n"
    "         1  1.10E-09    2000.0       0.0       0.0       0.0       0.0       0.0\n\n"
    "$#      gi     betai        ki    betaki\n"
    "       1.0       0.0\n       2.0      10.0       5.0      10.0\n       1.0       0.1\n"
    "                          50.0      10.0\n*END\n";

TEST(DynaKeywords, KeywordsOfDyna) {
  const auto file = readSeries(kGeneral);
  expectSeriesNearly(file);
  EXPECT_EQ(file->format.english(), "keywords of LS-DYNA");
  EXPECT_FALSE(file->temperature.has_value());
  EXPECT_THAT(seriesNotes(file),
              testing::ElementsAre("the file states no units; a density of 1.1e-9 is that of a "
                                   "rubber in t/mm3, so moduli are read in MPa and times in s"));
  expectSeriesNearly(readSeries("*MAT_076\n1,1.1e-9,2000.\n,,,\n1.,0.\n2.,10.\n1.,0.1\n"));
  // G(t) = G_inf + (G_0 - G_inf) exp(-beta t)
  for (const std::string keyword : {"*MAT_VISCOELASTIC\n", "*MAT_006\n"}) {
    const auto one =
        readSeries(keyword + "         7    1100.0     2.0e9     3.0e6     1.0e6      10.0\n");
    ASSERT_EQ(one->arms.size(), 1U);
    EXPECT_NEAR(one->equilibriumModulus, 1e6, 1e-3);
    EXPECT_NEAR(one->arms[0].modulus, 2e6, 1e-3);
    EXPECT_NEAR(one->arms[0].relaxationTime, 0.1, 1e-12);
  }
}

/// The density is that of a rubber in one system of units, and in it the times have theirs.
TEST(DynaKeywords, TheDensityTellsTheUnitsOfDyna) {
  const auto deck = [](const std::string& density, double modulus, double rate) {
    return fmt::format("*MAT_076\n1,{},1\n\n{},0\n{},{}\n{},{}\n", density, modulus, 2 * modulus,
                       10 * rate, modulus, 0.1 * rate);
  };
  expectSeriesNearly(readSeries(deck("1100", 1e6, 1)));        // kg, m, s
  expectSeriesNearly(readSeries(deck("1.1e-9", 1, 1)));        // t, mm, s
  expectSeriesNearly(readSeries(deck("1.1e-6", 1e-3, 1e-3)));  // kg, mm, ms
  expectSeriesNearly(readSeries(deck("1.1e-6", 1e3, 1)));      // kg, mm, s
  expectSeriesNearly(readSeries(deck("1.1e-3", 1, 1e-3)));     // g, mm, ms
  expectSeriesNearly(readSeries(deck("1.1e-3", 1e6, 1)));      // g, mm, s
  expectSeriesNearly(readSeries(deck("1.1", 1e-5, 1e-6)));     // g, cm, microseconds
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  expectSeriesNearly(readSeries(deck("1.1e-3", 1, 1e-3), unit));
  for (const std::string density : {"0", "7.8e-9", "1.1"})
    EXPECT_THAT(seriesError(deck(density, 1e3, 1)), HasSubstr("line 2: does not tell its units"))
        << density;
  EXPECT_THAT(seriesError(deck("1.1e-6", 1e-3, 1e-3), unit), HasSubstr("does not tell its units"));
}

TEST(DynaKeywords, AShiftOfDynaIsLeftOut) {
  const auto file =
      readSeries("*MAT_076\n1,1.1e-9,2000.,0,0,296.15,-20.,100.\n\n1,0\n2,10\n1,0.1\n");
  expectSeriesNearly(file);
  EXPECT_FALSE(file->shift.has_value());
  ASSERT_TRUE(file->temperature.has_value());
  EXPECT_EQ(*file->temperature, 296.15);
  EXPECT_THAT(seriesNotes(file), testing::Contains(HasSubstr("the series holds at TREF")));
}

TEST(DynaKeywords, MaterialsOfDynaThatAreNotReadAreRefused) {
  const std::string series = "1,0\n2,10\n1,0.1\n";
  EXPECT_THAT(seriesError("*MAT_ELASTIC\n1,7.8e-9,2.1e5,0.3\n"), HasSubstr("that is not read"));
  EXPECT_THAT(seriesError("*MAT_GENERAL_VISCOELASTIC_MOISTURE\n1,1.1e-9\n\n" + series),
              HasSubstr("that is not read"));
  EXPECT_THAT(seriesError("*MAT_076\n1,1.1e-9\n99\n"),
              HasSubstr("line 3: takes its constants from"));
  EXPECT_THAT(seriesError("*MAT_076\n1,1.1e-9,1,0,1\n\n" + series), HasSubstr("elastic layer"));
  EXPECT_THAT(seriesError("*MAT_006\n1,1.1e-9,2000,-3,1,10\n"), HasSubstr("has -3 in place 4"));
  EXPECT_THAT(seriesError("*MAT_006\n1,1.1e-9,2000,1,3,10\n"), HasSubstr("line 2: does not relax"));
  EXPECT_THAT(seriesError("*MAT_006\n1 1.1e-9 2000 3 1 10\n"),
              HasSubstr("neither 10 characters wide nor separated by commas"));
  EXPECT_THAT(seriesError("*KEYWORD LONG=Y\n*MAT_006\n1,1.1e-9,2000,3,1,10\n"),
              HasSubstr("line 2: is written in the long format"));
  EXPECT_THAT(seriesError("*MAT_006\n1,1.1e-9,2000,3,1,&beta\n"), HasSubstr("a number in place 6"));
  EXPECT_THAT(seriesError(kGeneral + "*MAT_006\n2,1.1e-9,2000,3,1,10\n"),
              HasSubstr("is a second viscoelastic material"));
  const auto file = readSeries("*MAT_ELASTIC\n2,7.8e-9,2.1e5,0.3\n" + kGeneral);
  expectSeriesNearly(file);
  EXPECT_THAT(seriesNotes(file),
              testing::Contains("material Tread is read: of the 2 materials in the "
                                "file, it has the series"));
}

}  // namespace
}  // namespace asperity
