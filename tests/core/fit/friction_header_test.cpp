// What the lines above a table of friction state.
#include "core/fit/friction_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/fit/friction_texts.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// Lines above the table state what all points share; columns count more.
TEST(FrictionData, ReadsLoadAndTemperatureAboveTheTable) {
  const std::string rows = "v (mm/s);mu;std\n1;0,45;0,02\n10;0,62;0,02\n";
  const FrictionData data =
      parsed("# Tester LFT\n# Nominal pressure: 0,3 MPa\n# Temperature: 5 \u00B0C\n" + rows);
  EXPECT_DOUBLE_EQ(data.points[1].nominalPressure, 3e5);
  EXPECT_DOUBLE_EQ(data.points[1].temperature, 278.15);
  EXPECT_THAT(data.notes[0].english(),
              HasSubstr("line 3: temperature of all points (Temperature: 5 \u00B0C)"));
  EXPECT_DOUBLE_EQ(parsed("Belastung [N]: 50\n" + rows).points[0].normalForce, 50);

  const FrictionData loads =
      parsed("# Normal load: 50 N\n# Nominal pressure: 0.3 MPa\n# Track temperature: 5 C\n" + rows);
  EXPECT_TRUE(std::isnan(loads.points[0].normalForce));
  EXPECT_TRUE(std::isnan(loads.points[0].nominalPressure));
  EXPECT_TRUE(std::isnan(loads.points[0].temperature));
  ASSERT_EQ(loads.notes.size(), 3U);
  EXPECT_EQ(loads.notes[1].english(),
            "not used: Normal load: 50 N, Nominal pressure: 0.3 MPa, Track temperature: 5 C");
  EXPECT_THAT(loads.notes[2].english(), HasSubstr("state several loads"));

  const FrictionData columns =
      parsed("Belastung [N]: 50\nv (mm/s);mu;Belastung (N)\n1;0,45;60\n10;0,62;60\n");
  EXPECT_DOUBLE_EQ(columns.points[0].normalForce, 60);
  EXPECT_EQ(columns.notes[1].english(), "not used: Belastung [N]: 50");
}

/// One velocity of a series over the load or the temperature, and one load of a force of friction.
TEST(FrictionHeader, StatesWhatNoColumnGives) {
  for (const char* line :
       {"# v = 10 mm/s", "# sliding velocity: 10 mm/s", "Velocity 0.01 m/s", "v [mm/s]: 10"}) {
    const FrictionData data = parsed(std::string(line) + "\nFN (N),mu\n0.2,0.25\n0.5,0.2\n");
    EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01) << line;
    EXPECT_DOUBLE_EQ(data.points[1].normalForce, 0.5) << line;
    EXPECT_THAT(data.notes[0].english(), HasSubstr("line 1: velocity of all points")) << line;
  }
  const FrictionData both = parsed("T = 23 \u00B0C, v = 10 mm/s\nFN (N),mu\n0.2,0.25\n0.5,0.2\n");
  EXPECT_DOUBLE_EQ(both.points[0].velocity, 0.01);
  EXPECT_DOUBLE_EQ(both.points[0].temperature, 296.15);
  EXPECT_DOUBLE_EQ(parsed("v = 10 mm/s\nv (m/s),mu\n1,0.2\n2,0.3\n").points[0].velocity, 1);
  for (const char* line : {"", "v = 10 mm/s\nv = 20 mm/s\n", "v = 10\n", "v: 10 N\n"})
    EXPECT_THAT(errorOf(std::string(line) + "mu,T (C)\n0.2,25\n0.3,60\n"), HasSubstr("mine.csv: "))
        << line;
  EXPECT_THAT(errorOf("mu,T (C)\n0.2,25\n0.3,60\n"),
              HasSubstr("has no column of the velocity; its columns are mu, T; name it as in"));
  EXPECT_THAT(errorOf("v = 10 mm/s\nTime (s),mu\n1,0.2\n2,0.3\n"),
              HasSubstr("rows 3 and 4 have the velocity above the table, and no load"));
  EXPECT_THAT(errorOf("v = 10 km/h\nslip (%),mu,FN (N)\n1,0.2,5\n2,0.3,6\n"),
              HasSubstr("column slip: with a slip, the velocity of sliding is not the one"));
  // What a velocity says beside a load does not hide the load.
  EXPECT_THAT(errorOf("v = 10 mm/s under 30 N\nv (m/s),mu\n1,0.2\n2,0.3\n"),
              HasSubstr("may state the normal force"));

  const FrictionData force =
      parsed("Normal load: 0.5 N\nv (m/s),Friction force (mN)\n1,100\n2,150\n");
  EXPECT_DOUBLE_EQ(force.points[1].mu, 0.3);
  EXPECT_DOUBLE_EQ(force.points[1].normalForce, 0.5);
  EXPECT_THAT(errorOf("v (m/s),Friction force (mN)\n1,100\n2,150\n"),
              HasSubstr("a force of friction without a normal force"));
}

