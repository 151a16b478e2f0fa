// Tables of measured friction as people write them.
#include "core/fit/friction_data.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/jobs.h"
#include "tests/core/error_from.h"
#include "tests/core/fit/friction_texts.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(FrictionData, ReadsVelocityAndFriction) {
  for (const char* text :
       {"velocity,mu\n0.001,0.2\n0.01,0.35\n", "v (m/s);COF\n0,001;0,2\n0,01;0,35\n",
        "v [mm/s]\t\u00B5\n1\t0.2\n10\t0.35\n",
        "# bench 3\nspeed (mm/s),friction\n1,0.2\n10,0.35\n", "0.001 0.2\n0.01 0.35\n",
        "Geschwindigkeit;Reibwert\nmm/s;-\n1;0,2\n10;0,35\n"}) {
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 2U) << text;
    EXPECT_DOUBLE_EQ(data.points[0].velocity, 1e-3) << text;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.35) << text;
    EXPECT_FALSE(data.hasErrors());
    EXPECT_TRUE(std::isnan(data.points[0].normalForce));
  }
}

TEST(FrictionData, ReadsWhatElseTheTableHas) {
  const FrictionData data = parsed(
      "label,velocity (mm/s),velocity_error (%),mu,mu_error,normal force (mN),temperature (C)\n"
      "A,1,5,0.2,0.01,20,25\nB,10,5,0.35,0.02,20,60\n");
  ASSERT_EQ(data.points.size(), 2U);
  const MeasuredPoint& point = data.points[1];
  EXPECT_EQ(point.label, "B");
  EXPECT_DOUBLE_EQ(point.velocity, 0.01);
  EXPECT_DOUBLE_EQ(point.velocityError, 0.0005);
  EXPECT_DOUBLE_EQ(point.muError, 0.02);
  EXPECT_DOUBLE_EQ(point.normalForce, 0.02);
  EXPECT_DOUBLE_EQ(point.temperature, 333.15);
  EXPECT_EQ(point.row, 3);
  EXPECT_TRUE(data.hasErrors());
  ASSERT_EQ(data.notes.size(), 1U);
  EXPECT_THAT(data.notes[0].english(), HasSubstr("column 2: velocity (mm/s)"));
  EXPECT_THAT(data.notes[0].english(), HasSubstr("column 6: normal force (mN)"));
}

/// The error of friction under the names that people give it; the guide of uncertainties (GUM)
/// writes u(x).
TEST(FrictionData, TheErrorOfFrictionHasManyNames) {
  for (const char* name : {"u(mu)",
                           "u_mu",
                           "dmu",
                           "s(mu)",
                           "s(\u00B5)",
                           "\u03C3_\u00B5",
                           "sigma(mu)",
                           "u [\u03BC]",
                           "\u0394\u03BC",
                           "Standardabweichung",
                           "std",
                           "Std",
                           "SD",
                           "sigma",
                           "std(mu)",
                           "Unsicherheit",
                           "Standardunsicherheit",
                           "mu_error",
                           "uncertainty of mu",
                           "Messunsicherheit"}) {
    const FrictionData data =
        parsed("v [mm/s];mu;" + std::string(name) + "\n1;0,2;0,01\n10;0,35;0,02\n");
    ASSERT_TRUE(data.hasErrors()) << name;
    EXPECT_DOUBLE_EQ(data.points[1].muError, 0.02) << name;
    EXPECT_EQ(data.notes.size(), 1U) << name;
  }
  // No error of friction or velocity: of another quantity, or a word that begins with such a
  // letter.
  for (const char* name : {"u(T)", "distance", "sample number", "stop"})
    EXPECT_FALSE(
        parsed("v [mm/s];mu;" + std::string(name) + "\n1;0,2;0,01\n10;0,35;0,02\n").hasErrors())
        << name;
}

/// A letter that may be a number, a load or a time is taken with its unit alone; what is left out
/// is said.
TEST(FrictionData, SaysWhatItDoesNotUse) {
  const FrictionData data = parsed("v (m/s),mu,sd,n,t,w\n1,0.2,0.01,5,300,7\n2,0.3,0.01,5,310,7\n");
  EXPECT_TRUE(std::isnan(data.points[0].normalForce));
  EXPECT_TRUE(std::isnan(data.points[0].temperature));
  ASSERT_EQ(data.notes.size(), 2U);
  EXPECT_EQ(data.notes[1].english(), "not used: n, t, w");
  const FrictionData meant = parsed("v (m/s),mu,N (mN),t (C)\n1,0.2,5,20\n2,0.3,5,20\n");
  EXPECT_DOUBLE_EQ(meant.points[0].normalForce, 5e-3);
  EXPECT_DOUBLE_EQ(meant.points[0].temperature, 293.15);
}

TEST(FrictionData, NamesATemperatureBelowTheAbsoluteZeroWithoutRounding) {
  EXPECT_THAT(errorOf("v,mu,temperature (C)\n1,0.2,-300\n2,0.3,20\n"),
              HasSubstr("row 2: a temperature of -26.85 K is too cold for rubber"));
}

TEST(FrictionData, ReadsUnitsInWords) {
  EXPECT_DOUBLE_EQ(parsed("v in mm/s;Reibwert\n1;0,2\n2;0,3\n").points[0].velocity, 1e-3);
  EXPECT_NEAR(parsed("v (m/s),mu,load (lbs)\n1,0.2,10\n2,0.3,10\n").points[0].normalForce, 44.482,
              1e-3);
  EXPECT_DOUBLE_EQ(parsed("v (ft/s),mu\n1,0.2\n2,0.3\n").points[0].velocity, 0.3048);
  EXPECT_DOUBLE_EQ(parsed("v (ft/min),mue\n60,0.2\n90,0.3\n").points[0].velocity, 0.3048);
  EXPECT_DOUBLE_EQ(parsed("v (in/min);m\u00FC\n6;0,2\n9;0,3\n").points[0].velocity, 0.00254);
  EXPECT_DOUBLE_EQ(parsed("speed (cm/min),mu\n6,0.2\n9,0.3\n").points[0].velocity, 1e-3);
  EXPECT_DOUBLE_EQ(parsed("v (knots),mu\n3600,0.2\n3700,0.3\n").points[0].velocity, 1852);
  EXPECT_DOUBLE_EQ(parsed("v (m/s),mu (%)\n1,20\n2,30\n").points[0].mu, 0.2);
  EXPECT_DOUBLE_EQ(parsed("log10 v (m/s),mu\n-3,0.2\n-2,0.3\n").points[1].velocity, 1e-2);
  EXPECT_THAT(errorOf("v (m/s),mu,load (g)\n1,0.2,5\n2,0.3,5\n"),
              HasSubstr("the unit g is unknown; known are N, daN, kgf, gf, lbf, mN, uN, kN"));
  EXPECT_THAT(errorOf("v (furlongs),mu\n1,0.2\n2,0.3\n"),
              HasSubstr("the unit furlongs is unknown"));
  EXPECT_THAT(errorOf("v (m/s),mu (V)\n1,0.2\n2,0.3\n"), HasSubstr("the unit V is unknown"));
}

/// Lines above each of several tables may tell them apart; what stands above the first one alone
/// holds for all.
TEST(FrictionData, ReadsSeveralTablesWithTheirStates) {
  const FrictionData data = parsed(
      "Normal force: 30 N\nTemperature: 5 \u00B0C\nv (mm/s),mu\n1,0.2\n2,0.3\n\nTemperature: 25 "
      "\u00B0C\nv (mm/s),mu\n1,0.1\n2,0.2\n\nTemperature: 60 \u00B0C\nv "
      "(mm/s),mu\n1,0.05\n4,0.1\n");
  ASSERT_EQ(data.points.size(), 6U);
  EXPECT_DOUBLE_EQ(data.points[0].temperature, 278.15);
  EXPECT_DOUBLE_EQ(data.points[3].temperature, 298.15);
  EXPECT_DOUBLE_EQ(data.points[5].temperature, 333.15);
  EXPECT_DOUBLE_EQ(data.points[5].velocity, 4e-3);
  EXPECT_DOUBLE_EQ(data.points[5].mu, 0.1);
  for (const MeasuredPoint& point : data.points) EXPECT_DOUBLE_EQ(point.normalForce, 30);
  EXPECT_THAT(data.notes[1].english(),
              HasSubstr("line 7: temperature of the points below it (Temperature: 25 \u00B0C)"));
}

/// Each table is checked by its own columns: their units may differ.
TEST(FrictionData, SeveralTablesMayHaveDifferentColumns) {
  const std::string percent = "Temperature: 5 \u00B0C\nv (mm/s),mu (%)\n1,20\n2,30\n\n",
                    plain = "Temperature: 25 \u00B0C\nv (m/s),mu\n1,0.1\n2,0.2\n\n";
  for (const std::string& text : {percent + plain, plain + percent}) {
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 4U);
    for (const MeasuredPoint& point : data.points) EXPECT_LT(point.mu, 0.4);
  }
  // Without its unit friction in per cent is refused in each of them.
  const std::string hidden = "Temperature: 5 \u00B0C\nv (mm/s),mu\n1,20\n2,30\n\n";
  for (const std::string& text : {hidden + plain, plain + hidden})
    EXPECT_THAT(errorOf(text), HasSubstr("the coefficients of friction are 20 to 30"));
}

/// A table of friction by its names is read, whatever else is in the file.
TEST(FrictionData, ALargerTableOfOtherNumbersIsNotRead) {
  std::string raw = "t (s),Fx (N),x (mm)\n";
  for (int i = 0; i < 40; ++i) raw += std::to_string(i) + ",20,3\n";
  const std::string friction = "v (mm/s),mu\n1,0.2\n2,0.3\n";
  for (const std::string& text : {raw + "\n" + friction, friction + "\n" + raw}) {
    ASSERT_TRUE(isFrictionTable(text));
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 2U);
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.3);
    EXPECT_THAT(data.notes.back().english(),
                HasSubstr("tables of numbers that are not used: at line"));
  }
}

TEST(FrictionData, ReadsErrorsOfACof) {
  for (const std::string name : {"StDev COF", "COF_std", "COF error", "SD of COF"}) {
    const FrictionData data = parsed("v (m/s),COF," + name + "\n1,0.2,0.01\n2,0.3,0.02\n");
    EXPECT_DOUBLE_EQ(data.points[1].muError, 0.02) << name;
  }
}

