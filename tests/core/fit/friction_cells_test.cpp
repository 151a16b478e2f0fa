// Tables of friction with errors and units in their cells, and powers of ten in their units.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/fit/friction_texts.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// The error of friction stands in its cells: as the GUM (JCGM 100:2008, 7.2.2) writes it, the
/// digits in brackets count in the last place.
TEST(FrictionData, ReadsErrorsInCells) {
  for (const char* cell : {"0.31\u00B10.02", "0.31 \u00B1 0.02", "0.31 +/- 0.02", "0.31+-0.02",
                           "0.31(2)", "0.31(0.02)", "(0.31 \u00B1 0.02)", "0.310(20)"})
    for (const char* separator : {",", ";", "\t"}) {
      const FrictionData data =
          parsed(std::string("v,mu\n1,") + cell + "\n10," + cell + "\n", separator);
      ASSERT_EQ(data.points.size(), 2U) << cell << separator;
      EXPECT_DOUBLE_EQ(data.points[1].mu, 0.31) << cell << separator;
      EXPECT_DOUBLE_EQ(data.points[1].muError, 0.02) << cell << separator;
      EXPECT_DOUBLE_EQ(data.points[1].velocity, 10) << cell << separator;
      ASSERT_EQ(data.notes.size(), 1U) << cell << separator;
      EXPECT_THAT(data.notes[0].english(),
                  HasSubstr("column 2, in its cells: error of the coefficient of friction"));
    }
  const FrictionData german = parsed("v [mm/s];Reibwert\n1;0,31 \u00B1 0,02\n10;0,35(12)\n");
  EXPECT_DOUBLE_EQ(german.points[0].mu, 0.31);
  EXPECT_DOUBLE_EQ(german.points[0].muError, 0.02);
  EXPECT_DOUBLE_EQ(german.points[1].muError, 0.12);
  for (const char* rows :
       {"1 0.31 \u00B1 0.02\n10 0.35 \u00B1 0.03\n", "1  0.31 +/- 0.02\n10  0.35 +/- 0.03\n"})
    EXPECT_DOUBLE_EQ(parsed(std::string("v_mm/s mu\n") + rows).points[1].muError, 0.03) << rows;
  const FrictionData percent = parsed("v;mu (%)\n1;31 \u00B1 2\n10;35 \u00B1 3\n");
  EXPECT_DOUBLE_EQ(percent.points[0].mu, 0.31);
  EXPECT_DOUBLE_EQ(percent.points[1].muError, 0.03);
  const FrictionData inCells = parsed("v;mu\n1;(31 \u00B1 2) %\n10;(35 \u00B1 3) %\n");
  EXPECT_DOUBLE_EQ(inCells.points[1].mu, 0.35);
  EXPECT_DOUBLE_EQ(inCells.points[1].muError, 0.03);
}

/// The name of the column says what stands after the sign.
TEST(FrictionData, ReadsScalesOfErrorsInCells) {
  const auto errorAt = [](const std::string& name) {
    return parsed("v [mm/s];" + name + "\n1;0.5 \u00B1 0.1\n10;0.7 \u00B1 0.1\n").points[0].muError;
  };
  for (const char* name : {"mu \u00B1 std", "\u00B5 \u00B1 SD", "COF +/- SD", "mu \u00B1 u",
                           "mu \u00B1 u(mu)", "Reibwert \u00B1 Standardabweichung"})
    EXPECT_DOUBLE_EQ(errorAt(name), 0.1) << name;
  for (const char* name : {"mu \u00B1 2 sigma", "mu \u00B1 U (k=2)", "mu \u00B1 2\u03C3"})
    EXPECT_DOUBLE_EQ(errorAt(name), 0.05) << name;
  EXPECT_DOUBLE_EQ(errorAt("mu \u00B1 95 % CI"), 0.1 / 1.96);
  for (const char* name : {"mu \u00B1 range", "mu \u00B1 expanded uncertainty", "mu \u00B1 w"})
    EXPECT_THAT(errorOf(std::string("v;") + name + "\n1;0.5 \u00B1 0.1\n10;0.7 \u00B1 0.1\n"),
                HasSubstr("how many standard errors"))
        << name;
}

