// The shift with temperature: its formulas and tables, and the formulas fitted to a table.
#include "core/material/temperature_shift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/input_error.h"
#include "tests/core/material/synthetic_rubber.h"

namespace asperity {
namespace {

TEST(TemperatureShift, IsTheFormulaOfWilliamsLandelAndFerry) {
  const TemperatureShift shift{4.41, 137.64, 343.15};
  EXPECT_EQ(shiftFactor(shift, 343.15), 1);
  EXPECT_NEAR(std::log10(shiftFactor(shift, 363.15)), -4.41 * 20 / 157.64, 1e-14);
  EXPECT_NEAR(std::log10(shiftFactor(shift, 300.0)), 4.41 * 43.15 / (137.64 - 43.15), 1e-13);
  EXPECT_GT(shiftFactor(shift, 300), 1);  // colder is slower
}

TEST(TemperatureShift, EndsAboveTheVogelTemperature) {
  const TemperatureShift shift{8.86, 101.6, 298.15};
  EXPECT_THROW(shiftFactor(shift, 298.15 - 101.6), InputError);
  EXPECT_THROW(shiftFactor(shift, 100), InputError);
  EXPECT_THROW(shiftFactor(shift, 298.15 - 101.5), InputError);  // 9000 decades
  EXPECT_GT(shiftFactor(shift, 298.15 - 70), 1e10);
}

/// ln a_T = E/R (1/T - 1/T_r).
TEST(TemperatureShift, ArrheniusIsItsClosedForm) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Arrhenius;
  shift.activationEnergy = 8e4;
  for (const double kelvin : {260.0, 280.0, 298.0, 330.0, 400.0})
    EXPECT_NEAR(std::log(shiftFactor(shift, kelvin)),
                8e4 / 8.31446261815324 * (1 / kelvin - 1 / 298.15), 1e-12);
  EXPECT_EQ(shiftFactor(shift, 298.15), 1);
}

TEST(TemperatureShift, ATableIsLinearBetweenItsRows) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.table = {{280, 2}, {290, 1}, {300, 0}, {320, -1}};
  EXPECT_EQ(log10ShiftFactor(shift, 290), 1);
  EXPECT_NEAR(log10ShiftFactor(shift, 285), 1.5, 1e-15);
  EXPECT_NEAR(log10ShiftFactor(shift, 315), -0.75, 1e-15);
  EXPECT_EQ(shiftFactor(shift, 300), 1);
  EXPECT_NO_THROW(shiftFactor(shift, 280));
  EXPECT_NO_THROW(shiftFactor(shift, 320));
  EXPECT_THROW(shiftFactor(shift, 279.999), InputError);
  EXPECT_THROW(shiftFactor(shift, 320.001), InputError);
}

/// -20 degrees are 253.14999999999998 K in a table of degrees, and 253.15 K in a scene.
TEST(TemperatureShift, ATableEndsWhereItsDegreesDo) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.table = {{-20 + 273.15, 0}};
  ASSERT_NE(shift.table.front().temperature, 253.15);
  EXPECT_EQ(shiftFactor(shift, 253.15), 1);
  try {
    shiftFactor(shift, 253.16);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "elastomer.temperature: 253.16 K is outside the shift table, 253.15 to 253.15 K");
  }
}

// ---- Fits

/// log10 a_T = -c1 (T - T_r) / (c2 + T - T_r), Williams, Landel and Ferry (1955).
TEST(TemperatureFit, FormulasComeBackFromTheirOwnTables) {
  std::vector<ShiftPoint> wlf, arrhenius;
  constexpr double kEnergy = 85e3, kGas = 8.31446261815324;
  for (const double kelvin : {268.15, 278.15, 288.15, 298.15, 313.15, 333.15}) {
    wlf.push_back({kelvin, SyntheticRubber::log10Shift(kelvin)});
    arrhenius.push_back({kelvin, kEnergy / kGas * (1 / kelvin - 1 / 298.15) / std::log(10.0)});
  }
  const TemperatureFit first = fitWlf(wlf, 298.15);
  EXPECT_NEAR(first.shift.c1, 8.86, 1e-3);
  EXPECT_NEAR(first.shift.c2, 101.6, 1e-2);
  EXPECT_LT(first.rms, 1e-6);
  const TemperatureFit second = fitArrhenius(arrhenius, 298.15);
  EXPECT_NEAR(second.shift.activationEnergy, kEnergy, 1e-6 * kEnergy);
  EXPECT_LT(second.rms, 1e-12);
  EXPECT_EQ(chosenShift(wlf, 298.15).kind, ShiftKind::Wlf);
  std::vector<ShiftPoint> neither{{280, 1}, {290, 0.9}, {298.15, 0}, {310, -0.05}, {320, -1}};
  EXPECT_EQ(chosenShift(neither, 298.15).kind, ShiftKind::Table);
}

/// A table has a row at its reference, so that its shift there is 0.
TEST(TemperatureFit, ATableIsZeroAtItsReference) {
  const std::vector<ShiftPoint> rows{{280, 1}, {300, -2}};
  EXPECT_EQ(tableShift(rows, 290).table, (std::vector<ShiftPoint>{{280, 1}, {290, 0}, {300, -2}}));
  EXPECT_EQ(tableShift(rows, 270).table, rows);
  const std::vector<ShiftPoint> crossing{{280, 1}, {300, -1}};
  EXPECT_EQ(tableShift(crossing, 290).table, crossing);
}

/// Measured factors may miss 0 at their own reference by a little.
TEST(TemperatureFit, ARowAtTheReferenceIsNotDoubled) {
  const std::vector<ShiftPoint> rows{{280, 1}, {290, 0.03}, {300, -2}};
  EXPECT_EQ(tableShift(rows, 290).table, (std::vector<ShiftPoint>{{280, 1}, {290, 0}, {300, -2}}));
  const std::vector<ShiftPoint> coldest{{290, -0.03}, {300, -2}};
  EXPECT_EQ(tableShift(coldest, 290).table, (std::vector<ShiftPoint>{{290, 0}, {300, -2}}));
  const std::vector<ShiftPoint> warmest{{280, 1}, {290, 0.03}};
  EXPECT_EQ(tableShift(warmest, 290).table, (std::vector<ShiftPoint>{{280, 1}, {290, 0}}));
}

}  // namespace
}  // namespace asperity