/// A load cell gives compression a sign.
TEST(FrictionHeader, TakesTheMagnitudeOfALoadBelowZero) {
  const FrictionData data = parsed("Fz = -30 N\nv (m/s),mu\n1,0.2\n2,0.3\n");
  EXPECT_DOUBLE_EQ(data.points[0].normalForce, 30);
  EXPECT_EQ(
      data.notes[1].english(),
      "line 1: the normal force is below 0, by a convention of signs; its magnitude is taken");
  EXPECT_DOUBLE_EQ(parsed("T = -5 \u00B0C\nv (m/s),mu\n1,0.2\n2,0.3\n").points[0].temperature,
                   268.15);
}

/// A window opens such tables as friction.
TEST(FrictionHeader, TablesWithoutAColumnOfVelocityAreRecognized) {
  for (const char* text :
       {"v (m/s),mu\n1,0.2\n2,0.3\n", "v = 10 mm/s\nFN (N),mu\n0.2,0.25\n0.5,0.2\n",
        "Load: 5 N\nv (m/s),Fx (N)\n1,2\n2,3\n", "v (m/s),mu1,mu2\n1,0.2,0.3\n2,0.3,0.4\n"})
    EXPECT_TRUE(isFrictionTable(text)) << text;
  for (const char* text :
       {"1,0.2\n2,0.3\n", "x (mm),z (um)\n1,0.2\n2,0.3\n", "FN (N),mu\n0.2,0.25\n0.5,0.2\n"})
    EXPECT_FALSE(isFrictionTable(text)) << text;
}

/// A reader looks for what the file has, not for what the program makes of it.
TEST(FrictionHeader, LinesAreQuotedAsTheFileHasThem) {
  const std::string rows = "v (mm/s);mu\n1;0,45\n10;0,62\n";
  for (const char* line : {"Temperature; 5 \u00B0C", "Temperature = 5 \u00B0C"})
    EXPECT_THAT(parsed(std::string(line) + ";;\n" + rows).notes[0].english(),
                HasSubstr("line 1: temperature of all points (" + std::string(line) + ")"));
}