/// What may mean something else is refused; errors that no fit uses are named.
TEST(FrictionData, RefusesCellsInDoubt) {
  for (const char* cell :
       {"0.31 \u00B1 5 %", "0.31 (2)", "0.3(5)", "0.31 \u00B1 0.02 (n=3)", "0.31 +0.02 -0.01",
        "0.31(2)(5)", "0.31..0.35", "0.31 \u00B1", "0.31a(2)"})
    EXPECT_NE(errorOf(std::string("v;mu\n1;") + cell + "\n2;" + cell + "\n"), "no error") << cell;
  EXPECT_THAT(errorOf("v;mu\n1;0.31 \u00B1 5 %\n2;0.32 \u00B1 5 %\n"),
              HasSubstr("'0.31 \u00B1 5 %' is not understood as a value with its error"));
  EXPECT_THAT(errorOf("v;mu\n1;0.31 \u00B1 0.02\n2;0.32\n"),
              HasSubstr("because the error of the coefficient of friction is missing: lines 3"));
  EXPECT_THAT(errorOf("v;mu;std\n1;0.31 \u00B1 0.02;0.1\n2;0.32 \u00B1 0.02;0.1\n"),
              HasSubstr("column mu: has errors in its cells, and std gives them, too"));
  const FrictionData data =
      parsed("v (mm/s);mu;F (N)\n1 \u00B1 0.1;0.31;30 \u00B1 1\n2(1);0.32;30(2)\n");
  EXPECT_DOUBLE_EQ(data.points[1].velocity, 2e-3);
  EXPECT_DOUBLE_EQ(data.points[1].normalForce, 30);
  EXPECT_FALSE(data.hasErrors());
  ASSERT_EQ(data.notes.size(), 3U);
  EXPECT_EQ(data.notes[1].english(), "column 1: the errors in its cells are not used");
  EXPECT_EQ(data.notes[2].english(), "column 3: the errors in its cells are not used");
}

/// Units may stand in the cells; several of one quantity are converted.
TEST(FrictionData, ReadsUnitsInCells) {
  const FrictionData data =
      parsed("v;mu;F;T\n10 mm/s;0,31;30 N;23 \u00B0C\n0,1 m/s;0,35;0,03 kN;23 \u00B0C\n");
  EXPECT_DOUBLE_EQ(data.points[0].velocity, 0.01);
  EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.1);
  EXPECT_DOUBLE_EQ(data.points[0].normalForce, 30);
  EXPECT_DOUBLE_EQ(data.points[1].normalForce, 30);
  EXPECT_DOUBLE_EQ(data.points[1].temperature, 296.15);
  EXPECT_THAT(data.notes[0].english(), HasSubstr("column 1: velocity (m/s)"));
  EXPECT_THAT(data.notes[0].english(), HasSubstr("column 4: temperature (\u00B0C)"));
  const FrictionData same = parsed("v,mu\n1 mm/s,0.31(2)\n10 mm/s,0.35(2)\n");
  EXPECT_DOUBLE_EQ(same.points[0].velocity, 1e-3);
  EXPECT_DOUBLE_EQ(same.points[0].muError, 0.02);
  EXPECT_THAT(same.notes[0].english(), HasSubstr("column 1: velocity (mm/s)"));
  EXPECT_DOUBLE_EQ(parsed("v (mm/s);mu\n1 mm/s;0.3\n10;0.4\n").points[1].velocity, 1e-2);
  EXPECT_DOUBLE_EQ(
      parsed("v mu\n10 mm/s 0.31 \u00B1 0.02\n1 m/s 0.35 \u00B1 0.02\n").points[0].velocity, 1e-2);
  EXPECT_DOUBLE_EQ(
      parsed("v;mu;T\n1 m/s;0.3;293.15 K\n2 m/s;0.4;20 \u00B0C\n").points[1].temperature, 293.15);
  EXPECT_THAT(errorOf("v;mu\n1 mm/s;0.3\n10;0.4\n"),
              HasSubstr("row 3: column v has no unit here, and mm/s elsewhere"));
  EXPECT_THAT(errorOf("v (mm/s);mu\n1 mm/s;0.3\n10 m/s;0.4\n"),
              HasSubstr("row 3: column v has the unit m/s here, and mm/s elsewhere"));
  EXPECT_THAT(errorOf("v;mu\n1 mm/s;0.3\n10 mm;0.4\n"), HasSubstr("has the unit mm here"));
  EXPECT_THAT(errorOf("v;mu\n1 furlongs;0.3\n10 furlongs;0.4\n"), HasSubstr("texts where numbers"));
  EXPECT_THAT(errorOf("v;mu;Last\n1;0.3;3 mm\n10;0.4;3 mm\n"), HasSubstr("the unit mm is unknown"));
  EXPECT_THAT(errorOf("v;mu;Druckluft\n1;0.3;2.5 bar\n10;0.4;2.5 bar\n"),
              HasSubstr("column Druckluft: is it the nominal pressure?"));
  // A label is what it is, and a value that is no quantity makes a column of texts.
  EXPECT_EQ(parsed("Probe;v;mu\n5 mm;1;0.3\n8 mm;1;0.4\n").points[1].label, "8 mm");
  EXPECT_EQ(parsed("v;mu;Bemerkung\n1;0.3;5 mm\n2;0.4;glatt\n").notes[1].english(),
            "not used: Bemerkung");
  EXPECT_THAT(
      errorOf("Rad;Last;Temperatur\nA;30 N;20 \u00B0C\nB;60 N;20 \u00B0C\nv;mu\n1;0,5\n2;0,6\n"
              "3;0,7\n4;0,8\n5;0,9\n"),
      HasSubstr("line 2: '30 N' may state the normal force"));
  const FrictionData labels = parsed("Probe;v;mu\nA;10 mm/s;0,31(2)\nB;10 mm/s;0,35(2)\n");
  EXPECT_EQ(labels.points[1].label, "B");
  EXPECT_DOUBLE_EQ(labels.points[1].muError, 0.02);
  // These lines state a load and are no rows.
  EXPECT_THAT(errorOf("Mischung;A12\n20 \u00B0C;30 N\nv;mu\n1;0,5\n10;0,7\n"),
              HasSubstr("is not understood"));
}

