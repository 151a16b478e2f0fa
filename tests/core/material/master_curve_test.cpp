// Time-temperature superposition: shifts from overlaps, and their errors.
#include "core/material/master_curve.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/input_error.h"
#include "core/material/temperature_shift.h"
#include "tests/core/error_from.h"
#include "tests/core/material/synthetic_rubber.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A rubber of which several isotherms lie on the plateau, where G' hardly rises.
SyntheticRubber flatRubber() {
  SyntheticRubber rubber;
  rubber.equilibrium = 3e6;
  return rubber;
}

/// Reduced frequency f a_T with the a_T that made the sweeps.
TEST(MasterCurve, KnownShiftsComeBack) {
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

/// A rubber of one arm per decade, whose moduli ripple along the frequency.
struct RippledRubber {
  static constexpr double kReference = 294.15;  // K
  /// Williams, Landel and Ferry with C1 = 9.2 and C2 = 118 K at 20 °C.
  static double log10Shift(double kelvin) {
    const auto law = [](double above) { return -9.2 * above / (118 + above); };
    return law(kelvin - 293.15) - law(kReference - 293.15);
  }

  /// From -35 to 69 °C in steps of 2 K, six frequencies each, with relative noise.
  static std::vector<Isotherm> sweeps(double noise, unsigned seed) {
    const std::vector<double> arms{120, 150, 160, 150, 110, 60, 20, 6, 2, 0.9, 0.5, 0.3, 0.2, 0.1};
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Isotherm> all;
    for (double kelvin = 238.15; kelvin < 343; kelvin += 2) {
      Isotherm& isotherm = all.emplace_back();
      isotherm.temperature = kelvin;
      for (const double frequency : {1, 2, 5, 10, 20, 50}) {
        DynamicModulus modulus{frequency, 0.9e6, 0};
        for (std::size_t i = 0; i < arms.size(); ++i) {
          const double turn = 2 * std::numbers::pi * frequency *
                              std::pow(10, log10Shift(kelvin) - 11 + static_cast<double>(i));
          modulus.storage += 1e6 * arms[i] * turn * turn / (1 + turn * turn);
          modulus.loss += 1e6 * arms[i] * turn / (1 + turn * turn);
        }
        modulus.storage *= 1 + noise * normal(random);
        modulus.loss *= 1 + noise * normal(random);
        isotherm.points.push_back(modulus);
      }
    }
    return all;
  }
};

/// Polynomials over two neighbours do not follow the ripples between a few frequencies, with an
/// error of one sign at every step: the sums of 20 steps were wrong by 0.24 decades, three times
/// their stated error.
TEST(MasterCurve, RipplesDoNotAddUpFromStepToStep) {
  const MasterCurve curve = masterCurve(RippledRubber::sweeps(0, 1), RippledRubber::kReference);
  EXPECT_TRUE(curve.isFittedTogether);
  for (const IsothermShift& shift : curve.shifts) {
    const double truth = RippledRubber::log10Shift(shift.temperature);
    EXPECT_NEAR(shift.log10Shift, truth, 0.005) << shift.temperature;
    EXPECT_NEAR(shift.log10Shift, truth, 2 * shift.standardError + 1e-9) << shift.temperature;
    EXPECT_LT(shift.standardError, 0.01) << shift.temperature;
    EXPECT_NEAR(shift.fromStorage, truth, 0.02) << shift.temperature;
    EXPECT_NEAR(shift.fromLoss, truth, 0.02) << shift.temperature;
  }
}

TEST(MasterCurve, StandardErrorsHoldForRipples) {
  int count = 0, beyond = 0;
  double squares = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto isotherms = RippledRubber::sweeps(0.01, seed);
    for (const IsothermShift& shift : masterCurve(isotherms, RippledRubber::kReference).shifts) {
      const double error = shift.log10Shift - RippledRubber::log10Shift(shift.temperature);
      squares += error * error;
      beyond += std::abs(error) > 2 * shift.standardError ? 1 : 0;
      ++count;
    }
  }
  EXPECT_LE(beyond, 0.1 * count) << "of " << count;
  EXPECT_LT(std::sqrt(squares / count), 0.02);
}

/// How the errors of many shifts compare with the standard errors that the program states.
struct Coverage {
  int count = 0, undetermined = 0;
  double beyondOne = 0, beyondTwo = 0, beyondThree = 0;  // shares
};

