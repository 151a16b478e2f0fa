// Heights that are rounded to steps too coarse for their line, and what is none of that; profiles
// of rollers, and rough profiles whose long waves are no form.
#include "core/measured/profile_flaws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/base/fourier.h"
#include "core/measured/roughness_spectrum.h"

namespace asperity {
namespace {

constexpr std::size_t kPoints = 4000;
constexpr double kSpacing = 1e-6;  // m

/// A rough line with C1 ~ q^-2.6 below 500 um, of rms height 1 um.
std::vector<double> roughLine(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  RealTransform transform(2 * kPoints);
  std::vector<std::complex<double>> modes(transform.modes());
  for (std::size_t k = 1; k < kPoints; ++k)
    modes[k] = std::polar(std::pow(std::max(static_cast<double>(k), 16.0), -1.3), phase(random));
  std::vector<double> heights = transform.backward(std::move(modes));
  heights.resize(kPoints);
  double square = 0;
  for (const double z : heights) square += z * z / kPoints;
  for (double& z : heights) z *= 1e-6 / std::sqrt(square);
  return heights;
}

std::vector<double> rounded(std::vector<double> heights, double step, double offset = 0) {
  for (double& z : heights) z = offset + step * std::round(z / step);
  return heights;
}

/// Returns the rms slope of the waves up to q.
double slopeTo(const std::vector<double>& heights, double q) {
  const SpectralDensity density = hannSpectrum(heights, kSpacing);
  double square = 0;
  for (std::size_t i = 0; i < density.waveNumber.size() && density.waveNumber[i] <= q; ++i)
    square += std::pow(density.waveNumber[i], 2) * density.density[i];
  return std::sqrt(square);
}

/// Within the band that is called reliable, rounding changes the slope by less than 3 %; beyond it
/// up to fivefold.
TEST(HeightSteps, EndTheReliableBandOfTheSpectrum) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const std::vector<double> exact = roughLine(seed);
    for (const double step : {1e-7, 2e-7, 4e-7}) {
      const std::vector<double> heights = rounded(exact, step);
      const HeightSteps steps = coarseSteps(heights);
      EXPECT_NEAR(steps.step / step, 1, 1e-6);
      const ReliableBand band = reliableBand(heights, kSpacing, 0, steps);
      EXPECT_TRUE(band.endsInNoise) << step;
      EXPECT_NEAR(slopeTo(heights, band.to) / slopeTo(exact, band.to), 1, 0.03) << step;
      EXPECT_GT(slopeTo(heights, HUGE_VAL) / slopeTo(exact, HUGE_VAL), 1.1) << step;
    }
  }
}

TEST(HeightSteps, AreFoundInNumbersOfSinglePrecisionAndBesideGaps) {
  std::vector<double> heights = rounded(roughLine(1), 2e-7, 1e-4);
  for (double& z : heights) z = static_cast<float>(z);
  heights[100] = heights[101] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(coarseSteps(heights).step, 2e-7, 1e-10);
  EXPECT_GT(coarseSteps(heights).levels, 20);
  EXPECT_LT(coarseSteps(heights).levels, 60);
}

TEST(HeightSteps, AreFineEnoughInMostFiles) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(coarseSteps(roughLine(seed)).step, 0);
    EXPECT_EQ(coarseSteps(rounded(roughLine(seed), 10e-6 / 65536)).step, 0);  // 16 bits
  }
}

TEST(HeightSteps, AreNoneOfExactShapes) {
  const auto stepOf = [](auto height) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < 1000; ++i) heights.push_back(1e-6 * height(static_cast<double>(i)));
    return coarseSteps(heights).step;
  };
  EXPECT_EQ(stepOf([](double) { return 3.0; }), 0);
  EXPECT_EQ(stepOf([](double i) { return 0.1 * i; }), 0);
  EXPECT_EQ(stepOf([](double i) { return std::sin(2 * std::numbers::pi * i / 16); }), 0);
  EXPECT_EQ(stepOf([](double i) { return std::sin(2 * std::numbers::pi * i / 12); }), 0);
  EXPECT_EQ(stepOf([](double i) { return std::abs(std::fmod(i, 40) - 20); }), 0);  // triangle
  EXPECT_EQ(stepOf([](double i) { return std::min(std::fmod(i, 50), 20.0); }), 0);
  EXPECT_EQ(stepOf([](double i) { return std::fmod(i, 40) < 20 ? 0 : 1; }), 0);
  EXPECT_EQ(coarseSteps(std::vector<double>(3, std::nan(""))).step, 0);
}

constexpr std::size_t kRollerPoints = 1500;
constexpr double kRollerSpacing = 1e-6;  // m

/// Half of a period of a self-affine line, of rms height 1.
std::vector<double> selfAffineProfile(unsigned seed, double hurst, double rollOffWaves) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  RealTransform transform(2 * kRollerPoints);
  std::vector<std::complex<double>> modes(transform.modes());
  for (std::size_t k = 1; k < kRollerPoints; ++k) {
    const double amplitude = std::pow(std::max(static_cast<double>(k), rollOffWaves), -0.5 - hurst);
    const double real = normal(random), imaginary = normal(random);
    modes[k] = amplitude * std::complex(real, imaginary);
  }
  std::vector<double> heights = transform.backward(std::move(modes));
  heights.resize(kRollerPoints);
  double mean = 0, square = 0;
  for (const double z : heights) mean += z / kRollerPoints;
  for (double& z : heights) z -= mean, square += z * z / kRollerPoints;
  for (double& z : heights) z /= std::sqrt(square);
  return heights;
}

