// Time-temperature superposition: shifts from overlaps, their errors, and formulas through them.
#include "core/material/temperature_shifts.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/material/element_law.h"
#include "core/material/temperature_fit.h"
#include "tests/core/error_from.h"
#include "tests/core/material/synthetic_rubber.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// Reduced frequency f a_T with the a_T that made the sweeps.
TEST(TemperatureShifts, KnownShiftsComeBack) {
  for (const int points : {7, 15, 21}) {
    const auto isotherms = SyntheticRubber().sweeps(points);
    const MasterCurve curve = masterCurve(isotherms, 298.15);
    ASSERT_EQ(curve.shifts.size(), isotherms.size());
    for (const IsothermShift& shift : curve.shifts)
      EXPECT_NEAR(shift.log10Shift, SyntheticRubber::log10Shift(shift.temperature), 0.01)
          << points << " points at " << shift.temperature;
    EXPECT_TRUE(curve.isThermorheologicallySimple);
    EXPECT_LT(std::ranges::max(curve.overlaps, {}, &Overlap::mismatch).mismatch, 0.005);
  }
}

TEST(TemperatureShifts, StandardErrorsSayHowFarNoiseMovesThem) {
  int beyondOne = 0, beyondThree = 0, count = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const MasterCurve curve = masterCurve(SyntheticRubber().sweeps(15, 0.02, seed), 298.15);
    for (const IsothermShift& shift : curve.shifts) {
      if (shift.temperature == 298.15) continue;
      const double error = shift.log10Shift - SyntheticRubber::log10Shift(shift.temperature);
      ASSERT_GT(shift.standardError, 0);
      ++count;
      beyondOne += std::abs(error) > shift.standardError ? 1 : 0;
      beyondThree += std::abs(error) > 3 * shift.standardError ? 1 : 0;
    }
  }
  // A third of normal deviations lies beyond one standard error, a few in a thousand beyond three.
  EXPECT_NEAR(static_cast<double>(beyondOne) / count, 0.32, 0.1);
  EXPECT_LE(beyondThree, count / 100);
}

TEST(TemperatureShifts, NoiseAloneDoesNotMakeARubberComplex) {
  int complex = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    complex +=
        masterCurve(SyntheticRubber().sweeps(15, 0.02, seed), 298.15).isThermorheologicallySimple
            ? 0
            : 1;
  EXPECT_LE(complex, 1);
}

/// Loss and storage that ask for different shifts.
TEST(TemperatureShifts, DifferentShiftsOfTheModuliAreFound) {
  const SyntheticRubber rubber;
  std::vector<Isotherm> isotherms = rubber.sweeps(15, 0.005);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    for (DynamicModulus& point : isotherms[i].points) {
      const double shift = std::pow(10, SyntheticRubber::log10Shift(isotherms[i].temperature));
      const double further = std::pow(10, 0.1 * (3.0 - static_cast<double>(i)));
      point.loss = rubber.at(point.frequency * shift * further).loss;
    }
  const MasterCurve curve = masterCurve(isotherms, 298.15);
  EXPECT_FALSE(curve.isThermorheologicallySimple);
  EXPECT_NEAR(curve.largestStep, 0.1, 0.03);
}

TEST(TemperatureShifts, VerticalShiftsOfAFewPerCentComeBack) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(21);
  for (Isotherm& isotherm : isotherms)
    for (DynamicModulus& point : isotherm.points) {
      point.storage *= isotherm.temperature / 298.15;
      point.loss *= isotherm.temperature / 298.15;
    }
  const MasterCurve curve = masterCurve(isotherms, 298.15, true);
  for (const IsothermShift& shift : curve.shifts) {
    EXPECT_NEAR(shift.log10Vertical, std::log10(shift.temperature / 298.15), 0.012);
    EXPECT_NEAR(shift.log10Shift, SyntheticRubber::log10Shift(shift.temperature), 0.08);
  }
}