/// Of sweeps with this relative noise.
Coverage coverage(const SyntheticRubber& rubber, int points, double noise, bool isVertical,
                  bool isEntropic) {
  Coverage found;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::vector<Isotherm> isotherms = rubber.sweeps(points, noise, seed);
    if (isEntropic) makeEntropic(isotherms);
    for (const IsothermShift& shift : masterCurve(isotherms, 298.15, isVertical).shifts) {
      if (shift.temperature == 298.15) continue;
      const double error =
          std::abs(shift.log10Shift - SyntheticRubber::log10Shift(shift.temperature));
      ++found.count;
      if (!std::isfinite(shift.standardError)) {
        ++found.undetermined;
        continue;
      }
      if (error > shift.standardError) ++found.beyondOne;
      if (error > 2 * shift.standardError) ++found.beyondTwo;
      if (error > 3 * shift.standardError) ++found.beyondThree;
    }
  }
  for (double* share : {&found.beyondOne, &found.beyondTwo, &found.beyondThree})
    *share /= found.count;
  return found;
}

TEST(MasterCurve, StandardErrorsSayHowFarNoiseMovesThem) {
  const Coverage found = coverage(SyntheticRubber(), 15, 0.02, false, false);
  // A third of normal deviations lies beyond one standard error, a few in a thousand beyond three.
  EXPECT_NEAR(found.beyondOne, 0.32, 0.1);
  EXPECT_LE(found.beyondThree, 0.01);
  EXPECT_EQ(found.undetermined, 0);
}

/// Polynomials with as many terms as 0.3 % noise allows follow 5 % of it: then half of the shifts
/// are beyond one standard error, and 4 % beyond three.
TEST(MasterCurve, StandardErrorsHoldForMuchNoise) {
  SyntheticRubber stiff;
  stiff.equilibrium = 5e6;
  for (const SyntheticRubber& rubber : {SyntheticRubber(), stiff})
    for (const int points : {7, 15}) {
      const Coverage found = coverage(rubber, points, 0.05, false, false);
      EXPECT_NEAR(found.beyondOne, 0.32, 0.1) << points << " points, " << rubber.equilibrium;
      EXPECT_LE(found.beyondTwo, 0.1) << points << " points, " << rubber.equilibrium;
      EXPECT_LE(found.beyondThree, 0.03) << points << " points, " << rubber.equilibrium;
      EXPECT_LE(found.undetermined, 1) << points << " points, " << rubber.equilibrium;
    }
}

/// Vertical shifts that the moduli do not determine are those of entropy elasticity. A rubber that
/// is not entropic has none, and then the shifts have an error of one sign at every step.
TEST(MasterCurve, StandardErrorsWithVerticalShiftsHoldForEveryRubber) {
  for (const bool isEntropic : {false, true})
    for (const double noise : {0.003, 0.02}) {
      const Coverage found = coverage(SyntheticRubber(), 15, noise, true, isEntropic);
      EXPECT_LE(found.beyondTwo, 0.15) << noise << isEntropic;
      EXPECT_LE(found.beyondThree, 0.02) << noise << isEntropic;
      EXPECT_GE(found.beyondOne, 0.05) << noise << isEntropic;
      EXPECT_EQ(found.undetermined, 0) << noise << isEntropic;
    }
}

TEST(MasterCurve, NoiseAloneDoesNotMakeARubberComplex) {
  int complex = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    complex +=
        masterCurve(SyntheticRubber().sweeps(15, 0.02, seed), 298.15).isThermorheologicallySimple
            ? 0
            : 1;
  EXPECT_LE(complex, 1);
}

/// Two isotherms with half a decade in common leave few residuals, whose errors scatter.
TEST(MasterCurve, NoiseOfFewPointsDoesNotMakeARubberComplex) {
  int complex = 0, vertical = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const std::vector<Isotherm> pair{SyntheticRubber().sweep(268.15, 0.1, 10, 9, 0.02, seed),
                                     SyntheticRubber().sweep(278.15, 0.1, 10, 9, 0.02, seed)};
    const MasterCurve plain = masterCurve(pair, 278.15);
    complex += plain.isThermorheologicallySimple ? 0 : 1;
    vertical += plain.vertical.isSignificant ? 1 : 0;
  }
  // Three standard errors are exceeded by 0.3 %.
  EXPECT_LE(complex, 2);
  EXPECT_LE(vertical, 2);
}

/// G' alone of the warm isotherms lies on the flat rubbery side: its shifts are noise of up to a
/// decade, whatever the noise of the moduli.
TEST(MasterCurve, TheFlatSideOfOneModulusSaysNothing) {
  int complex = 0, count = 0;
  for (const double noise : {0.003, 0.01, 0.02, 0.03})
    for (unsigned seed = 1; seed <= 25; ++seed, ++count) {
      std::vector<Isotherm> isotherms;
      for (int i = 0; i < 9; ++i)
        isotherms.push_back(flatRubber().sweep(283.15 + 10 * i, 0.1, 30, 12, noise, seed));
      complex += masterCurve(isotherms, 303.15).isThermorheologicallySimple ? 0 : 1;
    }
  EXPECT_LE(complex, 1) << "of " << count;
}

