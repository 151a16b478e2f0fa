// Heights that are rounded to steps too coarse for their line, and what is none of that.
#include "core/measured/height_steps.h"

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

}  // namespace
}  // namespace asperity
