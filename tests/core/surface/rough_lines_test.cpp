// Roll-off and summit correlation of self-affine lines.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
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