/// Williams, Landel and Ferry at another reference: C1' = C1 C2 / (C2 + dT), C2' = C2 + dT.
TEST(TemperatureShifts, TheReferenceMayLieBetweenIsotherms) {
  const auto isotherms = SyntheticRubber().sweeps(15);
  for (const double reference : {271.15, 303.15, 326.15}) {
    const MasterCurve curve = masterCurve(isotherms, reference);
    for (const IsothermShift& shift : curve.shifts)
      EXPECT_NEAR(
          shift.log10Shift,
          SyntheticRubber::log10Shift(shift.temperature) - SyntheticRubber::log10Shift(reference),
          0.01)
          << reference << " at " << shift.temperature;
    const TemperatureFit fit = fitWlf(shiftTable(curve), reference);
    const double above = reference - SyntheticRubber::kReference;
    EXPECT_NEAR(fit.shift.c1, 8.86 * 101.6 / (101.6 + above), 0.1) << reference;
    EXPECT_NEAR(fit.shift.c2, 101.6 + above, 1.5) << reference;
  }
}

/// Where no formula holds, the shift is linear in T between two isotherms, as in a table.
TEST(TemperatureShifts, WithoutAFormulaTheReferenceIsInterpolated) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(15);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    for (DynamicModulus& point : isotherms[i].points)
      point.frequency *= std::pow(10, i % 2 == 0 ? 0.2 : 0);
  const MasterCurve at25 = masterCurve(isotherms, 298.15), at30 = masterCurve(isotherms, 303.15);
  const double half = 0.5 * (at25.shifts[3].log10Shift + at25.shifts[4].log10Shift);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    EXPECT_NEAR(at30.shifts[i].log10Shift, at25.shifts[i].log10Shift - half, 1e-12);
}

/// A table has a row at its reference, so that its shift there is 0.
TEST(TemperatureFit, ATableIsZeroAtItsReference) {
  const std::vector<ShiftPoint> rows{{280, 1}, {300, -2}};
  EXPECT_EQ(tableShift(rows, 290).table, (std::vector<ShiftPoint>{{280, 1}, {290, 0}, {300, -2}}));
  EXPECT_EQ(tableShift(rows, 280).table, rows);
  const std::vector<ShiftPoint> crossing{{280, 1}, {300, -1}};
  EXPECT_EQ(tableShift(crossing, 290).table, crossing);
}

TEST(TemperatureShifts, TheUsualReferenceWasMeasured) {
  std::vector<Isotherm> isotherms(3);
  isotherms[0].temperature = 283.15;
  isotherms[1].temperature = 293.15;
  isotherms[2].temperature = 313.15;
  EXPECT_EQ(usualReference(isotherms), 293.15);
  // Sweeps have the mean temperature of their rows.
  isotherms[1].temperature = 297.95;
  EXPECT_EQ(usualReference(isotherms), 298.15);
  isotherms.resize(2);
  EXPECT_EQ(usualReference(isotherms), 297.95) << "25 \u00B0C is outside";
}

/// Entropy elasticity: b_T = T / T_0.
TEST(TemperatureShifts, AnEntropicRubberIsSimpleWithVerticalShifts) {
  SyntheticRubber rubber;
  rubber.equilibrium = 5e6;
  std::vector<Isotherm> isotherms = rubber.sweeps(21);
  for (Isotherm& isotherm : isotherms)
    for (DynamicModulus& point : isotherm.points) {
      point.storage *= isotherm.temperature / 298.15;
      point.loss *= isotherm.temperature / 298.15;
    }
  EXPECT_FALSE(masterCurve(isotherms, 298.15).isThermorheologicallySimple);
  EXPECT_TRUE(masterCurve(isotherms, 298.15, true).isThermorheologicallySimple);
}

