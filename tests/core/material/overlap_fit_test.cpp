// The shift between two isotherms whose moduli are polynomials in the logarithm of frequency, which
// the fit represents exactly.
#include "core/material/overlap_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asperity {
namespace {

double curvedStorage(double x) {
  return 6 + 0.5 * x - 0.06 * x * x;
}
double curvedLoss(double x) {
  return 5 + 0.3 * x - 0.09 * x * x;
}

/// Samples two decades of curves for the moduli.
template <class Storage, class Loss>
LogSweep sampled(const Storage& storage, const Loss& loss, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  LogSweep sweep;
  for (int i = 0; i <= 20; ++i) {
    const double x = 0.1 * i - 1;
    sweep.x.push_back(x);
    sweep.storage.push_back(storage(x) + noise * normal(random));
    sweep.loss.push_back(loss(x) + noise * normal(random));
  }
  return sweep;
}

LogSweep curvedSweep(double ofStorage, double ofLoss, double noise = 0, unsigned seed = 1) {
  return sampled([&](double x) { return curvedStorage(x + ofStorage); },
                 [&](double x) { return curvedLoss(x + ofLoss); }, noise, seed);
}

/// Both moduli rise with the root of frequency.
LogSweep powerLaws(double shift, double noise = 0, unsigned seed = 1) {
  return sampled([&](double x) { return 6 + 0.5 * (x + shift); },
                 [&](double x) { return 5 + 0.5 * (x + shift); }, noise, seed);
}

LogSweep raised(LogSweep sweep, double vertical) {
  for (double& value : sweep.storage) value += vertical;
  for (double& value : sweep.loss) value += vertical;
  return sweep;
}

TEST(OverlapFit, TheCommonRangeIsThatOfBothOnTheAxisOfTheWarmer) {
  const CommonRange range = commonRange({{-1, 2}, {}, {}}, {{-2, 1.5}, {}, {}}, 0.7);
  EXPECT_DOUBLE_EQ(range.from, -0.3);
  EXPECT_DOUBLE_EQ(range.to, 1.5);
  EXPECT_LT(commonRange({{-1, 1}, {}, {}}, {{-1, 1}, {}, {}}, 3).width(), 0);
}

TEST(OverlapFit, KnownShiftsComeBackFromEachModulus) {
  const LogSweep colder = curvedSweep(0.7, 0.7), warmer = curvedSweep(0, 0);
  for (const ShiftModuli moduli : {ShiftModuli::Both, ShiftModuli::Storage, ShiftModuli::Loss})
    for (const double start : {0.5, 0.7, 0.9}) {
      const auto found = fittedShift(colder, warmer, start, {}, moduli);
      ASSERT_TRUE(found.has_value()) << start;
      EXPECT_NEAR(found->horizontal.value, 0.7, 1e-8) << start;
      EXPECT_EQ(found->vertical.value, 0);
    }
}

/// What is expected says little beside moduli that determine the vertical shift.
TEST(OverlapFit, KnownVerticalShiftsComeBackWhateverIsExpected) {
  for (const double vertical : {0.02, 0.1}) {
    const LogSweep colder = raised(curvedSweep(0.7, 0.7), vertical), warmer = curvedSweep(0, 0);
    for (const double expected : {-0.05, 0.01, 0.02, 0.03}) {
      const auto found = fittedShift(colder, warmer, 0.7, expected, ShiftModuli::Both);
      ASSERT_TRUE(found.has_value());
      EXPECT_NEAR(found->vertical.value, vertical, 1e-4) << expected;
      EXPECT_NEAR(found->horizontal.value, 0.7, 1e-3) << expected;
    }
  }
}

/// Of power laws with one exponent, only the expected vertical shift tells the two apart.
TEST(OverlapFit, PowerLawsHaveTheExpectedVerticalShift) {
  for (const double expected : {-0.03, 0.0, 0.03}) {
    const auto found = fittedShift(powerLaws(0.7), powerLaws(0), 0.7, expected, ShiftModuli::Both);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->vertical.value, expected, 1e-6);
    EXPECT_NEAR(found->horizontal.value, 0.7 - expected / 0.5, 1e-6);
  }
  // Less noise tells no more of the vertical shift of power laws, unlike that of curves.
  const auto error = [](const LogSweep& colder, const LogSweep& warmer) {
    return fittedShift(colder, warmer, 0.7, {}, ShiftModuli::Both).value().residuals.verticalError;
  };
  const auto ofPowerLaws = [&](double noise) {
    return error(powerLaws(0.7, noise, 1), powerLaws(0, noise, 2));
  };
  const auto ofCurves = [&](double noise) {
    return error(curvedSweep(0.7, 0.7, noise, 1), curvedSweep(0, 0, noise, 2));
  };
  EXPECT_NEAR(ofPowerLaws(1e-4) / ofPowerLaws(1e-3), 1, 0.1);
  EXPECT_NEAR(ofCurves(1e-4) / ofCurves(1e-3), 0.1, 0.01);
}

/// The shift from G'' less that from G'.
TEST(OverlapFit, DifferentShiftsOfTheModuliAreAContrast) {
  const auto found =
      fittedShift(curvedSweep(0.7, 0.72), curvedSweep(0, 0), 0.7, {}, ShiftModuli::Both);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->horizontal.value, 0.7);
  EXPECT_LT(found->horizontal.value, 0.72);
  EXPECT_NEAR(found->residuals.difference.value, 0.02, 0.001);
}

TEST(OverlapFit, StandardErrorsFollowTheNoise) {
  const auto error = [](double noise) {
    const auto found = fittedShift(curvedSweep(0.7, 0.7, noise, 1), curvedSweep(0, 0, noise, 2),
                                   0.7, {}, ShiftModuli::Both);
    return found.value().horizontal.standardError;
  };
  const double small = error(1e-4);
  EXPECT_GT(small, 0);
  EXPECT_NEAR(error(1e-3) / small, 10, 0.5);
}

TEST(OverlapFit, WhatDeterminesNoShiftHasNone) {
  const LogSweep sweep = curvedSweep(0, 0);
  EXPECT_FALSE(fittedShift(sweep, sweep, 3, {}, ShiftModuli::Both)) << "nothing in common";
  LogSweep plateau = sweep;
  plateau.storage.assign(sweep.x.size(), 6);
  plateau.loss.assign(sweep.x.size(), 5);
  EXPECT_FALSE(fittedShift(plateau, plateau, 0.3, {}, ShiftModuli::Both));
  const LogSweep one{{0}, {6}, {5}};
  EXPECT_FALSE(fittedShift(one, sweep, 0, {}, ShiftModuli::Both));
}

}  // namespace
}  // namespace asperity