/// A point has one load: that of a column and not the one above another table.
TEST(FrictionData, AColumnReplacesWhatStandsAboveAnotherTable) {
  const FrictionData data = parsed(
      "Normal force: 30 N\nTemperature: 5 \u00B0C\nv (m/s),mu\n1,0.2\n2,0.3\n\nTemperature: 25 "
      "\u00B0C\nv (m/s),p (MPa),mu\n1,0.1,0.3\n2,0.1,0.2\n");
  ASSERT_EQ(data.points.size(), 4U);
  EXPECT_DOUBLE_EQ(data.points[0].normalForce, 30);
  EXPECT_DOUBLE_EQ(data.points[3].nominalPressure, 1e5);
  EXPECT_TRUE(std::isnan(data.points[3].normalForce)) << data.points[3].normalForce;
}

TEST(FrictionData, RefusesSeveralTables) {
  EXPECT_THAT(errorOf("wet\nv,mu\n1,0.2\n2,0.3\n\ndry\nv,mu\n1,0.1\n2,0.2\n"),
              HasSubstr("several tables of friction, at lines 3 and 8"));
  // The second table may be at the temperature of the first, or at another one.
  EXPECT_THAT(errorOf("T = 25 C\nv,mu\n1,0.2\n2,0.3\n\ndry\nv,mu\n3,0.1\n4,0.2\n"),
              HasSubstr("several tables of friction, at lines 3 and 8"));
  EXPECT_THAT(errorOf("v,mu\n1,0.2\n2,0.3\n\nT = 25 C\nv,mu\n3,0.1\n4,0.2\n"),
              HasSubstr("several tables of friction, at lines 2 and 7"));
  EXPECT_THAT(errorOf("T = 25 C\nv,mu\n1,0.2\n2,0.3\n\nT = 25 C\nv,mu\n1,0.1\n4,0.2\n"),
              HasSubstr("row 8: has the velocity of row 3"));
}

TEST(FrictionData, ReadsPressureAndRelativeErrors) {
  const FrictionData data = parsed("v,mu,sigma_mu (%),pressure (kPa)\n1,0.5,4,200\n2,0.4,4,300\n");
  EXPECT_DOUBLE_EQ(data.points[0].muError, 0.02);
  EXPECT_DOUBLE_EQ(data.points[1].nominalPressure, 3e5);
}

TEST(FrictionData, SaysInWhichRowWhatIsWrong) {
  EXPECT_THAT(errorOf("velocity,mu\n1,0.2\n"), HasSubstr("1 row of numbers"));
  EXPECT_THAT(errorOf("velocity,mu\n1,0.2\n2,-0.1\n"),
              HasSubstr("row 3: the coefficient of friction is -0.1"));
  EXPECT_THAT(errorOf("velocity,mu\n0,0.2\n2,0.1\n"), HasSubstr("row 2: the velocity is 0"));
  EXPECT_THAT(errorOf("velocity,mu\n1,0.2\n1,0.3\n"),
              HasSubstr("row 3: has the velocity of row 2"));
  EXPECT_THAT(errorOf("velocity,mu,mu_error\n1,0.2,\n2,0.3,\n"),
              HasSubstr("column mu_error: the error of the coefficient of friction is missing in "
                        "all rows; take the column out"));
  EXPECT_THAT(errorOf("velocity,mu\n1,0.2+0.1i\n2,0.3+0.1i\n"),
              HasSubstr("column mu has texts where numbers are expected"));
  EXPECT_THAT(errorOf("velocity,temperature\n1,20\n2,20\n"),
              HasSubstr("no column of the coefficient of friction"));
  EXPECT_THAT(errorOf("velocity,mu,temperature\n1,0.2,20\n2,0.3,20\n"), HasSubstr("name the unit"));
  EXPECT_THAT(errorOf("velocity (furlong/h),mu\n1,0.2\n2,0.3\n"), HasSubstr("furlong/h"));
  EXPECT_THAT(errorOf("velocity,mu,normal_force,pressure (MPa)\n1,0.2,40,0.2\n2,0.3,80,0.2\n"),
              HasSubstr("both a normal force and a nominal pressure, which are not those of one "
                        "sample: their quotient is 2 to 4 cm\u00B2"));
  EXPECT_THAT(errorOf("velocity,mu\n1,hello\n2,0.3\n"), HasSubstr("mine.csv"));
  EXPECT_THAT(errorOf(""), HasSubstr("mine.csv"));
}

/// Testers state the force on the whole sample and the nominal pressure, which alone can be
/// compared with a line.
TEST(FrictionData, TakesThePressureOfASampleWhoseForceIsGivenToo) {
  const FrictionData data = parseFrictionData(
      "v (m/s),Normal force (N),Friction force (N),Pressure (MPa)\n"
      "0.01,40.2,20.1,0.2\n0.1,79.6,39.8,0.4\n1,79.9,47.94,0.4\n",
      "mine.csv");
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_DOUBLE_EQ(data.points[0].mu, 0.5);
  EXPECT_DOUBLE_EQ(data.points[2].mu, 0.6);
  EXPECT_DOUBLE_EQ(data.points[1].nominalPressure, 0.4e6);
  EXPECT_TRUE(std::isnan(data.points[1].normalForce));
  EXPECT_THAT(data.notes.back().english(), HasSubstr("on a sample of 2.01 cm\u00B2, is not used"));
}

/// One lost value takes no other row with it.
TEST(FrictionData, LeavesOutRowsWithoutFriction) {
  for (const char* lost : {"", "NaN", "--"}) {
    const FrictionData data =
        parsed("velocity,mu,mu_error\n1,0.2,0.01\n2," + std::string(lost) + ",0.01\n3,0.3,0.01\n");
    ASSERT_EQ(data.points.size(), 2U) << lost;
    EXPECT_EQ(data.points[1].velocity, 3) << lost;
    EXPECT_EQ(data.notes.back().english(), "rows without a value, left out: 1") << lost;
  }
  EXPECT_EQ(parsed("velocity,mu\n1,0.2\n,0.3\n3,0.3\n").points.size(), 2U);
  EXPECT_EQ(parsed("v,Fx (N),Fz (N)\n1,15,30\n2,,30\n3,18,\n4,18,30\n").points.size(), 2U);
  const FrictionData repeats = parsed("v,mu1,mu2\n1,0.2,0.3\n2,,\n3,0.4,0.6\n");
  EXPECT_NEAR(repeats.points[1].muError, 0.1, 1e-12);
  EXPECT_THAT(errorOf("velocity,mu,T (C)\n1,0.2,20\n2,,20\n"), HasSubstr("1 row of numbers"));
}

/// A lost error, load or temperature refused the whole table. Its row has that of no other.
TEST(FrictionData, LeavesOutRowsWithoutAnErrorALoadOrATemperature) {
  struct Column {
    std::string name, meaning;
  };
  for (const auto& [name, meaning] : {Column{"mu_error", "error of the coefficient of friction"},
                                      {"Fz (N)", "normal force"},
                                      {"p (kPa)", "nominal pressure"},
                                      {"T (K)", "temperature"}}) {
    const FrictionData data =
        parsed("v,mu," + name + "\n1,0.2,300\n2,0.3,\n3,0.3,NaN\n4,0.4,300\n5,0.4,300\n");
    ASSERT_EQ(data.points.size(), 3U) << name;
    EXPECT_EQ(data.points[1].velocity, 4) << name;
    EXPECT_EQ(data.notes.back().english(),
              "rows left out, because the " + meaning + " is missing: lines 3, 4");
  }
  // The error of a velocity is a note beside it.
  EXPECT_EQ(parsed("v,dv,mu\n1,0.1,0.2\n2,,0.3\n").points.size(), 2U);
}

/// Sensors of forces give friction a sign, which is the same in all rows.
TEST(FrictionData, TakesTheMagnitudeOfFrictionThatIsAllBelowZero) {
  const FrictionData data = parsed("v,mu,mu_error (%)\n1,-0.2,5\n2,,5\n3,-0.3,5\n");
  ASSERT_EQ(data.points.size(), 2U);
  EXPECT_DOUBLE_EQ(data.points[1].mu, 0.3);
  EXPECT_DOUBLE_EQ(data.points[1].muError, 0.015);
  EXPECT_EQ(data.notes.back().english(),
            "column 2: the coefficient of friction is below 0 in all rows, by a convention of "
            "signs; its magnitude is taken");
  const FrictionData repeats = parsed("v,mu1,mu2,mu3\n1,-0.2,-0.3,-0.4\n10,-0.4,-0.6,-0.8\n");
  EXPECT_DOUBLE_EQ(repeats.points[1].mu, 0.6);
  EXPECT_NEAR(repeats.points[1].muError, 0.2 / std::sqrt(3), 1e-12);
  EXPECT_THAT(errorOf("v,mu1,mu2\n1,-0.2,-0.3\n10,-0.4,0.1\n"),
              HasSubstr("the coefficient of friction is -0.25, which is not above 0"));
  // Whether the line is slid over backwards is not for the reader to decide.
  EXPECT_THAT(errorOf("v,mu\n-1,-0.2\n-2,-0.3\n"), HasSubstr("the velocity is -1"));
}

/// Forces and temperatures tell points apart.
TEST(FrictionData, OneVelocityUnderManyForcesIsASeries) {
  const FrictionData data =
      parsed("velocity,mu,normal_force\n0.1,0.5,1\n0.1,0.4,10\n0.1,0.3,100\n");
  EXPECT_EQ(data.points.size(), 3U);
}

TEST(FrictionData, AStateHasTheValuesOfItsPoint) {
  Scene scene;
  scene.load.kind = LoadKind::Indentation;
  MeasuredPoint point;
  point.velocity = 0.3;
  point.normalForce = 2;
  point.temperature = 310;
  const Scene at = sceneAtPoint(point, scene);
  EXPECT_EQ(at.load.kind, LoadKind::Force);
  EXPECT_EQ(at.load.normalForce, 2);
  EXPECT_EQ(at.sliding.velocity, 0.3);
  EXPECT_EQ(at.elastomer.temperature, 310);
  point.normalForce = kNotApplicable;
  point.nominalPressure = 2e5;
  EXPECT_EQ(sceneAtPoint(point, scene).load.kind, LoadKind::Pressure);
  EXPECT_EQ(sceneAtPoint(point, scene).load.nominalPressure, 2e5);
}