/// Loss and storage that ask for different shifts.
TEST(MasterCurve, DifferentShiftsOfTheModuliAreFound) {
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

TEST(MasterCurve, VerticalShiftsOfAFewPerCentComeBack) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(21);
  makeEntropic(isotherms);
  const MasterCurve curve = masterCurve(isotherms, 298.15, true);
  for (const IsothermShift& shift : curve.shifts) {
    EXPECT_NEAR(shift.log10Vertical, std::log10(shift.temperature / 298.15), 0.012);
    EXPECT_NEAR(shift.log10Shift, SyntheticRubber::log10Shift(shift.temperature), 0.08);
  }
}

/// Williams, Landel and Ferry at another reference: C1' = C1 C2 / (C2 + dT), C2' = C2 + dT.
TEST(MasterCurve, TheReferenceMayLieBetweenIsotherms) {
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
TEST(MasterCurve, WithoutAFormulaTheReferenceIsInterpolated) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(15);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    for (DynamicModulus& point : isotherms[i].points)
      point.frequency *= std::pow(10, i % 2 == 0 ? 0.2 : 0);
  const MasterCurve at25 = masterCurve(isotherms, 298.15), at30 = masterCurve(isotherms, 303.15);
  const double half = 0.5 * (at25.shifts[3].log10Shift + at25.shifts[4].log10Shift);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    EXPECT_NEAR(at30.shifts[i].log10Shift, at25.shifts[i].log10Shift - half, 1e-12);
}

TEST(MasterCurve, TheUsualReferenceWasMeasured) {
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
TEST(MasterCurve, AnEntropicRubberIsSimpleWithVerticalShifts) {
  SyntheticRubber rubber;
  rubber.equilibrium = 5e6;
  std::vector<Isotherm> isotherms = rubber.sweeps(21);
  makeEntropic(isotherms);
  const MasterCurve plain = masterCurve(isotherms, 298.15);
  const MasterCurve vertical = masterCurve(isotherms, 298.15, true);
  EXPECT_FALSE(plain.isThermorheologicallySimple);
  EXPECT_TRUE(vertical.isThermorheologicallySimple);
  EXPECT_TRUE(plain.vertical.isSignificant);
  EXPECT_FALSE(vertical.vertical.isSignificant) << "it has them";
}

/// The size of each sample is known to a few per cent. Without vertical shifts, the shifts are
/// wrong by more than the noise makes them, and their errors say so.
TEST(MasterCurve, ErrorsGrowWhereVerticalShiftsAreMissing) {
  // Power laws alone cannot tell a vertical shift from a horizontal one.
  SyntheticRubber stiff;
  stiff.equilibrium = 5e6;
  double squares = 0, changes = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<Isotherm> isotherms = stiff.sweeps(15, 0.01, seed);
    makeEntropic(isotherms);
    const MasterCurve curve = masterCurve(isotherms, 298.15);
    EXPECT_TRUE(curve.vertical.isSignificant) << seed;
    EXPECT_LT(curve.vertical.residualWith, curve.vertical.residual) << seed;
    for (const IsothermShift& shift : curve.shifts) {
      if (shift.temperature == 298.15) continue;
      const double error = shift.log10Shift - SyntheticRubber::log10Shift(shift.temperature);
      squares += std::pow(error / shift.standardError, 2);
      changes = std::max(changes, std::abs(error));
      ++count;
    }
  }
  // Errors of noise alone are ten times too small here.
  EXPECT_LT(std::sqrt(squares / count), 2);
  EXPECT_GT(changes, 0.03);
}

/// Both moduli rise with one power of frequency: a shift of b decades up is one of b / 0.5 along.
TEST(MasterCurve, PowerLawsLeaveTheVerticalShiftOpen) {
  for (const double noise : {0.0, 0.003, 0.03})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::mt19937 random(seed);
      std::normal_distribution<double> normal;
      std::vector<Isotherm> isotherms(3);
      for (int t = 0; t < 3; ++t) {
        isotherms[t].temperature = 273.15 + 10 * t;
        for (int i = 0; i < 13; ++i) {
          const double frequency = std::pow(10, -1 + i / 6.0);
          const double modulus = 1e6 * std::sqrt(frequency * std::pow(10, -0.7 * t));
          isotherms[t].points.push_back({frequency, modulus * (1 + noise * normal(random)),
                                         0.8 * modulus * (1 + noise * normal(random))});
        }
      }
      for (const bool isVertical : {false, true})
        for (const Overlap& overlap : masterCurve(isotherms, 283.15, isVertical).overlaps)
          EXPECT_TRUE(overlap.isVerticalOpen) << noise << ' ' << seed;
    }
  // Moduli whose slopes vary determine both.
  int open = 0, count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const bool isVertical : {false, true})
      for (const Overlap& overlap :
           masterCurve(SyntheticRubber().sweeps(15, 0.003, seed), 298.15, isVertical).overlaps) {
        open += overlap.isVerticalOpen ? 1 : 0;
        ++count;
      }
  EXPECT_LE(open, count / 50);
}

