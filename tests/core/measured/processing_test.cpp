// Gaussian filter of ISO 16610-21 against its transmission characteristic, form removal against
// forms that are known, gaps and outliers.
#include "core/measured/processing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace asperity {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<double> sine(std::size_t points, double spacing, double wavelength, double amplitude) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < points; ++i)
    heights.push_back(
        amplitude *
        std::sin(2 * std::numbers::pi * static_cast<double>(i) * spacing / wavelength + 0.3));
  return heights;
}

/// Amplitude of a sine in the middle half, by projection on whole waves.
double amplitudeOf(const std::vector<double>& heights, double spacing, double wavelength) {
  const auto wave = static_cast<std::size_t>(std::lround(wavelength / spacing));
  const std::size_t first = heights.size() / 4, count = heights.size() / 2 / wave * wave;
  double cosine = 0, sinus = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(i) * spacing / wavelength;
    cosine += heights[i] * std::cos(phase);
    sinus += heights[i] * std::sin(phase);
  }
  return 2 * std::hypot(cosine, sinus) / static_cast<double>(count);
}

/// ISO 16610-21: transmission of the mean line exp(-pi (alpha lambda_c / lambda)^2), 50 % at the
/// cut-off.
TEST(GaussianFilter, PassesHalfOfASineAtItsCutOff) {
  const double spacing = 1e-6;
  for (const double pointsToCut : {8.0, 20.0, 80.0, 250.0}) {
    const double cut = pointsToCut * spacing;
    const std::size_t points = 4000;
    const GaussianFilter filter(points, spacing, cut);
    const double passed = amplitudeOf(filter.meanLine(sine(points, spacing, cut, 1)), spacing, cut);
    EXPECT_NEAR(passed, 0.5, 0.0005) << pointsToCut;
  }
}

TEST(GaussianFilter, FollowsTheTransmissionOfTheStandardAtOtherWavelengths) {
  const double spacing = 1e-6, cut = 4e-5;
  const GaussianFilter filter(8000, spacing, cut);
  for (const double wavelength : {1e-5, 2e-5, 3e-5, 8e-5, 1.6e-4, 4e-4}) {
    const double passed =
        amplitudeOf(filter.meanLine(sine(8000, spacing, wavelength, 1)), spacing, wavelength);
    EXPECT_NEAR(passed, std::pow(2.0, -cut * cut / (wavelength * wavelength)), 5e-4) << wavelength;
  }
}

/// The fit of a straight line near the ends leaves a straight profile as it is, to its last point.
TEST(GaussianFilter, KeepsAStraightProfileUpToItsEnds) {
  std::vector<double> line;
  for (int i = 0; i < 500; ++i) line.push_back(3e-6 - 2e-8 * i);
  for (const double cut : {5e-6, 1e-4, 2e-3}) {
    const std::vector<double> mean = GaussianFilter(500, 1e-6, cut).meanLine(line);
    for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(mean[i], line[i], 1e-13) << cut;
  }
}

TEST(GaussianFilter, AgreesWithTheSumOverItsWeightsInside) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> heights(400);
  for (double& height : heights) height = normal(random);
  const double cut = 20;
  const std::vector<double> mean = GaussianFilter(400, 1, cut).meanLine(heights);
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
  for (const int i : {60, 200, 333}) {
    double sum = 0, weights = 0;
    for (int j = -40; j <= 40; ++j) {
      const double part = j / (alpha * cut), weight = std::exp(-std::numbers::pi * part * part);
      sum += weight * heights[static_cast<std::size_t>(i + j)];
      weights += weight;
    }
    EXPECT_NEAR(mean[static_cast<std::size_t>(i)], sum / weights, 1e-12);
  }
}

TEST(Form, IsRemovedWhollyWhereTheProfileIsNothingElse) {
  std::vector<double> parabola, line;
  for (int i = 0; i < 101; ++i) {
    line.push_back(1e-3 + 2e-6 * i);
    parabola.push_back(1e-3 + 2e-6 * i - 3e-8 * i * i);
  }
  removeForm(line, FormRemoval::Line);
  removeForm(parabola, FormRemoval::Parabola);
  for (const double rest : line) EXPECT_NEAR(rest, 0, 1e-17);
  for (const double rest : parabola) EXPECT_NEAR(rest, 0, 1e-17);
}