/// A test states the force on its whole sample, which is not that on one period.
TEST(FrictionData, ForcesFarFromTheLoadOfTheSceneAreNamed) {
  Scene scene;
  scene.surface.length = 0.02;
  scene.load.kind = LoadKind::Pressure;
  scene.load.nominalPressure = 2e5;
  scene.load.width = 1e-4;  // 0.4 N
  FrictionData data{"a table", {{.velocity = 1, .mu = 0.2, .normalForce = 80}}};
  const auto note = forceNote(data, scene);
  ASSERT_TRUE(note.has_value());
  EXPECT_THAT(note->english(),
              HasSubstr("a table: a normal force is that on one period of the line, so that 80 N "
                        "would be a nominal pressure of 40 MPa on the period of 20 mm times the "
                        "width of 100 \u00B5m, while the scene has 200 kPa"));
  data.points.front().normalForce = 1.1;  // less than three times the load
  EXPECT_FALSE(forceNote(data, scene).has_value());
  data.points.front().normalForce = 80;
  scene.load.kind = LoadKind::Force;
  EXPECT_FALSE(forceNote(data, scene).has_value());
}

/// A temperature that no shift reaches is that of a row, not one that the scene states.
TEST(FrictionData, NamesTheRowWhoseTemperatureHasNoShift) {
  Scene scene;
  scene.elastomer.shift.kind = ShiftKind::Table;
  scene.elastomer.shift.table = {{280, 1.0}, {300, 0.0}};
  scene.elastomer.temperature = 290;
  MeasuredPoint point;
  point.velocity = 0.3;
  point.temperature = 333.15;
  point.row = 4;
  EXPECT_EQ(errorFrom([&] { sceneAtPoint(point, scene); }),
            "elastomer.temperature: row 4 of the measured friction: 333.15 K is outside the shift "
            "table, 280 to 300 K");
  point.temperature = 300;
  EXPECT_EQ(sceneAtPoint(point, scene).elastomer.temperature, 300);
}

/// Blanks separate the numbers and stand within the names, too.
TEST(FrictionData, ReadsNamesOfSeveralWords) {
  const FrictionData data =
      parsed("velocity (mm/s) mu normal force (mN)\n10 0.2 3\n100 0.4 3\n1000 0.5 3\n");
  EXPECT_DOUBLE_EQ(data.points[0].velocity, 0.01);
  EXPECT_DOUBLE_EQ(data.points[0].normalForce, 3e-3);
  EXPECT_FALSE(data.hasErrors());
  for (const char* header : {"velocity (mm/s) coefficient of friction", "# v (mm/s) mu",
                             "# velocity (mm/s) coefficient of friction"})
    EXPECT_DOUBLE_EQ(parsed(std::string(header) + "\n10 0.2\n100 0.4\n").points[0].velocity, 0.01)
        << header;
  for (const char* header : {"velocity (mm/s) mu shear stress (kPa)", "velocity (mm/s) of the sled",
                             "velocity (mm/s) mu"})
    EXPECT_THAT(errorOf(std::string(header) + "\n10 0.2 3\n100 0.4 3\n"), HasSubstr("mine.csv"))
        << header;
}

TEST(FrictionData, ReadsFahrenheit) {
  for (const char* name :
       {"temperature (F)", "temperature_F", "T (F)", "T_F", "temperature (\u00B0F)"})
    EXPECT_NEAR(
        parsed(std::string("v (m/s),mu,") + name + "\n1,0.2,68\n2,0.3,77\n").points[0].temperature,
        293.15, 1e-9)
        << name;
  for (const char* name : {"temperature (R)", "temperature_R", "room temperature (C)"})
    EXPECT_FALSE(errorOf(std::string("v (m/s),mu,") + name + "\n1,0.2,68\n2,0.3,77\n").empty())
        << name;
}

TEST(FrictionData, ReadsThousands) {
  for (const char* text :
       {"velocity (mm/s)\tmu\n1 000\t0.2\n2 500\t0.4\n12 500\t0.5\n",
        "velocity (mm/s),mu\n\"1,000\",2e-1\n\"2,500\",4e-1\n\"12,500\",5e-1\n"}) {
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 3U) << text;
    EXPECT_DOUBLE_EQ(data.points[2].velocity, 12.5) << text;
    EXPECT_DOUBLE_EQ(data.points[2].mu, 0.5) << text;
  }
  const FrictionData unclear = parsed("velocity (mm/s);mu\n1.000;2e-1\n2.500;4e-1\n12.500;5e-1\n");
  EXPECT_THAT(unclear.notes.back().english(), HasSubstr("is taken for the decimal mark"));
}

TEST(FrictionData, RefusesBoundsAndNamesAllUnits) {
  EXPECT_THAT(errorOf("velocity,mu,mu_min,mu_max\n1,0.2,0.1,0.3\n2,0.3,0.2,0.4\n"),
              HasSubstr("column mu_min: bounds of the coefficient of friction are not read"));
  EXPECT_THAT(errorOf("v (furlongs),mu\n1,0.2\n2,0.3\n"), HasSubstr("ft/s"));
  EXPECT_EQ(parsed("v,mu,friction force (N)\n1,0.2,1\n2,0.3,1\n").notes[1].english(),
            "not used: friction force");
}

/// An error in per cent of a friction in per cent is in percentage points, as tables print both.
TEST(FrictionData, AnErrorInPerCentIsOfTheKindOfItsFriction) {
  const std::string rows = "\n1;45;2\n10;62;2\n100;81;3\n";
  for (const char* name : {"mu_error (%)", "error of mu (%)", "std", "Standardabw. (%)"}) {
    const FrictionData data = parsed("v (mm/s);mu (%);" + std::string(name) + rows);
    EXPECT_DOUBLE_EQ(data.points[0].muError, 0.02) << name;
    EXPECT_DOUBLE_EQ(data.points[2].muError, 0.03) << name;
    EXPECT_THAT(data.notes[0].english(), HasSubstr("(percentage points)")) << name;
  }
  for (const char* name :
       {"relative error (%)", "mu_error_rel (%)", "mu_error (% of mu)", "rel. error of mu (%)"}) {
    const FrictionData data = parsed("v (mm/s);mu (%);" + std::string(name) + rows);
    EXPECT_DOUBLE_EQ(data.points[0].muError, 0.009) << name;
    EXPECT_THAT(data.notes[0].english(), HasSubstr("(% of the value)")) << name;
  }
  const FrictionData shares =
      parsed("v,mu,mu_error (%),velocity_error (%)\n1,0.5,4,1\n2,0.4,4,1\n");
  EXPECT_DOUBLE_EQ(shares.points[0].muError, 0.02);
  EXPECT_THAT(shares.notes[0].english(),
              HasSubstr("error of the coefficient of friction (% of the value)"));
  EXPECT_DOUBLE_EQ(parsed("v,mu,relative error\n1,0.5,0.04\n2,0.4,0.04\n").points[0].muError, 0.02);
}

TEST(FrictionData, FrictionAboveAllRubbersNeedsAUnit) {
  EXPECT_THAT(errorOf("v (mm/s);mu\n1;45\n10;62\n"),
              HasSubstr("the coefficients of friction are 45 to 62; name their unit"));
  EXPECT_DOUBLE_EQ(parsed("v,mu (1)\n1,6\n2,7\n").points[0].mu, 6);
  EXPECT_DOUBLE_EQ(parsed("v,mu\n1,4.5\n2,6\n").points[1].mu, 6);
}

/// The symbols of tyre engineers for the load and the temperature of the rubber.
TEST(FrictionData, ReadsLoadsByTheirSymbols) {
  const auto first = [](const std::string& name, const std::string& value) {
    return parsed("v (m/s);mu;" + name + "\n1;0,5;" + value + "\n2;0,4;" + value + "\n").points[0];
  };
  for (const char* name :
       {"Fz (N)", "F_z [N]", "F_N (N)", "Fn_N", "F (N)", "load (N)", "Belastung (N)", "Kraft (N)"})
    EXPECT_DOUBLE_EQ(first(name, "50").normalForce, 50) << name;
  for (const char* name : {"sigma_N (MPa)", "sigma (MPa)", "p_nom (MPa)", "p (MPa)",
                           "\u03C3_N [MPa]", "Normalspannung (MPa)"})
    EXPECT_DOUBLE_EQ(first(name, "0,3").nominalPressure, 3e5) << name;
  for (const char* name : {"T_rubber (\u00B0C)", "T (\u00B0C)", "T_sample [\u00B0C]"})
    EXPECT_DOUBLE_EQ(first(name, "20").temperature, 293.15) << name;
}

/// FN is a symbol of the normal force, not femtonewtons, also where a unit stands after it.
TEST(FrictionData, ReadsNamesWithTheirSymbol) {
  for (const char* name : {"Normalkraft FN", "Normalkraft Fn", "Normal load Fn", "Load FN",
                           "load_FN", "Normalkraft FN [N]", "Normal force F_N (N)", "FN", "FN (N)"})
    EXPECT_DOUBLE_EQ(parsed("v (mm/s);mu;" + std::string(name) + "\n1;0,5;30\n10;0,7;30\n")
                         .points[0]
                         .normalForce,
                     30)
        << name;
  for (const char* line :
       {"Normal force FN = 30 N", "Normalkraft (FN): 30 N", "Normalkraft F_N: 30 N",
        "Normal force [kN]: 30 N", "FN: 30 N", "Normalkraft FN [N]: 30"})
    EXPECT_DOUBLE_EQ(
        parsed(std::string(line) + "\nv (mm/s);mu\n1;0,5\n10;0,7\n").points[0].normalForce, 30)
        << line;
}

TEST(FrictionData, AsksWhatAColumnNamedSIs) {
  for (const char* names : {"v (m/s),mu,s", "v,mu,s\nm/s,-,-"})
    EXPECT_THAT(errorOf(std::string(names) + "\n1,0.2,0.01\n2,0.3,0.01\n"),
                HasSubstr("column s: is it the standard deviation"));
  EXPECT_EQ(parsed("t,v,mu\ns,m/s,1\n1,1,0.2\n2,2,0.3\n").points.size(), 2U);
}

TEST(FrictionData, KnowsMoreNames) {
  for (const char* names :
       {"v [mm/s];Reibwert \u00B5;F_N [N]", "v [mm/s];Reibungszahl \u03BC;Carico normale [N]",
        "Sliding Speed [mm/s];Friction Factor;Normaalkracht [N]"}) {
    const FrictionData data = parsed(std::string(names) + "\n1;0,4;50\n10;0,5;50\n");
    ASSERT_EQ(data.points.size(), 2U) << names;
    EXPECT_EQ(data.points[0].mu, 0.4);
    EXPECT_EQ(data.points[0].normalForce, 50);
  }
}

