// Ramps and slow sweeps over a known rubber: moduli without their drift are those of one
// temperature.
#include "core/material/temperature_drift.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/error_from.h"
#include "tests/core/material/synthetic_rubber.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kStep = 0.5;  // K, from one frequency to the next

/// A ramp that repeats its frequencies, with 2 K between two sweeps and relative noise.
std::vector<MeasuredModulus> ramp(std::vector<double> frequencies, double noise) {
  const SyntheticRubber rubber;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<MeasuredModulus> rows;
  double kelvin = 270;
  for (int sweep = 0; sweep < 6; ++sweep) {
    for (const double frequency : frequencies) {
      DynamicModulus modulus = rubber.at(frequency * std::pow(10, rubber.log10Shift(kelvin)));
      modulus.frequency = frequency;
      modulus.storage *= 1 + noise * normal(random);
      modulus.loss *= 1 + noise * normal(random);
      rows.push_back({kelvin, modulus});
      kelvin += kStep;
    }
    kelvin += 2;
  }
  return rows;
}

/// Returns the largest relative deviation of the isotherms from the rubber at their temperatures.
double largestDeviation(const std::vector<Isotherm>& isotherms) {
  const SyntheticRubber rubber;
  double largest = 0;
  for (const Isotherm& isotherm : isotherms)
    for (const DynamicModulus& point : isotherm.points) {
      const DynamicModulus expected =
          rubber.at(point.frequency * std::pow(10, rubber.log10Shift(isotherm.temperature)));
      largest = std::max({largest, std::abs(point.storage / expected.storage - 1),
                          std::abs(point.loss / expected.loss - 1)});
    }
  return largest;
}

// The polynomials of the interpolation follow the steps of the arms, 0.7 decades apart, that well.
constexpr double kOfPolynomials = 0.02;
const std::vector<double> kFrequencies{0.5, 1, 2, 5, 10, 20};

/// Such a ramp became isotherms at the mean of their temperatures in silence, with moduli that were
/// wrong by several times the noise.
TEST(TemperatureDrift, IsInterpolatedAway) {
  for (const bool isRising : {true, false}) {
    std::vector<double> frequencies = kFrequencies;
    if (!isRising) std::ranges::reverse(frequencies);
    const auto isotherms = groupIsotherms(ramp(frequencies, 0));
    ASSERT_EQ(isotherms.size(), 6U);
    EXPECT_LT(largestDeviation(isotherms), kOfPolynomials);
    // The outermost ones need no extrapolation.
    EXPECT_DOUBLE_EQ(isotherms.front().temperature, 272.5);
    EXPECT_NEAR(isotherms[1].temperature, 276.25, 1e-9);
    EXPECT_DOUBLE_EQ(isotherms.back().temperature, 295);
    for (const Isotherm& isotherm : isotherms) {
      ASSERT_TRUE(isotherm.drift);
      EXPECT_TRUE(isotherm.drift->isRemoved);
      EXPECT_EQ(isotherm.drift->isRising, isRising);
    }
    const auto lines = describeDrift(isotherms);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_THAT(lines.front().english(),
                AllOf(HasSubstr(isRising ? "temperature rises with frequency within 6 of 6 sweeps"
                                         : "temperature falls with frequency within 6 of 6 sweeps"),
                      HasSubstr("by up to 2.50 K"), HasSubstr("are interpolated")));
  }
}

/// Weights of the interpolation do not raise the noise.
TEST(TemperatureDrift, NoiseIsNotRaised) {
  constexpr double kNoise = 0.02, kFarthestOf72 = 3.3;
  EXPECT_LT(largestDeviation(groupIsotherms(ramp(kFrequencies, kNoise))),
            kFarthestOf72 * kNoise + kOfPolynomials);
}

TEST(TemperatureDrift, IsSaidWhereItCannotBeRemoved) {
  // Each sweep has frequencies of its own.
  std::vector<MeasuredModulus> rows = ramp(kFrequencies, 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].modulus.frequency *= 1 + 0.01 * static_cast<double>(i / kFrequencies.size());
  const auto isotherms = groupIsotherms(rows);
  ASSERT_EQ(isotherms.size(), 6U);
  EXPECT_NEAR(isotherms.front().temperature, 271.25, 1e-9);
  EXPECT_GT(largestDeviation(isotherms), 4 * kOfPolynomials);
  const auto lines = describeDrift(isotherms);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines.front().english(),
              AllOf(HasSubstr("temperature rises with frequency within 6 of 6 sweeps, by up to "
                              "2.50 K (\u22123.1 \u00B0C to \u22120.6 \u00B0C, taken for "
                              "\u22121.9 \u00B0C)"),
                    HasSubstr("distorts their moduli")));
}

/// Where a sweep has lost a value, the one of the next sweep is interpolated with.
TEST(TemperatureDrift, LostValuesDoNotHinder) {
  std::vector<MeasuredModulus> rows = ramp(kFrequencies, 0);
  rows.erase(rows.begin() + 11);
  const auto isotherms = groupIsotherms(rows);
  EXPECT_LT(largestDeviation(isotherms), kOfPolynomials);
  EXPECT_EQ(isotherms[1].points.size(), 5U);
}