/// Residuals of least squares are orthogonal to the functions of the form.
TEST(Form, LeavesResidualsThatAreOrthogonalToIt) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<double> heights(200);
  for (double& height : heights) height = normal(random) + 5;
  removeForm(heights, FormRemoval::Parabola);
  double constant = 0, linear = 0, square = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = static_cast<double>(i) / 200;
    constant += heights[i];
    linear += heights[i] * x;
    square += heights[i] * x * x;
  }
  for (const double sum : {constant, linear, square}) EXPECT_NEAR(sum, 0, 1e-10);
}

TEST(Form, OfATopographyIsAPlaneOrAParaboloid) {
  const std::size_t rows = 20, columns = 30;
  std::vector<double> plane, bowl;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const auto u = static_cast<double>(x), v = static_cast<double>(y);
      plane.push_back(1 + 0.3 * u - 0.2 * v);
      bowl.push_back(1 + 0.3 * u - 0.2 * v + 0.01 * u * u - 0.02 * u * v + 0.03 * v * v);
    }
  removeForm(plane, rows, columns, FormRemoval::Line);
  removeForm(bowl, rows, columns, FormRemoval::Parabola);
  for (const double rest : plane) EXPECT_NEAR(rest, 0, 1e-12);
  for (const double rest : bowl) EXPECT_NEAR(rest, 0, 1e-11);
}

TEST(Form, OfNoneLeavesEveryBit) {
  std::vector<double> heights{1, 2, 4, 8};
  const std::vector<double> before = heights;
  removeForm(heights, FormRemoval::None);
  EXPECT_EQ(heights, before);
}

TEST(Gaps, AreFilledByStraightLinesAndHeldAtTheEnds) {
  std::vector<double> heights{kNone, 1, kNone, kNone, 4, 5, kNone};
  EXPECT_EQ(gapCount(heights), 4);
  interpolateGaps(heights);
  const std::vector<double> expected{1, 1, 2, 3, 4, 5, 5};
  for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_DOUBLE_EQ(heights[i], expected[i]);
}

TEST(Outliers, AreFoundOnATiltedProfileAndNothingElseIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> heights;
  for (int i = 0; i < 500; ++i) heights.push_back(100.0 * i + uniform(random));
  heights[7] += 400;
  heights[250] -= 90;
  heights[499] += 5000;
  std::vector<double> marked = heights;
  EXPECT_EQ(markOutliers(marked, 10, FormRemoval::Line), 3);
  for (const std::size_t i : {7U, 250U, 499U}) EXPECT_TRUE(std::isnan(marked[i]));
  EXPECT_EQ(marked[8], heights[8]);
  EXPECT_EQ(markOutliers(heights, 0, FormRemoval::Line), 0);
}

TEST(Outliers, AreNotAskedOfAProfileThatLiesOnItsFormExactly) {
  std::vector<double> flat(100, 1.0);
  flat[3] = 2;
  EXPECT_EQ(markOutliers(flat, 5, FormRemoval::Mean), 0);
}

/// Rows of heights with the spectrum of a rough surface: flat up to a wave, then a power law.
std::vector<double> roughRow(std::mt19937& random, std::size_t points, int rollOff, double hurst) {
  std::normal_distribution<double> normal;
  std::vector<double> heights(points);
  for (int k = 1; 2 * k < static_cast<int>(points); ++k) {
    const double amplitude = std::pow(std::max(k, rollOff), -hurst - 0.5);
    const double cosine = amplitude * normal(random), sinus = amplitude * normal(random);
    const double turn = 2 * std::numbers::pi * k / static_cast<double>(points);
    for (std::size_t i = 0; i < points; ++i)
      heights[i] += cosine * std::cos(turn * static_cast<double>(i)) +
                    sinus * std::sin(turn * static_cast<double>(i));
  }
  double square = 0;
  for (const double height : heights) square += height * height / static_cast<double>(points);
  for (double& height : heights) height /= std::sqrt(square);
  return heights;
}

