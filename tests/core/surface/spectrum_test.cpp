#include "core/surface/spectrum.h"
#include "core/surface/line_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace asperity {
namespace {

TEST(Spectrum, TheNyquistModeIsDropped) {
  EXPECT_EQ(modeCount(3), 1U);
  EXPECT_EQ(modeCount(4), 1U);
  EXPECT_EQ(modeCount(5), 2U);
  EXPECT_EQ(modeCount(5000), 2499U);
}

TEST(Spectrum, AmplitudesFollowThePowerLawAndGiveTheHeight) {
  for (const double hurst : {0.0, 0.3, 0.7, 1.0}) {
    const auto a = selfAffineAmplitudes(1000, hurst, 5e-7);
    double sum = 0;
    for (const double amplitude : a) sum += amplitude * amplitude / 2;
    EXPECT_NEAR(std::sqrt(sum), 5e-7, 1e-19);
    // C ~ a^2 ~ q^(-2H-1)
    EXPECT_NEAR(std::pow(a[9] / a[99], 2), std::pow(10.0, 2 * hurst + 1), 1e-9 * std::pow(10, 3));
  }
}

/// grad L / h of N = 5000 elements: the known table, which keeps mode 2500.
TEST(Spectrum, SlopeOfThePapersLine) {
  const std::pair<double, double> table[] = {{0.2, 1500.6}, {0.3, 842.7}, {0.5, 245.0},
                                             {0.7, 71.9},   {0.8, 40.9},  {1.0, 16.6}};
  for (const auto& [hurst, expected] : table) {
    const auto a = selfAffineAmplitudes(5001, hurst, 1);
    double sum = 0;
    for (std::size_t j = 0; j < a.size(); ++j)
      sum += std::pow(a[j] * 2 * std::numbers::pi * static_cast<double>(j + 1), 2) / 2;
    EXPECT_NEAR(std::sqrt(sum), expected, 0.05) << hurst;
  }
}

TEST(Spectrum, HeightAndSlopeOfOneMode) {
  FourierLine line{0.02, {0, {3e-7, 4e-7}}};  // amplitude 2 |c| = 1e-6 at mode 2
  EXPECT_NEAR(rmsHeight(line), 1e-6 / std::sqrt(2), 1e-20);
  EXPECT_NEAR(rmsSlope(line), 1e-6 * 200 * std::numbers::pi / std::sqrt(2), 1e-16);
}

}  // namespace

namespace {

Scene roughScene() {
  Scene scene;
  scene.surface.elements = 2000;
  return scene;
}

/// rms slope of the part of the line that is below `part` of its height range from the bottom.
double slopeOfSummits(const Line& line, double quantile) {
  std::vector<double> sorted = line.height;
  std::sort(sorted.begin(), sorted.end());
  const double below =
      sorted[static_cast<std::size_t>(quantile * static_cast<double>(sorted.size()))];
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < line.nodes(); ++i)
    if (line.height[i] <= below) {
      sum += line.slopeAfter[i] * line.slopeAfter[i];
      ++count;
    }
  return std::sqrt(sum / count);
}

double nodalRms(const Line& line) {
  double sum = 0;
  for (const double z : line.height) sum += z * z;
  return std::sqrt(sum / static_cast<double>(line.nodes()));
}

TEST(RollOff, SpectrumIsFlatBelowItAndSelfAffineAbove) {
  Scene scene = roughScene();
  scene.surface.rollOffWavelength = scene.surface.length / 50;
  const LineSource source(scene, 1);
  const FourierLine modes = source.spectrum(0);
  const double flat = std::abs(modes.coefficients[0]);
  for (std::size_t k = 1; k <= 50; ++k)
    EXPECT_NEAR(std::abs(modes.coefficients[k - 1]) / flat, 1, 1e-12) << k;
  for (const std::size_t k : {60UL, 200UL, 999UL})
    EXPECT_NEAR(std::abs(modes.coefficients[k - 1]) / flat,
                std::pow(static_cast<double>(k) / 50, -0.7 - 0.5), 1e-12);
  EXPECT_NEAR(source.statistics().rmsHeight / 5e-7, 1, 1e-12);
  EXPECT_NEAR(nodalRms(source.make(3)) / 5e-7, 1, 1e-12);
}

TEST(RollOff, AsLongAsThePeriodOrAbsentChangesNoBit) {
  const Line plain = LineSource(roughScene(), 2).make(4);
  for (const double wavelength : {0.0, 0.02, 0.5}) {
    Scene scene = roughScene();
    scene.surface.rollOffWavelength = wavelength;
    const Line line = LineSource(scene, 2).make(4);
    EXPECT_EQ(line.height, plain.height);
    EXPECT_EQ(line.slopeAfter, plain.slopeAfter);
  }
}

TEST(SummitCorrelation, KeepsTheRmsHeightAndTheBand) {
  for (const double kappa : {-0.8, 0.3, 2.0}) {
    Scene scene = roughScene();
    scene.surface.summitCorrelation = kappa;
    const LineSource source(scene, 2);
    EXPECT_NEAR(source.statistics().rmsHeight / 5e-7, 1, 1e-12);
    EXPECT_EQ(source.spectrum(1).coefficients.size(), 999U);
    EXPECT_NEAR(nodalRms(source.make(1)) / 5e-7, 1, 1e-12);
  }
}

TEST(SummitCorrelation, ItsSignSaysWhereTheLineIsRough) {
  for (const double kappa : {-0.8, 0.8}) {
    Scene scene = roughScene();
    scene.surface.summitCorrelation = kappa;
    const LineSource source(scene, 1), plain(roughScene(), 1);
    double ratio = 0;
    for (std::int64_t n = 0; n < 10; ++n)
      ratio += slopeOfSummits(source.make(n), 0.1) / slopeOfSummits(plain.make(n), 0.1) / 10;
    if (kappa > 0) {
      EXPECT_GT(ratio, 1.1);
    } else {
      EXPECT_LT(ratio, 0.9);
    }
  }
}

/// The same waves at any number of points.
TEST(SummitCorrelation, LinesDoNotDependOnTheOversampling) {
  Scene scene = roughScene();
  scene.surface.summitCorrelation = 0.7;
  const Line coarse = LineSource(scene, 1).make(0), fine = LineSource(scene, 3).make(0);
  for (std::size_t i = 0; i < coarse.nodes(); i += 97)
    EXPECT_NEAR(coarse.height[i], fine.height[3 * i], 1e-18);
}

}  // namespace
}  // namespace asperity