/// A load or temperature that is not understood is refused; other forces and stresses are left out.
TEST(FrictionData, RefusesLoadsAndTemperaturesThatMayBeMeant) {
  for (const char* name : {"T_track (\u00B0C)", "T_road (\u00B0C)", "T_air [K]"})
    EXPECT_THAT(errorOf("v (m/s),mu," + std::string(name) + "\n1,0.2,20\n2,0.3,20\n"),
                HasSubstr("is it the temperature of the rubber, and not of the track"))
        << name;
  EXPECT_THAT(errorOf("v (m/s),mu,Gewicht (N)\n1,0.2,20\n2,0.3,20\n"),
              HasSubstr("column Gewicht: is it the normal force?"));
  for (const char* names : {"v (mm/s);Load 1 (N);Load 2 (N);mu", "v (mm/s);Load 1;Load 2;mu"})
    EXPECT_THAT(errorOf(std::string(names) + "\n1;20;30;0.5\n10;20;30;0.6\n"),
                HasSubstr("columns Load 1 and Load 2: each may be the normal force; give one such "
                          "column, and a row for each measurement of mu"));
  EXPECT_THAT(errorOf("v (m/s),mu,inflation (bar)\n1,0.2,2\n2,0.3,2\n"),
              HasSubstr("column inflation: is it the nominal pressure?"));
  for (const char* name :
       {"Fx (N)", "F_t (N)", "Ft (N)", "Reibkraft (N)", "tau (MPa)", "shear stress (kPa)",
        "G' (MPa)", "u(T) (K)", "dF (N)", "w (mm)", "n (rpm)", "t (s)", "F (Hz)"}) {
    const FrictionData data = parsed("v (m/s),mu," + std::string(name) + "\n1,0.2,20\n2,0.3,20\n");
    EXPECT_TRUE(std::isnan(data.points[0].normalForce)) << name;
    ASSERT_EQ(data.notes.size(), 2U) << name;
    EXPECT_THAT(data.notes[1].english(), testing::StartsWith("not used: ")) << name;
  }
  const FrictionData both =
      parsed("v (m/s),mu,Fz (N),F (N),T_track (C),T (C)\n1,0.2,20,4,30,20\n2,0.3,20,6,30,20\n");
  EXPECT_DOUBLE_EQ(both.points[0].normalForce, 20);
  EXPECT_DOUBLE_EQ(both.points[0].temperature, 293.15);
  EXPECT_EQ(both.notes[1].english(), "not used: F, T_track");
}

/// Loads, temperatures and means under the names of test benches.
TEST(FrictionData, ReadsUsualNamesOfTestBenches) {
  const auto first = [](const std::string& name) {
    return parsed("v (mm/s);mu;" + name + "\n1;0.5;25\n10;0.7;25\n").points[0];
  };
  for (const char* name :
       {"Vertical force Fz [N]", "Vertical load (N)", "Normal force F_N (N)", "Fz mean (N)"})
    EXPECT_DOUBLE_EQ(first(name).normalForce, 25) << name;
  EXPECT_DOUBLE_EQ(first("Radlast [kN]").normalForce, 25e3);
  EXPECT_DOUBLE_EQ(first("Contact pressure pN [kPa]").nominalPressure, 25e3);
  for (const char* name :
       {"Pr\u00FCftemperatur [\u00B0C]", "Test temperature [\u00B0C]", "Temperatur Gummi [\u00B0C]",
        "Temperature (rubber) [\u00B0C]", "Temperature T (\u00B0C)"})
    EXPECT_DOUBLE_EQ(first(name).temperature, 298.15) << name;
  EXPECT_DOUBLE_EQ(
      parsed("Pr\u00FCftemperatur: 25 \u00B0C\nVertical load: 5 N\nv;mu\n1;0,5\n2;0,6\n")
          .points[0]
          .temperature,
      298.15);
  for (const char* names : {"mu mean;mu std", "mu;mu std (n=3)", "mu;mu_err (1 sigma)",
                            "mu (mean);std", "mu;mu_err (k=1)", "mean mu;mu std (N = 10)"}) {
    const FrictionData data =
        parsed("v [mm/s];" + std::string(names) + "\n1;0,60;0,05\n10;0,80;0,07\n");
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.8) << names;
    EXPECT_DOUBLE_EQ(data.points[1].muError, 0.07) << names;
  }
  EXPECT_EQ(parsed("v;mu;mu mean\n1;0,60;0,05\n10;0,80;0,07\n").notes[1].english(),
            "not used: mu mean");
}

/// Tracks tell repeated velocities apart, also beside other labels.
TEST(FrictionData, TracksAreLabels) {
  const FrictionData data =
      parsed("Track;v [mm/s];mu\nwet asphalt;1;0,5\nwet asphalt;10;0,7\ndry concrete;10;0,9\n");
  EXPECT_EQ(data.points[2].label, "dry concrete");
  const FrictionData both =
      parsed("Sample;Track;v [mm/s];mu\nA;wet;1;0,5\nA;wet;10;0,7\nA;dry;10;0,9\n");
  EXPECT_EQ(both.points[2].label, "A, dry");
  EXPECT_EQ(parsed("v;mu;Track (m)\n1;0,6;5\n10;0,8;5\n").points[0].label, "");
}

/// The time does not rise with the square of the rows: a recording may have many.
TEST(FrictionData, ReadsALongRecordingInTime) {
  std::string text = "v (m/s),mu,T (C)\n";
  for (int i = 0; i < 60000; ++i)
    text += fmt::format("{},0.5,{}\n", 1e-3 * (1 + i % 30000), 20 + 1e-3 * (i / 2));
  const double begin = threadSeconds();
  EXPECT_EQ(parsed(text).points.size(), 60000U);
  EXPECT_LT(threadSeconds() - begin, 4);
  EXPECT_THAT(errorOf(text + "0.001,0.6,20\n0.002,0.6,20\n"),
              HasSubstr("row 60002: has the velocity of row 2, 0.001 m/s"));
}

/// One point a hundred times too high or too low is named; a steep or noisy curve is not.
TEST(FrictionData, NamesAPointWithASlipOfItsDecimalMark) {
  const auto text = [](std::size_t wrong, double factor) {
    std::string rows = "v (m/s),mu,normal_force (N)\n";
    for (const double force : {1.0, 2.0})
      for (std::size_t i = 0; i < 7; ++i) {
        const double x = 0.5 * static_cast<double>(i) - 2;
        const double mu = std::pow(10, -0.4 * x * x) * (i == wrong && force == 2 ? factor : 1);
        rows += std::to_string(std::pow(10, x)) + "," + std::to_string(mu) + "," +
                std::to_string(force) + "\n";
      }
    return rows;
  };
  for (const double factor : {100.0, 0.01}) {
    const FrictionData data = parsed(text(4, factor));
    ASSERT_EQ(data.notes.size(), 2U);
    EXPECT_THAT(data.notes[1].english(), HasSubstr("row 13: the coefficient of friction "));
    EXPECT_THAT(data.notes[1].english(), HasSubstr("is its decimal mark right?"));
  }
  EXPECT_EQ(parsed(text(4, 1)).notes.size(), 1U);
  EXPECT_EQ(parsed(text(4, 2)).notes.size(), 1U);
  EXPECT_EQ(parsed(text(0, 100)).notes.size(), 1U);
}

/// Errors that are not one standard error have a factor in their name.
TEST(FrictionData, ReadsScalesOfErrors) {
  const auto errorAt = [](const std::string& name, const char* value) {
    const FrictionData data =
        parsed("v [mm/s];mu;" + name + "\n1;0.5;" + value + "\n10;0.7;" + value + "\n");
    return data.points[0].muError;
  };
  for (const char* name : {"95% CI", "CI95", "U95", "mu error (95 %)"})
    EXPECT_DOUBLE_EQ(errorAt(name, "0.196"), 0.196 / 1.96) << name;
  for (const char* name : {"\u00B12\u03C3", "2*std", "2 sigma", "expanded uncertainty mu (k = 2)",
                           "mu_error (2 sigma)", "erweiterte Messunsicherheit (k=2)", "U(mu) (k=2)",
                           "u_mu [k=2]", "mu_err (k=2)"})
    EXPECT_DOUBLE_EQ(errorAt(name, "0.1"), 0.05) << name;
  EXPECT_DOUBLE_EQ(errorAt("3 sigma", "0.3"), 0.3 / 3);
  EXPECT_DOUBLE_EQ(errorAt("RSD %", "5"), 0.025);
  EXPECT_DOUBLE_EQ(errorAt("CV (%)", "5"), 0.025);
  EXPECT_DOUBLE_EQ(errorAt("SEM", "0.1"), 0.1);
  EXPECT_DOUBLE_EQ(errorAt("variance", "0.0004"), 0.02);
  EXPECT_THAT(parsed("v,mu,95% CI\n1,0.5,0.1\n2,0.6,0.1\n").notes[0].english(),
              HasSubstr("divided by 1.96 for one standard error"));
  for (const char* name : {"range", "Spannweite", "expanded uncertainty", "CI95 (%)"})
    EXPECT_THAT(errorOf("v,mu," + std::string(name) + "\n1,0.5,0.1\n2,0.6,0.1\n"),
                HasSubstr("how many standard errors"))
        << name;
  EXPECT_THAT(errorOf("v,mu,upper error,lower error\n1,0.5,0.1,0.1\n2,0.6,0.1,0.1\n"),
              HasSubstr("bounds of the"));
  // The points are means, whose error is that of the mean.
  for (const char* names : {"SD,SEM", "std dev,standard error"})
    EXPECT_DOUBLE_EQ(parsed("v,mu," + std::string(names) + "\n1,0.5,0.1,0.02\n2,0.6,0.1,0.02\n")
                         .points[0]
                         .muError,
                     0.02)
        << names;
  EXPECT_DOUBLE_EQ(parsed("v,mu,SEM,SD\n1,0.5,0.02,0.1\n2,0.6,0.02,0.1\n").points[0].muError, 0.02);
  // Beside a plain error the others are not needed.
  EXPECT_DOUBLE_EQ(parsed("v,mu,95% CI,std\n1,0.5,0.1,0.02\n2,0.6,0.1,0.02\n").points[0].muError,
                   0.02);
}

TEST(FrictionData, ReadsFrictionInNewtonsAsForce) {
  const FrictionData data = parsed("v (mm/s),Friction (N),Load (N)\n1,25,50\n10,30,50\n");
  EXPECT_DOUBLE_EQ(data.points[1].mu, 0.6);
  EXPECT_DOUBLE_EQ(data.points[1].normalForce, 50);
  EXPECT_THAT(errorOf("v (mm/s),Friction (N)\n1,25\n10,30\n"),
              HasSubstr("a force of friction without a normal force"));
}