double slopeOfProfile(const std::vector<double>& heights) {
  double square = 0;
  for (std::size_t i = 1; i < kRollerPoints; ++i)
    square += std::pow((heights[i] - heights[i - 1]) / kRollerSpacing, 2) / kRollerPoints;
  return std::sqrt(square);
}

/// The profile spans this angle to each side of its top.
std::vector<double> roller(double halfAngle, double radius) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < kRollerPoints; ++i) {
    const double x =
        (2 * (static_cast<double>(i) + 0.5) / kRollerPoints - 1) * radius * std::sin(halfAngle);
    heights.push_back(std::sqrt(radius * radius - x * x));
  }
  return heights;
}

/// A roller whose roughness is half as high as what a parabola leaves of it, to first order
/// r (sin a)^4 / 8 times the rms of a Legendre polynomial of degree 4 in its place, 8 / 105.
TEST(RoundForm, IsFoundWhereAParabolaLeavesMoreThanTheRoughness) {
  int found = 0, count = 0;
  for (const double halfAngle : {0.15, 0.4, 0.8})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const double radius = kRollerPoints * kRollerSpacing / (2 * std::sin(halfAngle));
      const double left = radius * std::pow(std::sin(halfAngle), 4) / 8 * 8 / 105;
      std::vector<double> heights = roller(halfAngle, radius);
      const std::vector<double> rough = selfAffineProfile(seed, 0.7, 20);
      for (std::size_t i = 0; i < kRollerPoints; ++i) heights[i] += 0.5 * left * rough[i];
      const double got = radiusOfRoundForm(heights, kRollerSpacing);
      ++count;
      found += got > 0 ? 1 : 0;
      if (got > 0) {
        EXPECT_NEAR(got / radius, 1, 0.05);
      }
    }
  EXPECT_GE(found, count * 9 / 10);
}

/// Steep forms, also those of one shoulder, whose parabola is bent far more than their circle.
TEST(RoundForm, IsFoundUpToNearlyAHalfCircle) {
  constexpr double kRadius = 1e-2;
  for (const double end : {0.85, 0.9, 0.95})
    for (const double begin : {-end, -0.3, 0.2}) {
      const double spacing = (end - begin) * kRadius / kRollerPoints;
      std::vector<double> heights = selfAffineProfile(1, 0.7, 20);
      for (std::size_t i = 0; i < kRollerPoints; ++i) {
        const double x = begin * kRadius + (static_cast<double>(i) + 0.5) * spacing;
        heights[i] = 1e-6 * heights[i] + std::sqrt(kRadius * kRadius - x * x);
      }
      EXPECT_NEAR(radiusOfRoundForm(heights, spacing) / kRadius, 1, 0.05) << begin << ' ' << end;
    }
}

/// Gaps and a tilt change nothing.
TEST(RoundForm, IsFoundInATiltedProfileWithGaps) {
  std::vector<double> heights = roller(0.5, 2e-3);
  for (std::size_t i = 0; i < kRollerPoints; ++i)
    heights[i] = i % 7 == 3 ? std::numeric_limits<double>::quiet_NaN()
                            : -heights[i] + 1e-9 * std::sin(0.2 * static_cast<double>(i));
  EXPECT_NEAR(radiusOfRoundForm(heights, 2 * 2e-3 * std::sin(0.5) / kRollerPoints), 2e-3, 1e-5);
}

/// Long waves of a rough line look like a bow, which is no circle with a steep end.
TEST(RoundForm, IsNoLongWaveOfARoughProfile) {
  int found = 0, count = 0;
  for (const double slope : {0.03, 0.3, 1.0})
    for (const double hurst : {0.3, 0.7, 1.0})
      for (const double rollOff : {0.0, 10.0})
        for (unsigned seed = 1; seed <= 30; ++seed) {
          std::vector<double> heights = selfAffineProfile(seed, hurst, rollOff);
          const double factor = slope / slopeOfProfile(heights);
          for (double& z : heights) z *= factor;
          found += radiusOfRoundForm(heights, kRollerSpacing) > 0 ? 1 : 0;
          ++count;
        }
  EXPECT_LE(found, count / 100);
}

/// A flat bow is a parabola, which surface.form removes.
TEST(RoundForm, IsNoFlatBow) {
  std::vector<double> heights = roller(0.01, 1);
  const std::vector<double> rough = selfAffineProfile(1, 0.7, 20);
  for (std::size_t i = 0; i < kRollerPoints; ++i) heights[i] += 1e-7 * rough[i];
  EXPECT_EQ(radiusOfRoundForm(heights, 2 * std::sin(0.01) / kRollerPoints), 0);
}

/// What rounding leaves of a constant height or of a line is no circle.
TEST(RoundForm, IsNoneOfAStraightLine) {
  for (const double slope : {0.0, 0.3}) {
    std::vector<double> heights(100, 5.3e-6);
    for (std::size_t i = 0; i < heights.size(); ++i)
      heights[i] += slope * kRollerSpacing * static_cast<double>(i);
    EXPECT_EQ(radiusOfRoundForm(heights, kRollerSpacing), 0) << slope;
  }
}

}  // namespace
}  // namespace asperity