/// A line may have several statements, without signs, with a tolerance or a remark.
TEST(FrictionData, ReadsEachStatementOfALine) {
  const auto first = [](const std::string& line, const std::string& rows) {
    return parsed(line + "\n" + rows).points[0];
  };
  const std::string points = "v (mm/s),mu\n1,0.5\n10,0.7\n",
                    commas = "v (mm/s);mu\n1;0,5\n10;0,7\n";
  for (const std::string& rows : {points, commas, std::string("v (mm/s)\tmu\n1\t0.5\n10\t0.7\n"),
                                  std::string("v_mm/s mu\n1 0.5\n10 0.7\n")}) {
    for (const char* line : {"Load 30 N", "# Load = 30 N", "F = 30 N", "Load: 30 N \u00B1 1 N",
                             "Load: 30 N (constant)", "Normal load at constant 30 N"})
      EXPECT_DOUBLE_EQ(first(line, rows).normalForce, 30) << line << "\n" << rows;
    for (const char* line :
         {"T = 23 \u00B0C", "T = 23 \u00B1 1 \u00B0C", "T = (23 +/- 1) \u00B0C",
          "Temperature T: 23 C", "T 23 \u00B0C", "Test conditions: T = 23 \u00B0C",
          "Test 3: T = 23 \u00B0C", "Temperature: 23 deg C"})
      EXPECT_DOUBLE_EQ(first(line, rows).temperature, 296.15) << line << "\n" << rows;
    for (const char* line : {"Load 30 N, T 23 \u00B0C", "Load = 30 N, T = 23 \u00B0C",
                             "F = 30 N; T = 23 \u00B0C", "# T=23C; F=30N"}) {
      EXPECT_DOUBLE_EQ(first(line, rows).normalForce, 30) << line << "\n" << rows;
      EXPECT_DOUBLE_EQ(first(line, rows).temperature, 296.15) << line << "\n" << rows;
    }
    EXPECT_DOUBLE_EQ(first("Nominal pressure 0.2 MPa", rows).nominalPressure, 2e5) << rows;
  }
  for (const char* line : {"Temperatur: \u20135 \u00B0C", "Temperatur: - 5 \u00B0C",
                           "Temperatur = \u2212 5 \u00B0C", "Temperatur: minus 5 \u00B0C"})
    EXPECT_DOUBLE_EQ(first(line, commas).temperature, 268.15) << line;
}