TEST(Spikes, AreCountedWhereverTheyStand) {
  std::mt19937 random(5);
  for (const double sign : {-1.0, 1.0}) {
    std::vector<double> heights = roughRow(random, 400, 4, 0.8);
    EXPECT_EQ(spikeCount(heights, FormRemoval::Line), 0);
    for (std::size_t i = 0; i < 400; ++i) heights[i] += 0.5 * static_cast<double>(i);
    heights[0] += 9 * sign;
    heights[60] += 9 * sign;
    heights[200] -= 9 * sign;
    heights[201] -= 10 * sign;
    heights[300] = kNone;  // a gap beside a spike
    heights[301] += 9 * sign;
    heights[399] -= 9 * sign;
    EXPECT_EQ(spikeCount(heights, FormRemoval::Line), 6);
    EXPECT_EQ(markOutliers(heights, kUsualOutliers, FormRemoval::Line), 6);
    EXPECT_EQ(spikeCount(heights, FormRemoval::Line), 0);
  }
}

/// A step, or a plateau with steep sides, is no error of the measurement.
TEST(Spikes, AreNoStepsAndNoPlateaus) {
  std::mt19937 random(6);
  std::vector<double> heights = roughRow(random, 400, 4, 0.8);
  for (std::size_t i = 100; i < 120; ++i) heights[i] += 20;
  EXPECT_EQ(spikeCount(heights, FormRemoval::Line), 0);
  EXPECT_EQ(spikeCount(std::vector<double>(50, 1.0), FormRemoval::Mean), 0);
  EXPECT_EQ(spikeCount(std::vector<double>(50, kNone), FormRemoval::Mean), 0);
}

/// Gaussian heights reach beyond six median deviations (4.05 standard deviations) in 5 of 100000
/// points, and skewed ones much more often.
TEST(Spikes, AreNotFoundOnRoughSurfaces) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::int64_t outliers = 0, outliersOfSkewed = 0;
  std::int64_t aloneAmongIndependent = 0, aloneAmongSmooth = 0;
  for (int row = 0; row < 300; ++row) {
    std::vector<double> white(1000);
    for (double& height : white) height = normal(random);
    EXPECT_EQ(spikeCount(white, FormRemoval::Line), 0);
    outliers += markOutliers(white, kUsualOutliers, FormRemoval::Line);
    if (row % 3 > 0) continue;
    for (const double hurst : {0.3, 0.8}) {
      const std::vector<double> rough = roughRow(random, 400, 4, hurst);
      EXPECT_EQ(spikeCount(rough, FormRemoval::Line), 0) << hurst;
      // Worn summits and deep valleys; a few high summits.
      std::vector<double> worn = rough, summits = rough;
      for (double& height : worn) height = height > 0 ? 0.2 * height : height;
      for (double& height : summits) height = std::exp(height);
      // Where neighbours are nearly independent, a few skewed heights do stand alone.
      std::int64_t& alone = hurst < 0.5 ? aloneAmongIndependent : aloneAmongSmooth;
      alone += spikeCount(worn, FormRemoval::Line) + spikeCount(summits, FormRemoval::Line);
      outliersOfSkewed += markOutliers(worn, kUsualOutliers, FormRemoval::Line) +
                          markOutliers(summits, kUsualOutliers, FormRemoval::Line);
    }
  }
  EXPECT_GT(outliers, 0);
  EXPECT_GT(outliersOfSkewed, 1000);
  EXPECT_EQ(aloneAmongSmooth, 0);
  constexpr std::int64_t kSkewedPoints = 100 * 2 * 400;
  EXPECT_LT(aloneAmongIndependent, 2 * kSkewedPoints / 1000);  // about one point of 1000
}

}  // namespace
}  // namespace asperity