TEST(FrictionData, RefusesAForceOfFrictionAsLoad) {
  EXPECT_THAT(errorOf("v (mm/s),mu,F (N)\n0.1,0.31,9.3\n1,0.52,15.6\n10,0.74,22.2\n"),
              HasSubstr("column F: the force is proportional to the coefficient of friction"));
  EXPECT_EQ(parsed("v,mu,F (N)\n1,0.31,9\n2,0.31,9\n3,0.31,9\n").points.size(), 3U);
}

TEST(FrictionData, ReadsNamesInOtherLanguages) {
  for (const char* names :
       {"Vitesse (mm/s);Coefficient de frottement;\u00C9cart-type",
        "Velocit\u00E0 (mm/s);Coefficiente di attrito;std",
        "Velocidad (mm/s);Coeficiente de fricci\u00F3n;std",
        "\u3059\u3079\u308A\u901F\u5EA6 (mm/s);\u6469\u64E6\u4FC2\u6570;std",
        "Gleitgeschw. [mm/s];Reibwert \u00B5 [-];Stabw.", "v_gleit in mm/s;mu_mittel;std"}) {
    const MeasuredPoint point =
        parsed(std::string(names) + "\n1;0,5;0,02\n10;0,7;0,02\n").points[0];
    EXPECT_DOUBLE_EQ(point.velocity, 1e-3) << names;
    EXPECT_DOUBLE_EQ(point.muError, 0.02) << names;
  }
  for (const char* name :
       {"Friction_coeff", "Friction coeff.", "Coeff. of friction", "friction coef"})
    EXPECT_DOUBLE_EQ(parsed("v," + std::string(name) + "\n1,0.4\n2,0.6\n").points[1].mu, 0.6)
        << name;
  EXPECT_DOUBLE_EQ(parsed("v,mu_s,mu_k\n1,0.4,0.3\n2,0.6,0.5\n").points[0].mu, 0.3);
}

/// A number that stands for a missing value is no measurement, and neither is one in another unit
/// than its column states.
TEST(FrictionData, RefusesWhatNoTestOfRubberReaches) {
  EXPECT_THAT(errorOf("v,mu\n1,1E+38\n2,0.4\n3,0.5\n"),
              HasSubstr("row 2: the coefficient of friction is 1e38, which no test"));
  EXPECT_THAT(errorOf("v,mu\n1,0.3\n2,0.4\n3,9999\n"),
              HasSubstr("row 4: the coefficient of friction is 9999, which no test"));
  EXPECT_THAT(errorOf("v,mu\n1E+38,0.3\n2,0.4\n"), HasSubstr("row 2: the velocity is 1e38 m/s"));
  EXPECT_THAT(errorOf("v,mu,T (C)\n1,0.3,298.15\n2,0.4,298.15\n"),
              HasSubstr("row 2: the temperature is 571.3 K, which no test"));
  EXPECT_THAT(errorOf("v,mu,T (K)\n1,0.3,25\n2,0.4,25\n"),
              HasSubstr("row 2: a temperature of 25 K is too cold for rubber"));
  // Silicone is tested at 250 °C; 293 is a temperature in K.
  EXPECT_DOUBLE_EQ(parsed("v,mu,T (C)\n1,0.3,250\n2,0.4,250\n").points[0].temperature, 523.15);
  EXPECT_THAT(errorOf("v,mu,T (C)\n1,0.3,293\n2,0.4,293\n"), HasSubstr("row 2: the temperature"));
  EXPECT_THAT(errorOf("v,mu,F (N)\n1,0.3,1E+38\n2,0.4,5\n"),
              HasSubstr("the normal force is 1e38 N"));
  EXPECT_THAT(errorOf("v (Mm/s),mu\n1,0.3\n2,0.4\n"), HasSubstr("the unit Mm/s is unknown"));
  EXPECT_EQ(parsed("v,mu,T (C)\n1e9,4,240\n2e9,4,240\n").points.size(), 2U);
}

/// The velocity beside a slip is that of a wheel, where its name does not say otherwise.
TEST(FrictionData, RefusesAVelocityBesideASlip) {
  for (const char* slip : {"slip (%)", "Slip angle (deg)", "slip", "Schlupf [%]", "slip ratio"})
    EXPECT_THAT(errorOf("V (km/h)," + std::string(slip) + ",mu\n30,2,0.3\n60,2,0.4\n"),
                HasSubstr("with a slip, the velocity of sliding may not be that of column V"))
        << slip;
  EXPECT_DOUBLE_EQ(parsed("v_slide (m/s),slip (%),mu\n1,2,0.3\n2,2,0.4\n").points[0].velocity, 1);
  // Of two velocities that of sliding is read.
  EXPECT_DOUBLE_EQ(
      parsed("V (km/h),v_slip (m/s),slip (%),mu\n30,1,2,0.3\n60,2,2,0.4\n").points[0].velocity, 1);
  EXPECT_THAT(errorOf("V (km/h),v (m/s),mu\n30,1,0.3\n60,2,0.4\n"),
              HasSubstr("has two columns of the velocity: V and v"));
}

/// A slip above the table holds for all rows.
TEST(FrictionData, RefusesAVelocityBelowASlip) {
  for (const char* line : {"Slip angle [deg]: 15", "Slip angle: 15 deg", "# slip = 7 %",
                           "Schlupf: 10 %", "Schr\u00E4glaufwinkel = 5", "Slip ratio 0.1"})
    EXPECT_THAT(errorOf(std::string(line) + "\nV (km/h),mu\n30,0.3\n60,0.4\n"),
                HasSubstr("line 1: with a slip, the velocity of sliding may not be that of"))
        << line;
  for (const char* line :
       {"Slip angle: 15 deg", "Stick-slip: 2 of 5 tests", "Slip: none", "Slip distance: 40 mm"})
    EXPECT_DOUBLE_EQ(
        parsed(std::string(line) + "\nsliding speed (m/s),mu\n1,0.3\n2,0.4\n").points[0].velocity,
        1)
        << line;
  for (const char* line : {"Stick-slip: 2 of 5 tests", "Slip: none", "Slip distance: 40 mm"})
    EXPECT_EQ(parsed(std::string(line) + "\nv (m/s),mu\n1,0.3\n2,0.4\n").points.size(), 2U) << line;
  EXPECT_THAT(errorOf("Slip angle: 15 deg\nv = 10 km/h\nmu,FN (N)\n0.2,5\n0.3,6\n"),
              HasSubstr("line 1: with a slip, the velocity of sliding is not the one above"));
}

/// Spreadsheets have empty columns at both sides, and rows of means below.
TEST(FrictionData, ReadsTablesOfSpreadsheets) {
  for (const char* text :
       {";v;\u00B5;remark\n;[mm/s];[-];\n;1;0,3;\n;10;0,4;\n;100;0,5;\nMean;;0,4;\n",
        ";v (mm/s);\u00B5\n;1;0,3\n;10;0,4\n;100;0,5\nMean;;0,4\n",
        ";;;\nTest "
        "A;;;\n;;;\n;v;\u00B5;remark\n;;;\n;mm/s;1;\n;1;0,3;\n;10;0,4;good\n;100;0,5;\n"}) {
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 3U) << text;
    EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01) << text;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.4) << text;
  }
}

/// Merged cells of a spreadsheet are empty but for the first one.
TEST(FrictionData, ReadsLoadsAndTemperaturesOfGroups) {
  const FrictionData data = parsed(
      "T (C);F (N);v;mu\n5;10;1;0.2\n;;10;0.3\n;20;1;0.3\n;;10;0.4\n25;10;1;0.1\n;;10;0.2\n");
  ASSERT_EQ(data.points.size(), 6U);
  EXPECT_DOUBLE_EQ(data.points[3].temperature, 278.15);
  EXPECT_DOUBLE_EQ(data.points[3].normalForce, 20);
  EXPECT_DOUBLE_EQ(data.points[5].temperature, 298.15);
  EXPECT_DOUBLE_EQ(data.points[5].normalForce, 10);
  EXPECT_EQ(data.notes[1].english(),
            "F stands in the first row of each group alone: it holds for the rows below it");
  // One that is missing among others is that of no other row.
  EXPECT_EQ(parsed("T (C);v;mu\n5;1;0.2\n;2;0.3\n5;3;0.3\n5;4;0.3\n").points.size(), 3U);
}

TEST(FrictionData, ReadsKineticAndNotStaticFriction) {
  for (const char* names : {"Static COF,Kinetic COF", "\u00B5 Haft,\u00B5 Gleit", "\u00B5s,\u00B5d",
                            "us,COF kinetic", "static friction,Coefficient of kinetic friction"})
    EXPECT_DOUBLE_EQ(parsed("v," + std::string(names) + "\n1,0.4,0.3\n2,0.6,0.5\n").points[0].mu,
                     0.3)
        << names;
  EXPECT_THAT(errorOf("v,static COF\n1,0.4\n2,0.6\n"),
              HasSubstr("has no column of the coefficient of friction"));
  EXPECT_DOUBLE_EQ(parsed("v,Tangential force (N),Charge (N)\n1,15,30\n2,18,30\n").points[0].mu,
                   0.5);
}

/// A slip of a unit in friction or in a force shows where the table has all three.
TEST(FrictionData, SaysThatFrictionContradictsItsForces) {
  const FrictionData data =
      parsed("v (m/s),mu,Fx (N),Fz (N)\n1,0.02,-10,50\n2,0.03,15,50\n3,0.04,21,50\n");
  EXPECT_DOUBLE_EQ(data.points[0].mu, 0.02);
  EXPECT_EQ(data.notes.back().english(),
            "column mu contradicts the forces: in the median it is 0.1 times the force of friction "
            "in column Fx over the normal force; it is read as the coefficient of friction");
  EXPECT_THAT(parsed("Load: 50 N\nv (m/s),mu,Friction force (mN)\n1,0.2,10\n2,0.3,15\n")
                  .notes.back()
                  .english(),
              HasSubstr("it is 1000 times the force of friction in column Friction force"));
  for (const char* agreeing : {"v (m/s),mu,Fx (kN),Fz (N)\n1,0.2,0.01,50\n2,0.3,0.0155,50\n",
                               "v (m/s),mu,Fx (V),Fz (N)\n1,0.2,1,50\n2,0.3,1,50\n",
                               "v (m/s),mu,Fx (N)\n1,0.2,1\n2,0.3,1\n"})
    EXPECT_THAT(parsed(agreeing).notes.back().english(), testing::StartsWith("not used: Fx"));
}