/// Two processes, of which the slower one has half the activation of the other: G' and G'' of an
/// isotherm change their shape, which no shift undoes.
TEST(MasterCurve, TwoProcessesAreNotSimple) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SyntheticRubber fast = SyntheticRubber(), slow;
    fast.arms = 8;
    std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(15, 0.01, seed);
    for (Isotherm& isotherm : isotherms) {
      const double shift = SyntheticRubber::log10Shift(isotherm.temperature);
      for (DynamicModulus& point : isotherm.points) {
        const double quick = point.frequency * std::pow(10, shift);
        const double lazy = point.frequency * std::pow(10, 0.5 * shift);
        // The noise of the sweep stays.
        const DynamicModulus was = SyntheticRubber().at(quick);
        point.storage *=
            (fast.at(quick).storage + slow.at(lazy).storage - fast.at(lazy).storage) / was.storage;
        point.loss *= (fast.at(quick).loss + slow.at(lazy).loss - fast.at(lazy).loss) / was.loss;
      }
    }
    EXPECT_FALSE(masterCurve(isotherms, 298.15).isThermorheologicallySimple) << seed;
  }
}

/// Two glassy plateaus of different height, b_T = T / T_0, that have hardly a frequency in common.
TEST(MasterCurve, PlateausAreJoinedByAVerticalShift) {
  const SyntheticRubber rubber;
  std::vector<Isotherm> isotherms(2);
  isotherms[0].temperature = 233.15;
  isotherms[1].temperature = 263.15;
  for (Isotherm& isotherm : isotherms) {
    const double shift = isotherm.temperature < 250 ? 1e12 : std::pow(10, 9.2);
    for (int i = 0; i <= 12; ++i) {
      const double frequency = std::pow(10, -1 + 0.25 * i);
      const DynamicModulus modulus = rubber.at(frequency * shift);
      isotherm.points.push_back({frequency, modulus.storage * isotherm.temperature / 263.15,
                                 modulus.loss * isotherm.temperature / 263.15});
    }
  }
  const MasterCurve curve = masterCurve(isotherms, 263.15, true);
  EXPECT_NEAR(curve.shifts[0].log10Vertical, std::log10(233.15 / 263.15), 0.01);
  EXPECT_NEAR(curve.shifts[0].log10Shift, 2.8, 0.05);
  EXPECT_THAT(errorFrom([&] { masterCurve(isotherms, 263.15); }),
              HasSubstr("allow it with --vertical-shifts"));
}

TEST(MasterCurve, OneIsothermIsItsOwnMasterCurve) {
  const std::vector<Isotherm> one{SyntheticRubber().sweep(293.15, 0.1, 10, 9)};
  const MasterCurve curve = masterCurve(one, 293.15);
  ASSERT_EQ(curve.points.size(), 9U);
  EXPECT_EQ(curve.points.front().modulus, one.front().points.front());
  EXPECT_EQ(curve.shifts.front().log10Shift, 0);
}

TEST(MasterCurve, WhatCannotBeShiftedIsSaidInOneLine) {
  const SyntheticRubber rubber;
  const std::vector<Isotherm> apart{rubber.sweep(258.15, 1, 3, 5), rubber.sweep(298.15, 1, 3, 5)};
  EXPECT_THAT(errorFrom([&] { masterCurve(apart, 298.15); }), HasSubstr("do not overlap"));
  // One wrong value is no gap.
  std::vector<Isotherm> slipped{rubber.sweep(273.15, 0.1, 30, 12, 0.01),
                                rubber.sweep(278.15, 0.1, 30, 12, 0.01)};
  ASSERT_NO_THROW(masterCurve(slipped, 278.15));
  slipped[1].points[8].loss *= 0.01;
  EXPECT_THAT(errorFrom([&] { masterCurve(slipped, 278.15); }),
              AllOf(HasSubstr("overlap only without a point"),
                    HasSubstr("G\u2033 at 5.0 \u00B0C and 6.33 Hz is"), HasSubstr("take it out")));
  std::vector<Isotherm> swapped = rubber.sweeps(15);
  std::swap(swapped[3].points, swapped[4].points);
  EXPECT_THAT(errorFrom([&] { masterCurve(swapped, 298.15); }), HasSubstr("out of order"));
  EXPECT_THAT(errorFrom([&] { masterCurve(rubber.sweeps(15), 20); }),
              HasSubstr("--reference-temperature: 20 K is outside"));
}

}  // namespace
}  // namespace asperity