TEST(TemperatureDrift, ScatterIsNone) {
  std::vector<MeasuredModulus> rows;
  for (const double kelvin : {280.0, 290.0, 300.0})
    for (int i = 0; i < 12; ++i) {
      const double scatter[] = {-0.5, 0.3, 0.0, 0.5, -0.2, 0.1};
      rows.push_back({kelvin + scatter[i % 6], {std::pow(10, i / 6.0), 1e6, 1e5}});
    }
  const auto isotherms = groupIsotherms(rows);
  ASSERT_EQ(isotherms.size(), 3U);
  for (const Isotherm& isotherm : isotherms) EXPECT_FALSE(isotherm.drift);
  EXPECT_TRUE(describeDrift(isotherms).empty());
  // Nor is a drift that the tolerance allows.
  std::vector<MeasuredModulus> slow;
  for (int i = 0; i < 6; ++i)
    slow.push_back({290 + 0.1 * i, {kFrequencies[static_cast<std::size_t>(i)], 1e6, 1e5}});
  EXPECT_FALSE(groupIsotherms(slow).front().drift);
}

/// A ramp without steps was refused, because its sweeps have no gaps between them.
TEST(TemperatureDrift, ARampWithoutStepsBecomesIsotherms) {
  const SyntheticRubber rubber;
  for (const double step : {0.1, 0.45, 1.0}) {
    std::vector<MeasuredModulus> rows;
    double kelvin = 270;
    for (int i = 0; kelvin < 300; ++i, kelvin += step) {
      const double frequency = std::vector<double>{1, 3, 10, 30}[i % 4];
      DynamicModulus modulus = rubber.at(frequency * std::pow(10, rubber.log10Shift(kelvin)));
      modulus.frequency = frequency;
      rows.push_back({kelvin, modulus});
    }
    // The order of the rows does not matter, nor that a ramp was repeated.
    rows.insert(rows.end(), rows.begin(), rows.end());
    std::ranges::reverse(rows);
    const std::vector<Isotherm> isotherms = groupIsotherms(rows);
    ASSERT_GE(isotherms.size(), 6U) << step;
    EXPECT_GE(isotherms.front().temperature, 270 + 3 * step - 1e-9) << step;
    for (std::size_t i = 0; i < isotherms.size(); ++i) {
      EXPECT_EQ(isotherms[i].points.size(), 4U);
      if (i > 0) EXPECT_GE(isotherms[i].temperature - isotherms[i - 1].temperature, 2.999) << step;
    }
    EXPECT_LT(largestDeviation(isotherms), kOfPolynomials) << step;
    EXPECT_THAT(describeDrift(isotherms).at(0).english(),
                HasSubstr("rises or falls slowly at each of 4 frequencies"));
  }
}

/// Between temperatures that lie far apart nothing is interpolated.
TEST(TemperatureDrift, ARampWithAGapIsRefused) {
  std::vector<MeasuredModulus> rows;
  for (int i = 0; i < 80; ++i)
    rows.push_back({270 + 0.5 * i + (i < 40 ? 0 : 8), {i % 2 == 0 ? 1.0 : 10.0, 1e6, 1e5}});
  EXPECT_TRUE(isothermsOfRamp(rows, kIsothermTolerance).empty());
  EXPECT_THAT(errorFrom([&] { groupIsotherms(rows); }), HasSubstr("without a gap"));
}

/// A ramp at one frequency beside sweeps, in front of them or behind them.
TEST(TemperatureDrift, RampsAtOneFrequencyGiveWayToSweeps) {
  std::vector<MeasuredModulus> ramp, sweeps;
  for (int i = 0; i < 80; ++i) ramp.push_back({260.0 + i, {10, 1e6 - 1e3 * i, 1e5}});
  for (const double kelvin : {273.0, 293.0, 313.0})
    for (const double frequency : {10.0, 1.0, 10.0, 100.0})
      sweeps.push_back({kelvin, {frequency, 1e6, 1e5}});
  for (const bool isFirst : {true, false}) {
    std::vector<MeasuredModulus> rows = isFirst ? ramp : sweeps;
    rows.insert(rows.end(), isFirst ? sweeps.begin() : ramp.begin(),
                isFirst ? sweeps.end() : ramp.end());
    EXPECT_EQ(leaveOutRamps(rows, kIsothermTolerance), ramp.size()) << isFirst;
    EXPECT_EQ(rows.size(), sweeps.size());
    EXPECT_EQ(groupIsotherms(rows).size(), 3U);
  }
  // Ramps alone stay, and so do sweeps that are listed frequency by frequency.
  std::vector<MeasuredModulus> byFrequency;
  for (const double frequency : {1.0, 10.0, 100.0})
    for (int i = 0; i < 8; ++i) byFrequency.push_back({263.0 + 5 * i, {frequency, 1e6, 1e5}});
  EXPECT_EQ(leaveOutRamps(ramp, kIsothermTolerance), 0U);
  EXPECT_EQ(leaveOutRamps(byFrequency, kIsothermTolerance), 0U);
}

}  // namespace
}  // namespace asperity