/// Load cells give compression a sign, which is the same in all rows.
TEST(FrictionData, TakesTheMagnitudeOfLoadsThatAreAllBelowZero) {
  const FrictionData forces = parsed("v,Fx (N),Fz (N)\n1,15,-30\n2,-18,-30\n");
  EXPECT_DOUBLE_EQ(forces.points[1].mu, 0.6);
  EXPECT_DOUBLE_EQ(forces.points[1].normalForce, 30);
  EXPECT_EQ(forces.notes.back().english(),
            "column 3: the normal force is below 0 in all rows, by a convention of signs; its "
            "magnitude is taken");
  EXPECT_DOUBLE_EQ(parsed("v,mu,Fz (N)\n1,0.5,-30\n2,0.6,-30\n").points[0].normalForce, 30);
  const FrictionData pressures = parsed("v,mu,p (kPa)\n1,0.5,-200\n2,0.6,-300\n");
  EXPECT_DOUBLE_EQ(pressures.points[1].nominalPressure, 3e5);
  EXPECT_THAT(errorOf("v,mu,Fz (N)\n1,0.5,30\n2,0.6,-30\n"),
              HasSubstr("row 3: the normal force is -30, which is not above 0"));
}

TEST(FrictionData, ReadsRepeatsAndForces) {
  const FrictionData repeats = parsed("v,mu1,mu2,mu3\n1,0.2,0.3,0.4\n10,0.4,0.6,0.8\n");
  EXPECT_DOUBLE_EQ(repeats.points[1].mu, 0.6);
  EXPECT_NEAR(repeats.points[1].muError, 0.2 / std::sqrt(3), 1e-12);
  // The scatter of each row says less than that of all rows; an error of the mean counts.
  for (const char* scatter : {"SD", "RSD (%)", "Stabw.", "s(mu)"}) {
    const FrictionData data = parsed("v,mu1,mu2,mu3,mean," + std::string(scatter) +
                                     "\n1,0.2,0.3,0.4,0.3,0.1\n10,0.4,0.6,0.8,0.6,0.2\n");
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.6) << scatter;
    EXPECT_NEAR(data.points[1].muError, 0.2 / std::sqrt(3), 1e-12) << scatter;
    EXPECT_THAT(data.notes.back().english(), testing::StartsWith("not used: mean, ")) << scatter;
  }
  for (const char* error : {"mu_error", "u(mu)", "standard error"})
    EXPECT_DOUBLE_EQ(parsed("v,mu1,mu2,mu3," + std::string(error) +
                            "\n1,0.2,0.3,0.4,0.01\n10,0.4,0.6,0.8,0.02\n")
                         .points[1]
                         .muError,
                     0.02)
        << error;
  EXPECT_EQ(parsed("Run,v,mu\n1,1,0.3\n2,1,0.32\n1,10,0.5\n").points.size(), 3U);
  const FrictionData forces = parsed("v,Fx (N),Fz (N)\n1,-15,30\n2,18,30\n");
  EXPECT_DOUBLE_EQ(forces.points[0].mu, 0.5);
  EXPECT_DOUBLE_EQ(forces.points[0].normalForce, 30);
  EXPECT_EQ(parsed("v,mu\n1,0.3\n,\n2,0.4\n").points.size(), 2U);
}

/// Friction at several temperatures or loads side by side is a series for each.
TEST(FrictionData, ReadsStatesSideBySide) {
  struct Names {
    std::string first, second;
    double kelvin;
    std::string unit = "\u00B0C";
  };
  for (const auto& [first, second, kelvin, unit] :
       {Names{"mu 5\u00B0C", "mu 25\u00B0C", 298.15},
        {"mu_5C", "mu_25C", 298.15, "C"},
        {"mu@5\u00B0C", "mu@25\u00B0C", 298.15},
        {"\u00B5 @ 20 \u00B0C", "\u00B5 @ 40 \u00B0C", 313.15},
        {"mu 20 \u00B0C", "mu 40 \u00B0C", 313.15},
        {"COF (-20 \u00B0C)", "COF (-5 \u00B0C)", 268.15},
        {"Reibwert bei 20 \u00B0C", "Reibwert bei 40 \u00B0C", 313.15},
        {"mu (T=293 K)", "mu (T=313 K)", 313, "K"},
        {"mu 5 \u00B0C", "mu 313.15 K", 313.15, "K"}}) {
    const FrictionData data = parsed("v," + first + "," + second + "\n1,0.3,0.2\n2,0.4,0.3\n");
    ASSERT_EQ(data.points.size(), 4U) << first;
    EXPECT_DOUBLE_EQ(data.points[2].velocity, 1) << first;
    EXPECT_DOUBLE_EQ(data.points[2].mu, 0.2) << first;
    EXPECT_NEAR(data.points[2].temperature, kelvin, 1e-9) << first;
    EXPECT_EQ(data.points[3].row, 3) << first;
    EXPECT_EQ(data.notes.size(), 1U) << first;
    EXPECT_THAT(data.notes[0].english(),
                HasSubstr("in the names of the columns: temperature (" + unit + ")"));
  }
  const FrictionData loads = parsed("v,mu (0.2 N),mu (1 N)\n1,0.3,\n2,0.4,0.3\n");
  ASSERT_EQ(loads.points.size(), 3U);
  EXPECT_DOUBLE_EQ(loads.points[0].normalForce, 0.2);
  EXPECT_DOUBLE_EQ(loads.points[2].normalForce, 1);
  EXPECT_DOUBLE_EQ(
      parsed("v,mu (0.1 MPa),mu (0.2 MPa)\n1,0.3,0.2\n2,0.4,0.3\n").points[3].nominalPressure, 2e5);
  EXPECT_DOUBLE_EQ(parsed("v,mu 1 bar,mu 3 bar\n1,0.3,0.2\n2,0.4,0.3\n").points[0].nominalPressure,
                   1e5);
  const FrictionData errors = parsed(
      "v;T (C);mu 5 N (%);mu_error 5 N (%);mu 9 N (%);mu_error 9 N (%)\n1;20;30;1;20;2\n"
      "2;20;40;3;30;4\n");
  EXPECT_DOUBLE_EQ(errors.points[3].mu, 0.3);
  EXPECT_DOUBLE_EQ(errors.points[3].muError, 0.04);
  EXPECT_DOUBLE_EQ(errors.points[3].temperature, 293.15);
  const FrictionData cells = parsed(
      "v;mu 5 N;mu 9 N\n1;0.3 \u00B1 0.01;0.2 \u00B1 0.02\n2;0.4 \u00B1 0.03;0.3 \u00B1 0.04\n");
  EXPECT_DOUBLE_EQ(cells.points[3].muError, 0.04);
  // What is not the same in all of them is for their owner to sort.
  for (const char* unclear :
       {"v,mu 5\u00B0C,mu 25\u00B0C,T (K)\n1,0.3,0.2,300\n2,0.4,0.3,300\n",
        "v,mu 5\u00B0C,mu 9 N\n1,0.3,0.2\n2,0.4,0.3\n",
        "v,mu 5\u00B0C,mu 25\u00B0C,mu_error 5\u00B0C\n1,0.3,0.2,0.1\n2,0.4,0.3,0.1\n"})
    EXPECT_THAT(errorOf(unclear), HasSubstr("in several states side by side")) << unclear;
}

/// Loads or temperatures alone above the columns, where a line above the table names friction.
TEST(FrictionData, StatesAloneAboveColumnsOfFriction) {
  const std::string rows = "1;0,9;0,8\n10;1,0;0,9\n";
  for (const char* names :
       {"Coefficient of friction;;\nv (mm/s);5 N;10 N\n", "COF of NR\nv (mm/s);F = 5 N;F = 10 N\n",
        "Coefficient of friction at load (N)\nv (mm/s);5;10\n", "mu\nv (mm/s) \\ Fn (N);5;10\n"}) {
    SCOPED_TRACE(names);
    const FrictionData data = parsed(names + rows);
    ASSERT_EQ(data.points.size(), 4U);
    EXPECT_DOUBLE_EQ(data.points[3].normalForce, 10);
    EXPECT_DOUBLE_EQ(data.points[3].velocity, 0.01);
    EXPECT_DOUBLE_EQ(data.points[3].mu, 0.9);
    EXPECT_EQ(data.notes.size(), 1U);
  }
  const FrictionData warm = parsed("Reibwert\nv (mm/s);-5 \u00B0C;25 \u00B0C\n" + rows);
  EXPECT_DOUBLE_EQ(warm.points[0].temperature, 268.15);
  // "Friction" may be a force where the line names one.
  for (const std::string line :
       {"Friction force (N)", "Friction test (tangential force)",
        "Friction of NR\nTangential force in N", "Gleitreibung (Kraft in N)"})
    EXPECT_NE(errorOf(line + "\nv (mm/s);5 N;10 N\n" + rows), "no error") << line;
  for (const std::string names :
       {"Friction at normal force (N)\nv (mm/s);5;10\n", "Friction\nv (mm/s) \\ Force (N);5;10\n"})
    EXPECT_DOUBLE_EQ(parsed(names + rows).points[3].normalForce, 10) << names;
  // A line that names the columns among other things is kept.
  for (const std::string title :
       {"COF over v (mm/s), 5 N and 10 N, T = 40 \u00B0C", "COF over v, T = 40 \u00B0C"})
    EXPECT_DOUBLE_EQ(parsed(title + "\nv (mm/s);5 N;10 N\n" + rows).points[3].temperature, 313.15)
        << title;
  EXPECT_THAT(errorOf("v (mm/s);5 N;10 N\n" + rows),
              HasSubstr("has no column of the coefficient of friction"));
}