TEST(TemperatureShifts, OneIsothermIsItsOwnMasterCurve) {
  const std::vector<Isotherm> one{SyntheticRubber().sweep(293.15, 0.1, 10, 9)};
  const MasterCurve curve = masterCurve(one, 293.15);
  ASSERT_EQ(curve.points.size(), 9U);
  EXPECT_EQ(curve.points.front().modulus, one.front().points.front());
  EXPECT_EQ(curve.shifts.front().log10Shift, 0);
}

TEST(TemperatureShifts, WhatCannotBeShiftedIsSaidInOneLine) {
  const SyntheticRubber rubber;
  const std::vector<Isotherm> apart{rubber.sweep(258.15, 1, 3, 5), rubber.sweep(298.15, 1, 3, 5)};
  EXPECT_THAT(errorFrom([&] { masterCurve(apart, 298.15); }), HasSubstr("do not overlap"));
  std::vector<Isotherm> swapped = rubber.sweeps(15);
  std::swap(swapped[3].points, swapped[4].points);
  EXPECT_THAT(errorFrom([&] { masterCurve(swapped, 298.15); }), HasSubstr("out of order"));
  EXPECT_THAT(errorFrom([&] { masterCurve(rubber.sweeps(15), 20); }),
              HasSubstr("--reference-temperature: 20 K is outside"));
}

// ---- Sweeps from rows
// ----------------------------------------------------------------------------

TEST(Isotherms, RowsOfAnyOrderBecomeSweeps) {
  std::vector<MeasuredModulus> rows;
  for (const double kelvin : {300.0, 280.0, 290.0})
    for (const double frequency : {10.0, 1.0, 3.0})
      rows.push_back({kelvin + 0.05 * frequency / 10, {frequency, 1e6, 1e5}});
  const auto isotherms = groupIsotherms(rows);
  ASSERT_EQ(isotherms.size(), 3U);
  EXPECT_NEAR(isotherms[0].temperature, 280.0233, 1e-3);
  EXPECT_EQ(isotherms[2].lowestFrequency(), 1);
  EXPECT_EQ(isotherms[2].highestFrequency(), 10);
}

TEST(Isotherms, EqualFrequenciesAreAveraged) {
  const auto isotherms =
      groupIsotherms({{300, {1, 1e6, 1e5}}, {300, {1, 4e6, 1e5}}, {300, {2, 3e6, 2e5}}});
  ASSERT_EQ(isotherms.front().points.size(), 2U);
  EXPECT_NEAR(isotherms.front().points.front().storage, 2e6, 1e-3);
  EXPECT_EQ(isotherms.front().repeats, 1U);
  EXPECT_NEAR(isotherms.front().repeatRatio, 4, 1e-12);
}

TEST(Isotherms, BadRowsAreSaidInOneLine) {
  EXPECT_THAT(errorFrom([] {
                groupIsotherms({{300, {1, 1e6, 1e5}}, {310, {1, 1e6, 1e5}}});
              }),
              HasSubstr("one frequency alone at"));
  EXPECT_THAT(errorFrom([] {
                groupIsotherms({{300, {1, 1e6, -1}}, {300, {2, 1e6, 1}}});
              }),
              HasSubstr("loss modulus: -1 at"));
  std::vector<MeasuredModulus> ramp;
  for (int i = 0; i < 40; ++i) ramp.push_back({280 + 0.25 * i, {1.0 + i % 3, 1e6, 1e5}});
  EXPECT_THAT(errorFrom([&] { groupIsotherms(ramp); }), HasSubstr("without a gap"));
}

// ---- Formulas
// ------------------------------------------------------------------------------------

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

/// A sweep at 25 degrees is at 298.15 K, not at a mean that rounding moved.
TEST(Isotherms, HaveTheTemperatureOfTheirRowsExactly) {
  for (int points = 2; points < 40; ++points) {
    std::vector<MeasuredModulus> rows;
    for (int i = 0; i < points; ++i) rows.push_back({298.15, {1.0 + i, 1e6, 1e5}});
    EXPECT_EQ(groupIsotherms(rows).front().temperature, 298.15) << points;
  }
}

}  // namespace
}  // namespace asperity