/// A load or temperature above the table that is not understood is refused where it may be the one
/// meant, and named where it is another.
TEST(FrictionData, ListsStatementsThatItDoesNotUse) {
  for (const char* line :
       {"Weight of 30 N", "30 N", "T = 20 - 25 \u00B0C", "T = 20...25 \u00B0C",
        "Measured with 30 N on the sled", "Temperature - 5 \u00B0C", "Load: 300 g", "Load: 30",
        "Load: 30 N; 60 N", "Load = 30 N, 60 N", "Load: 30 N and 60 N",
        "Mischung 4711, 20 \u00B0C, 30 N", "Mischung: NR 60 Shore A, 2,5 bar, 23 \u00B0C",
        "Load: 3 kg", "Line load: 30 N/m", "T = RT", "Temperature: < 25 \u00B0C"}) {
    const std::string error = errorOf(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n");
    EXPECT_THAT(error, HasSubstr("but is not understood; write it as in")) << line;
    EXPECT_THAT(error, testing::ContainsRegex("set (load|elastomer)\\.")) << line;
  }
  for (const char* line :
       {"Track temperature: 23 \u00B0C", "Track: T = 23 \u00B0C", "Temperature: 23 \u00B0C (track)",
        "Air pressure: 1013 hPa", "Aged 168 h at 70 \u00B0C", "Load cell: 500 N", "M100: 3 MPa",
        "Rebound at 23 \u00B0C: 45 %"}) {
    const FrictionData data = parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n");
    EXPECT_TRUE(std::isnan(data.points[0].temperature)) << line;
    EXPECT_TRUE(std::isnan(data.points[0].normalForce)) << line;
    ASSERT_EQ(data.notes.size(), 2U) << line;
    EXPECT_THAT(data.notes[1].english(), testing::StartsWith("not used: ")) << line;
  }
  EXPECT_EQ(
      parsed("Track 5 \u00B0C, T = 23 \u00B0C\nv (mm/s);mu\n1;0,5\n10;0,7\n").notes[1].english(),
      "not used: Track 5 \u00B0C");
  for (const char* line : {"Sample 5, rough", "Radius: 5 mm", "Date: 2024-05-02", "v = 5 mm/s"})
    EXPECT_EQ(parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n").notes.size(), 1U)
        << line;
}

/// The decimal mark of the rows says what the marks above the table mean.
TEST(FrictionData, ReadsThousandsAboveTheTable) {
  for (const char* text : {"Last: 4.000 N\nv (mm/s);mu\n1;0,5\n10;0,7\n",
                           "Last [N];4.000\nv (mm/s);mu\n1;0,5\n10;0,7\n",
                           "Load: 4,000 N\nv (mm/s),mu\n1,0.5\n10,0.7\n"}) {
    const FrictionData data = parsed(text);
    EXPECT_DOUBLE_EQ(data.points[0].normalForce, 4000) << text;
    ASSERT_EQ(data.notes.size(), 2U) << text;
    EXPECT_THAT(data.notes[1].english(), HasSubstr("is read as 4000; the decimal mark")) << text;
  }
  EXPECT_DOUBLE_EQ(parsed("Last: 4,000 N\nv (mm/s);mu\n1;0,5\n10;0,7\n").points[0].normalForce, 4);
  EXPECT_THAT(errorOf("Last: 4.000 N\nv (mm/s);mu (%)\n1;50\n10;70\n"),
              HasSubstr("'Last: 4.000 N' may state the normal force"));
}

TEST(FrictionData, ReadsStatementsWithoutCommas) {
  for (const char* line :
       {"p=0.2MPa T=23C", "Pressure 2 bar / Temperature 23 degC", "p = 0.2 MPa T = 23 \u00B0C"}) {
    const MeasuredPoint point =
        parsed(std::string(line) + "\nv (mm/s),mu\n1,0.5\n10,0.7\n").points[0];
    EXPECT_DOUBLE_EQ(point.nominalPressure, 2e5) << line;
    EXPECT_DOUBLE_EQ(point.temperature, 296.15) << line;
  }
  for (const char* line : {"# Aged 168 h, T = 23 \u00B0C", "Temperature: approx. 23 \u00B0C"})
    EXPECT_DOUBLE_EQ(
        parsed(std::string(line) + "\nv (mm/s),mu\n1,0.5\n10,0.7\n").points[0].temperature, 296.15)
        << line;
  for (const char* rows : {"T\n1,0.5,RT\n10,0.7,RT\n", "T (deg)\n1,0.5,23\n10,0.7,23\n"})
    EXPECT_THAT(errorOf(std::string("v (mm/s),mu,") + rows),
                HasSubstr("column T: is it the temperature of the rubber?"));
}

/// Lines about the rubber state no load, and the temperature beside a hardness is that of its test.
TEST(FrictionData, ListsPropertiesOfTheRubber) {
  for (const char* line :
       {"Stress at 100 %: 3 MPa", "Stress at 100 % strain: 3 MPa",
        "Spannung bei 100 % Dehnung: 3 MPa", "Spannungswert 100 %: 3 MPa",
        "Tensile stress at 300 %: 12 MPa", "Hardness: 60 Shore A, 23 \u00B0C",
        "H\u00E4rte: 60 Shore A, 23 \u00B0C", "Shore A: 60, 23 \u00B0C", "Shore A 60 at 23 \u00B0C",
        "100 % modulus: 3 MPa", "S100: 3 MPa", "\u03C3100 = 3 MPa"}) {
    const FrictionData data = parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n");
    EXPECT_TRUE(std::isnan(data.points[0].temperature)) << line;
    EXPECT_TRUE(std::isnan(data.points[0].nominalPressure)) << line;
    ASSERT_EQ(data.notes.size(), 2U) << line;
    EXPECT_THAT(data.notes[1].english(), testing::StartsWith("not used: ")) << line;
  }
  for (const char* line :
       {"Stress at 50 % of the load: 0.2 MPa", "Stress: 0.2 MPa", "Hardness: 60 Shore A, 30 N",
        "Compound: NR 60 Shore A, 23 \u00B0C", "Mischung A12, 20 \u00B0C", "Spannung 100: 3 MPa",
        "Hardness: 60 Shore A, 23 \u00B0C, 2 bar",
        "Compound: X, hardness: 60 Shore A, 23 \u00B0C, load: 30 N"})
    EXPECT_THAT(errorOf(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n"),
                HasSubstr("but is not understood"))
        << line;
  EXPECT_DOUBLE_EQ(parsed("Hardness: 60 Shore A, T = 23 \u00B0C\nv (mm/s);mu\n1;0,5\n10;0,7\n")
                       .points[0]
                       .temperature,
                   296.15);
}

/// A sentence about the test with nothing but a temperature.
TEST(FrictionData, ReadsTheTemperatureOfATest) {
  for (const char* line :
       {"Test at 23 \u00B0C", "# Tested at 23 \u00B0C", "Measured at 23 \u00B0C",
        "Messung bei 23 \u00B0C", "gemessen bei 23 \u00B0C", "Pr\u00FCfung bei 23 \u00B0C",
        "Friction test at 23 \u00B0C", "Versuch bei 23 \u00B1 1 \u00B0C", "Test: at 23 \u00B0C"}) {
    const FrictionData data = parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n");
    EXPECT_DOUBLE_EQ(data.points[0].temperature, 296.15) << line;
    EXPECT_THAT(data.notes[0].english(), HasSubstr("line 1: temperature of all points (")) << line;
  }
  for (const char* line : {"Test at 30 N", "Test 23 \u00B0C", "Test at 23 \u00B0C or 40 \u00B0C",
                           "Swollen and tested at 23 \u00B0C", "Test at 2 bar",
                           "Compression set test at 70 \u00B0C", "Rheometer test at 160 \u00B0C"})
    EXPECT_THAT(errorOf(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n"),
                HasSubstr("but is not understood"))
        << line;
  EXPECT_THAT(errorOf("Test at 23 \u00B0C\nTest at 40 \u00B0C\nv (mm/s);mu\n1;0,5\n10;0,7\n"),
              HasSubstr("line 1: 'Test at 23 \u00B0C' may state the temperature"));
  for (const char* line : {"Hardness test at 23 \u00B0C", "Tensile test at 23 \u00B0C"})
    EXPECT_THAT(parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n").notes[1].english(),
                HasSubstr("not used"))
        << line;
}

/// A unit that stands beside the columns is not passed over: it would change the numbers.
TEST(FrictionHeader, RefusesAColumnWhoseUnitStandsElsewhere) {
  for (const char* line : {"# v in mm/s", "Velocity unit: mm/s", "All velocities in mm/s.",
                           "# column 1: velocity [mm/s]", "(v in mm/s)"})
    EXPECT_THAT(errorOf(std::string(line) + "\nv,mu\n1,0.2\n10,0.3\n"),
                HasSubstr("column v: has no unit, and line 1 names 'mm/s'; write the unit into the "
                          "name, as in \"v (mm/s)\""))
        << line;
  EXPECT_THAT(errorOf("v,mu\n1,0.2\n10,0.3\nv in mm/s\n"), HasSubstr("line 4 names 'mm/s'"));
  EXPECT_THAT(errorOf("All loads are in kN\nv (m/s),Fn,mu\n1,2,0.2\n10,2,0.3\n"),
              HasSubstr("column Fn: has no unit, and line 1 names 'kN'"));
  EXPECT_THAT(errorOf("# v in mm/s, mu without unit\nv,mu\n1,0.2\n10,0.3\n"),
              HasSubstr("line 1 names 'mm/s'"));
  for (const char* line : {"Mesure avec un capteur", "Temperature in Kelvin, Fn in N"})
    EXPECT_EQ(parsed(std::string(line) + "\nv,Fn,temperature,mu\n1,2,293,0.2\n10,2,293,0.3\n")
                  .points.size(),
              2U)
        << line;
  for (const char* line : {"v in m/s", "pulled back at 20 mm/s", "Units: mm/s, 1"})
    EXPECT_EQ(parsed(std::string(line) + "\nv,mu\n1,0.2\n10,0.3\n").points.size(), 2U) << line;
  EXPECT_DOUBLE_EQ(parsed("v in m/s, not mm/s\nv (mm/s),mu\n1,0.2\n10,0.3\n").points[0].velocity,
                   1e-3);
}

/// A row that cannot be read is not lost in silence.
TEST(FrictionHeader, SaysWhichLinesBelowTheTableAreNoRows) {
  const FrictionData data = parsed("v;mu\n1;0.2\n10;0.3\n100;<0.1\n");
  EXPECT_EQ(data.points.size(), 2U);
  EXPECT_EQ(data.notes.back().english(),
            "Line 4 is left out: it begins with a number but is not a row of the table.");
}

}  // namespace
/// A list of names and values above the table, some of which are texts.
TEST(FrictionHeader, ReadsAListOfNamesAndValues) {
  const FrictionData data = parsed(
      "Compound;A12\nLoad [N];0,75\nTemperature [\u00B0C];20\n\n"
      "v [mm/s];mu\n1,5;0,3\n10;0,4\n100;0,5\n");
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_DOUBLE_EQ(data.points[0].normalForce, 0.75);
  EXPECT_DOUBLE_EQ(data.points[0].temperature, 293.15);
  EXPECT_DOUBLE_EQ(data.points[0].velocity, 1.5e-3);
  EXPECT_THAT(errorOf("Compound;A12\nSlip angle [\u00B0];15\n\nSpeed [km/h];mu\n1;0,3\n10;0,4\n"),
              HasSubstr("line 2: with a slip"));
  for (const char* list :
       {"Parameter;Value;Unit\nLoad;50;N\nTemperature;20;\u00B0C\nTrack length;100;mm\n\n",
        "Parameter;Unit;Value\nLoad;N;50\nTemperature;\u00B0C;20\nTrack length;mm;100\n\n"}) {
    const FrictionData units = parsed(std::string(list) + "v [mm/s];mu\n1;0,3\n10;0,4\n");
    EXPECT_DOUBLE_EQ(units.points[0].normalForce, 50) << list;
    EXPECT_DOUBLE_EQ(units.points[0].temperature, 293.15) << list;
  }
  EXPECT_DOUBLE_EQ(
      parsed("Device;LFT 3\nSliding speed [mm/s];10\n\nT (\u00B0C);mu\n5;0,5\n20;0,6\n")
          .points[1]
          .velocity,
      0.01);
  EXPECT_THAT(errorOf("Compound;A12\nLoad;3 kg\n\nv [mm/s];mu\n1;0,3\n10;0,4\n"),
              HasSubstr("may state the normal force"));
}

TEST(FrictionHeader, ReadsARowOfConditions) {
  const FrictionData data =
      parsed("Load (N),Temperature (C)\n50,23\n\nv (mm/s),mu\n1,0.4\n10,0.5\n");
  ASSERT_EQ(data.points.size(), 2U);
  EXPECT_EQ(data.points[1].normalForce, 50);
  EXPECT_DOUBLE_EQ(data.points[1].temperature, 296.15);
  EXPECT_THAT(errorOf("Weight (kg);T (C)\n5;23\n\nv (mm/s);mu\n1;0.4\n10;0.5\n"),
              HasSubstr("may state the normal force"));
}

/// A weight may be the load; that of a sample is not.
TEST(FrictionHeader, DoesNotDropAWeight) {
  for (const char* line : {"Weight: 5 kg", "Dead weight = 5 kg", "Masse;5 kg", "Weight [kg]: 5"})
    EXPECT_THAT(errorOf(std::string(line) + "\nv (mm/s);mu\n1;0,3\n10;0,4\n"),
                HasSubstr("may state the normal force"))
        << line;
  for (const char* line : {"Sample weight: 5 kg", "Weight: 5 g", "Tyre mass: 8 kg"})
    EXPECT_EQ(parsed(std::string(line) + "\nv (mm/s);mu\n1;0,3\n10;0,4\n").points.size(), 2U)
        << line;
}

}  // namespace asperity