/// The same with velocities above the columns and a load or temperature in each row: the velocities
/// of one of them follow one another.
TEST(FrictionData, VelocitiesAboveColumnsOfFriction) {
  const std::string rows = "5;0,9;0,8\n10;1,0;0,7\n";
  for (const char* names :
       {"load (N);mu 1 mm/s;mu 10 mm/s\n", "load (N);mu v=1 mm/s;mu v=10 mm/s\n",
        "Fn (N);COF (1 mm/s);COF (10 mm/s)\n",
        "Last (N);Reibwert bei 1 mm/s;Reibwert bei 10 mm/s\n", "COF\nFn (N);1 mm/s;10 mm/s\n",
        "COF of NR\nFn (N);v = 1 mm/s;v = 10 mm/s\n",
        "Coefficient of friction at velocity (mm/s)\nFn (N);1;10\n",
        "mu\nFn (N) \\ v (mm/s);1;10\n"}) {
    SCOPED_TRACE(names);
    const FrictionData data = parsed(names + rows);
    ASSERT_EQ(data.points.size(), 4U);
    EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01);
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.8);
    EXPECT_DOUBLE_EQ(data.points[1].normalForce, 5);
    EXPECT_DOUBLE_EQ(data.points[2].velocity, 0.001);
    EXPECT_DOUBLE_EQ(data.points[2].normalForce, 10);
    EXPECT_EQ(data.points[1].row, data.points[0].row);
    EXPECT_EQ(data.points[2].row, data.points[0].row + 1);
    EXPECT_EQ(data.notes.size(), 1U);
  }
  const FrictionData warm = parsed(
      "T (\u00B0C);mu 1 mm/s;s(mu) 1 mm/s;mu 10 mm/s;s(mu) 10 mm/s\n"
      "20;0,9;0,1;0,8;0,2\n40;0,7;0,3;0,6;0,4\n");
  EXPECT_NEAR(warm.points[3].temperature, 313.15, 1e-9);
  EXPECT_DOUBLE_EQ(warm.points[3].muError, 0.4);
  // A power of ten of a unit is no velocity, and a force of friction is no friction.
  EXPECT_DOUBLE_EQ(
      parsed("v (1e-3 m/s);mu 5 \u00B0C;mu 25 \u00B0C\n1;0,3;0,2\n2;0,4;0,3\n").points[3].velocity,
      2e-3);
  EXPECT_THAT(errorOf("v (mm/s);friction force 5 N;friction force 10 N\n1;3;2\n2;4;3\n"),
              HasSubstr("has no column of the coefficient of friction"));
  // A velocity in the rows is another one.
  EXPECT_NE(errorOf("v (m/s);mu 1 mm/s;mu 10 mm/s\n" + rows), "no error");
  EXPECT_THAT(errorOf("load (N);1 mm/s;10 mm/s\n" + rows),
              HasSubstr("has no column of the coefficient of friction"));
}

TEST(FrictionData, AssumedUnitsAreNoted) {
  EXPECT_THAT(parsed("v;mu;load\n1;0,5;20\n2;0,6;20\n").notes[0].english(),
              testing::AllOf(HasSubstr("column 1: velocity (m/s, assumed)"),
                             HasSubstr("column 3: normal force (N, assumed)")));
  EXPECT_THAT(parsed("v (m/s);mu\n1;0,5\n2;0,6\n").notes[0].english(),
              HasSubstr("column 1: velocity (m/s);"));
}

TEST(FrictionData, NamesInRussianTurkishAndCzechAreRead) {
  for (const char* names :
       {"\u0421\u043A\u043E\u0440\u043E\u0441\u0442\u044C, \u043C\u043C/\u0441;"
        "\u041A\u043E\u044D\u0444\u0444\u0438\u0446\u0438\u0435\u043D\u0442 "
        "\u0442\u0440\u0435\u043D\u0438\u044F;\u041D\u0430\u0433\u0440\u0443\u0437\u043A\u0430, "
        "\u041D",
        "H\u0131z (mm/s);S\u00FCrt\u00FCnme katsay\u0131s\u0131;Normal y\u00FCk (N)",
        "Rychlost (mm/s);Sou\u010Dinitel t\u0159en\u00ED;Norm\u00E1lov\u00E1 s\u00EDla (N)"}) {
    SCOPED_TRACE(names);
    const FrictionData data = parsed(std::string(names) + "\n1;0,5;20\n2;0,6;20\n");
    EXPECT_DOUBLE_EQ(data.points[0].velocity, 1e-3);
    EXPECT_DOUBLE_EQ(data.points[0].normalForce, 20);
  }
}

TEST(FrictionData, ALoadMayBeAPressureAndAVelocityPerHour) {
  const FrictionData data = parsed("v (m/h);mu;Load (MPa)\n3,6;0,5;0,2\n7,2;0,6;0,2\n");
  EXPECT_NEAR(data.points[0].velocity, 1e-3, 1e-15);
  EXPECT_DOUBLE_EQ(data.points[0].nominalPressure, 2e5);
  for (const std::string bound : {"min", "max"})
    EXPECT_THAT(
        errorOf("v (m/s);COF (avg);COF (" + bound + ")\n1;0,5;0,4\n2;0,6;0,5\n"),
        HasSubstr("column COF " + bound + ": bounds of the coefficient of friction are not read"));
  EXPECT_DOUBLE_EQ(parsed("v (m/s);mu (\u2030)\n1;500\n2;600\n").points[0].mu, 0.5);
  for (const std::string load : {"Belastung", "Charge normale",
                                 "\u041D\u0430\u0433\u0440\u0443"
                                 "\u0437\u043A\u0430"})
    EXPECT_DOUBLE_EQ(
        parsed("v (m/s);mu;" + load + " (MPa)\n1;0,5;1\n2;0,6;1\n").points[0].nominalPressure, 1e6)
        << load;
  for (const std::string force :
       {"Normal force", "Normalkraft", "Force normale", "Norm\u00E1lov\u00E1 s\u00EDla",
        "\u041D\u043E\u0440\u043C\u0430\u043B\u044C\u043D\u0430\u044F "
        "\u0441\u0438\u043B\u0430",
        "Normal kuvvet", "\u6CD5\u5411\u529B"})
    EXPECT_NE(errorOf("v (m/s);mu;" + force + " (MPa)\n1;0,5;1\n2;0,6;1\n"), "no error") << force;
  EXPECT_NEAR(parsed("v (m/s);mu;T (deg F)\n1;0,5;68\n2;0,6;68\n").points[0].temperature, 293.15,
              1e-9);
}

TEST(FrictionData, LinesBelowTheTableAreOfAllPoints) {
  for (const char* below :
       {"Temperature: 23 \u00B0C\nLoad: 50 N\n", "Normal force;50;N\nTemperature;\u00B0C;23\n",
        "Operator: A\nDate: 2024-05-01\nWidth of sample: 20 mm\nLoad: 50 N; T = 23 \u00B0C\n"}) {
    const FrictionData data = parsed(fmt::format("v (mm/s);mu\n1;0.2\n10;0.35\n\n{}", below));
    ASSERT_EQ(data.points.size(), 2U) << below;
    EXPECT_DOUBLE_EQ(data.points[1].temperature, 296.15) << below;
    EXPECT_DOUBLE_EQ(data.points[1].normalForce, 50) << below;
  }
}

/// Returns the notes in English, each between line ends.
std::string notesOf(const FrictionData& data) {
  std::string notes = "\n";
  for (const Message& note : data.notes) notes += note.english() + "\n";
  return notes;
}

TEST(FrictionData, APressureAboveAColumnOfForcesIsNamed) {
  EXPECT_THAT(notesOf(parsed("# Nominal pressure: 2 bar\nv (m/s),mu,Fz (N)\n1,0.2,80\n2,0.3,80\n")),
              HasSubstr("line 1: the nominal pressure is not used, because a column gives the "
                        "normal force; take the column out where the line says the load"));
}

TEST(FrictionData, LinesBetweenTheRowsOfOneTable) {
  for (const char* line : {"T = {} \u00B0C;", "T = {} \u00B0C, dry", "\nSample A, T = {} \u00B0C",
                           "Load = 50 N\nTemperature: {} \u00B0C"}) {
    const std::string text =
        std::string("v (mm/s);mu\n") + line + "\n1;0.6\n10;0.8\n" + line + "\n1;0.5\n10;0.7\n";
    const FrictionData data = parsed(fmt::format(fmt::runtime(text), 5, 20));
    ASSERT_EQ(data.points.size(), 4U) << line;
    EXPECT_DOUBLE_EQ(data.points[0].temperature, 278.15) << line;
    EXPECT_DOUBLE_EQ(data.points[2].temperature, 293.15) << line;
    EXPECT_DOUBLE_EQ(data.points[3].velocity, 0.01) << line;
    EXPECT_DOUBLE_EQ(data.points[3].mu, 0.7) << line;
    EXPECT_THAT(notesOf(data), HasSubstr("have the columns of the table above them\n")) << line;
  }
}

TEST(FrictionData, TheForceOfFrictionMayHaveItsSymbolBesideIt) {
  for (const char* name : {"Reibkraft F_R [N]", "Friction force Ff (N)", "Reibungskraft FR [N]",
                           "tangential force F_t (N)", "mean friction force (N)"}) {
    const FrictionData data =
        parsed(fmt::format("v (mm/s);{};Normalkraft F_N [N]\n1;10;50\n10;-20;50\n", name));
    EXPECT_DOUBLE_EQ(data.points[0].mu, 0.2) << name;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.4) << name;
  }
}

/// Rows of velocities or temperatures below loads, velocities or temperatures.
TEST(FrictionData, HeadsOfColumnsBelowALineThatNamesFriction) {
  const FrictionData loads = parsed("COF at load (N)\nv (mm/s);5;10\n1;0.5;0.4\n10;0.7;0.6\n");
  ASSERT_EQ(loads.points.size(), 4U);
  EXPECT_DOUBLE_EQ(loads.points[2].normalForce, 10);
  EXPECT_DOUBLE_EQ(loads.points[2].mu, 0.4);
  const FrictionData corner = parsed(
      "Coefficient of friction\n;v = 1 mm/s;v = 10 mm/s\n20 \u00B0C;0.5;0.7\n40 "
      "\u00B0C;0.4;0.6\n");
  ASSERT_EQ(corner.points.size(), 4U);
  EXPECT_DOUBLE_EQ(corner.points[1].velocity, 0.01);
  EXPECT_DOUBLE_EQ(corner.points[1].temperature, 293.15);
  EXPECT_DOUBLE_EQ(corner.points[2].mu, 0.4);
  EXPECT_DOUBLE_EQ(corner.points[2].temperature, 313.15);
  for (const char* text : {"mu;5 \u00B0C;20 \u00B0C\n1 mm/s;0.6;0.5\n10 mm/s;0.8;0.7\n",
                           "COF;T (\u00B0C);\nv (mm/s);5;20\n1;0.6;0.5\n10;0.8;0.7\n"}) {
    const FrictionData data = parsed(text);
    ASSERT_EQ(data.points.size(), 4U) << text;
    EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01) << text;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.8) << text;
    EXPECT_DOUBLE_EQ(data.points[2].mu, 0.5) << text;
    EXPECT_DOUBLE_EQ(data.points[2].temperature, 293.15) << text;
  }
}

TEST(FrictionData, OneRowForEachQuantity) {
  const FrictionData data =
      parsed("v (mm/s);1;10;100\nmu;0.61;0.83;1.12\nsd;0.02;0.03;0.04\nT (\u00B0C);5;20;40\n");
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01);
  EXPECT_DOUBLE_EQ(data.points[1].mu, 0.83);
  EXPECT_DOUBLE_EQ(data.points[1].muError, 0.03);
  EXPECT_DOUBLE_EQ(data.points[2].temperature, 313.15);
  EXPECT_EQ(data.notes.back().english(),
            "the table has one row for each quantity, and its columns are the points");
}