/// A power of ten belongs to the unit; with a name alone it may have multiplied the values.
TEST(FrictionData, ReadsUnitsWithAFactor) {
  const auto first = [](const std::string& names, const std::string& row) {
    return parsed(names + "\n" + row + "\n2;0,6;2\n").points[0];
  };
  for (const char* name : {"v (10^-3 m/s)", "v / 10^-3 m/s", "v/10^-3 m/s", "v in 10^-3 m/s",
                           "v (1e-3 m/s)", "v [\u00D710\u207B\u00B3 m/s]", "v (x 10^-3 m/s)",
                           "v (10\u207B\u00B3 m/s)", "v (x10-3 m/s)"})
    EXPECT_DOUBLE_EQ(first(std::string(name) + ";mu;n", "5;0,5;1").velocity, 5e-3) << name;
  EXPECT_DOUBLE_EQ(first("v;mu;F (x 10^3 N)", "1;0,5;1").normalForce, 1000);
  EXPECT_DOUBLE_EQ(first("v;mu;p / 10^5 Pa", "1;0,5;3").nominalPressure, 3e5);
  for (const char* name :
       {"mu (10^-2)", "mu (\u00D710\u207B\u00B2)", "mu / 10^-2", "mu [10^-2]", "mu (1e-2)"})
    EXPECT_DOUBLE_EQ(parsed(std::string("v;") + name + "\n1;31\n2;35\n").points[0].mu, 0.31)
        << name;
  EXPECT_DOUBLE_EQ(parsed("v;mu (10^-2)\n1;31 \u00B1 2\n2;35 \u00B1 2\n").points[0].muError, 0.02);
  EXPECT_DOUBLE_EQ(parsed("Last: 3 x 10^3 N\nv;mu\n1;0,5\n2;0,6\n").points[0].normalForce, 3000);
  for (const char* name : {"mu (10^3)", "mu (\u00D710\u00B3)"})
    EXPECT_THAT(errorOf(std::string("v;") + name + "\n1;310\n2;350\n"),
                HasSubstr("may multiply or divide"))
        << name;
  EXPECT_THAT(errorOf("v;mu (10^-2)\n1;0,31\n2;0,35\n"), HasSubstr("may multiply or divide"));
  for (const char* name : {"v x 10^3 (m/s)", "10^3 v (m/s)", "v (10 m/s)", "v \u00D7 10^-3 m/s"})
    EXPECT_NE(errorOf(std::string(name) + ";mu\n1;0,5\n2;0,6\n"), "no error") << name;
  for (const char* name : {"Load (100 N)", "F x 10^3 (N)", "Load (10-20 N)", "Load (10-3 N)"})
    EXPECT_NE(errorOf(std::string("v;mu;") + name + "\n1;0,5;1\n2;0,6;1\n"), "no error") << name;
  EXPECT_TRUE(std::isnan(first("v;mu;F (100 N)", "1;0,5;1").normalForce));
}

}  // namespace
}  // namespace asperity