TEST(FrictionData, NamesOfMoreLanguages) {
  for (const char* text :
       {"Velocidade (mm/s);Coeficiente de atrito;Desvio padr\u00E3o;For\u00E7a normal (N)\n",
        "\u6ED1\u52A8\u901F\u5EA6(mm/s);\u6469\u64E6\u7CFB\u6570;\u6807\u51C6\u5DEE;"
        "\u8F7D\u8377(N)\n",
        "Hastighet (mm/s);Friktionskoefficient;Standardavvikelse;Normalkraft (N)\n",
        "Pr\u0119dko\u015B\u0107 po\u015Blizgu (mm/s);Wsp\u00F3\u0142czynnik tarcia;SD;"
        "Obci\u0105\u017Cenie (N)\n"}) {
    const FrictionData data = parsed(std::string(text) + "1;0.2;0.01;50\n10;0.35;0.02;50\n");
    ASSERT_EQ(data.points.size(), 2U) << text;
    EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.01) << text;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.35) << text;
    EXPECT_DOUBLE_EQ(data.points[1].muError, 0.02) << text;
    EXPECT_DOUBLE_EQ(data.points[1].normalForce, 50) << text;
  }
}

TEST(FrictionData, OtherLinesBelowTheTableAreNotUsed) {
  const std::string rows = "v (mm/s);mu\n1;0.2\n10;0.35\n\n";
  for (const char* below :
       {"time (s);wear (mg)\n1;3\n2;4\n\nLoad: 100 N\nTemperature: 60 \u00B0C\n",
        "[1] T = 40 \u00B0C\n",
        "Test 2: Load: 10 N\n",
        "Next test: T = 60 \u00B0C\n",
        "p = 0.05\n",
        "T at the end: 25 \u00B0C\n",
        "end temperature 25 \u00B0C\n",
        "Load: 50 N (at break)\n",
        "Storage:\nT = 5 \u00B0C\n",
        "Vulcanisation: 20 min\nTemperature: 160 \u00B0C\n",
        "Load cell: 500 N\nLoad: 500 N\n",
        "Conditioning: 24 h\nT: 70 \u00B0C\n",
        "Sample 2: T = 60 \u00B0C\nLoad: 50 N\n",
        "Sample: B\nT = 60 \u00B0C\n",
        "Time: 20 min\nTemperature: 160 \u00B0C\n",
        "Temperature: 160 \u00B0C\nTime: 20 min\n",
        "T = 160 \u00B0C\nDauer: ca. 20 min\n",
        "T < 20 \u00B0C\n",
        "Date of cure: 2024-05-01\nT = 60 \u00B0C\n",
        "File: b.csv\nT = 60 \u00B0C\n"}) {
    const FrictionData data = parsed(rows + below);
    ASSERT_EQ(data.points.size(), 2U) << below;
    EXPECT_TRUE(std::isnan(data.points[0].normalForce)) << below;
    EXPECT_TRUE(std::isnan(data.points[0].temperature)) << below;
  }
  for (const char* below : {"Load: 60 N\n", "Load: 4.000 N\n", "Pressure: 0.1 MPa\n"})
    EXPECT_DOUBLE_EQ(parsed("Load: 50 N\n" + rows + below).points[0].normalForce, 50) << below;
  const FrictionData two = parsed(
      "T = 5 \u00B0C\nv (mm/s);mu\n1;0.2\n10;0.35\n\nT = 20 \u00B0C\nv "
      "(mm/s);mu\n1;0.1\n10;0.15\n\n"
      "Load: 50 N\n");
  ASSERT_EQ(two.points.size(), 4U);
  EXPECT_DOUBLE_EQ(two.points[2].temperature, 293.15);
}

TEST(FrictionData, RowsBelowOtherLinesAreNotUsed) {
  for (const char* between :
       {"----", "wet", "T = 20 \u00B0C, v in m/s", "Mean values, T = 5 \u00B0C",
        "WLF: Tref = 20 \u00B0C", "T = 5 \u00B0C", "v = 10 mm/s", "F = 3 N",
        "v = 10 mm/s; T = 20 \u00B0C"}) {
    const FrictionData data = parsed(
        fmt::format("T = 5 \u00B0C\nv (mm/s);mu\n1;0.2\n10;0.35\n{}\n5.5;0.275\n8;0.3\n", between));
    ASSERT_EQ(data.points.size(), 2U) << between;
    EXPECT_DOUBLE_EQ(data.points[1].temperature, 278.15) << between;
    EXPECT_THAT(notesOf(data), HasSubstr("\ntables of numbers that are not used: at line 6\n"))
        << between;
  }
}

TEST(FrictionData, StatesHoldUntilTheNextOne) {
  const FrictionData data = parsed(
      "T = 5 \u00B0C\nLoad: 50 N\nv (mm/s);mu\n1;0.6\n10;0.8\nT = 20 \u00B0C\n1;0.5\n10;0.7\n"
      "Load: 100 N\n1;0.4\n10;0.6\nT = 5 \u00B0C\n1;0.45\n10;0.65\n");
  ASSERT_EQ(data.points.size(), 8U);
  EXPECT_DOUBLE_EQ(data.points[2].normalForce, 50);
  EXPECT_DOUBLE_EQ(data.points[4].normalForce, 100);
  EXPECT_DOUBLE_EQ(data.points[4].temperature, 293.15);
  EXPECT_DOUBLE_EQ(data.points[6].normalForce, 100);
  EXPECT_DOUBLE_EQ(data.points[6].temperature, 278.15);
}

TEST(FrictionData, NumbersOfOtherKindsInStatesAreNotFriction) {
  for (const char* corner : {"", "v (mm/s)"}) {
    const std::string table =
        std::string("\n") + corner + ";5 N;10 N\n1 mm/s;0.05;0.07\n10 mm/s;0.06;0.08\n";
    for (const char* title :
         {"COF standard deviation", "COF max", "Static COF", "Number of COF measurements",
          "CoF test: wear depth (\u00B5m)", "Stick-slip amplitude of mu", "COF\nstd",
          "COF\nWear rate (mm3/Nm)", "COF range", "Delta COF", "COF 95% CI", "COF, rms\nrms of COF",
          "COF\nStatistic: max", "COF\nQuantity: standard deviation", "Spannweite der COF"})
      EXPECT_NE(errorOf(title + table), "no error") << title << table;
    for (const char* title : {"COF", "COF of compound A, max. speed 10 mm/s", "COF before wear",
                              "COF without stick-slip", "Reibwert, relative Feuchte 50 %",
                              "COF\nnumber of runs: 3", "Test number 12\nCOF", "Mean COF (dry)",
                              "Roughness (\u00B5m)\nCOF", "COF\nPr\u00FCfer Max M\u00FCller"})
      EXPECT_EQ(errorOf(title + table), "no error") << title << table;
  }
}

TEST(FrictionData, RowsOfQuantitiesMayHaveUnitsInTheirCells) {
  const FrictionData units =
      parsed("v (mm/s);1;10;100\nmu;0.5;0.7;0.9\nload;5 kN;5 kN;10 kN\nmu_error;5 %;5 %;5 %\n");
  ASSERT_EQ(units.points.size(), 3U);
  EXPECT_DOUBLE_EQ(units.points[2].normalForce, 10000);
  EXPECT_DOUBLE_EQ(units.points[2].muError, 0.045);
  EXPECT_NE(errorOf("Speed (m/s);1 mm/s;2 mm/s;5 mm/s\nmu;0.5;0.7;0.9\n"), "no error");
  const FrictionData texts = parsed(
      "v (mm/s);1;10;100\nmu;0.5;0.7;0.9\nstate;dry;dry;wet\nT (\u00B0C);20;20;40\nlabel;A;B;C\n");
  EXPECT_EQ(texts.points.size(), 3U);
  EXPECT_THAT(notesOf(texts), HasSubstr("label"));
}

TEST(FrictionData, ARowOfAnotherStateIsNoneOfConditions) {
  const FrictionData data = parsed(
      "T = 5 \u00B0C\nv (mm/s);mu\n1;0.5\n10;0.7\nT = 20 \u00B0C\n1;0.4\n\nwear "
      "(mm);x\n1;2\n3;4\n");
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_DOUBLE_EQ(data.points[2].temperature, 293.15);
}

TEST(FrictionData, AColumnOfFlagsIsNotFriction) {
  EXPECT_NE(errorOf("v (mm/s);mu\n1;0.5;ok\n10;0.7;ok\n100;0.9;ok\n"), "no error");
  const FrictionData data = parsed("v (m/s);mu;status\n1;0.01;0.5;ok\n2;0.1;0.6;ok\n3;1;0.7;ok\n");
  EXPECT_DOUBLE_EQ(data.points[1].velocity, 0.1);
  EXPECT_DOUBLE_EQ(data.points[1].mu, 0.6);
  for (const char* name : {"sd", "T (C)", "load (N)"})
    EXPECT_THAT(errorOf(std::string("v (mm/s);mu;") + name + "\n1;0.5;ok\n10;0.6;ok\n"),
                HasSubstr("is missing in all rows"))
        << name;
}

TEST(FrictionData, AColumnOfUnitsOfAnotherColumnIsAskedFor) {
  EXPECT_THAT(errorOf("v;Einheit;mu;Load;Einheit\n1;mm/s;0.5;5;kN\n10;mm/s;0.6;5;kN\n"),
              HasSubstr("names 'kN'"));
  EXPECT_THAT(errorOf("n;v;unit;mu\n1;1;mm/s;0.5\n2;10;mm/s;0.6\n"), HasSubstr("names 'mm/s'"));
}

TEST(FrictionData, TheExactNameOfTheForceOfFrictionPrecedesOthers) {
  for (const char* name : {"Tangential force Fx (N)", "mean friction force (N)"}) {
    const FrictionData data =
        parsed(fmt::format("{};Friction force (N);Fn (N);v (mm/s)\n5;4;10;1\n6;5;10;10\n", name));
    EXPECT_DOUBLE_EQ(data.points[0].mu, 0.4) << name;
    EXPECT_DOUBLE_EQ(data.points[1].mu, 0.5) << name;
  }
  EXPECT_DOUBLE_EQ(parsed("v (mm/s);mean mu;median mu\n1;0.2;0.21\n10;0.35;0.36\n").points[1].mu,
                   0.35);
}

}  // namespace
}  // namespace asperity
