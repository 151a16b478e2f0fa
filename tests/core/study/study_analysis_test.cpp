// The analysis of a study, by functions whose sensitivity indices are known in closed form.
#include "core/study/study_analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asperity {
namespace {

using std::numbers::pi;

StudyAxis axisOf(const char* key, double from, double to, bool isLogarithmic = false) {
  const Parameter* row = findParameter(key);
  StudyAxis axis{.columns = {{row, {}, {}}},
                 .range = ParameterRange{row, from, to, 1, isLogarithmic}};
  return axis;
}

constexpr const char* kKeys[] = {"surface.hurst", "load.normal_force", "surface.rms_height"};

/// Analyses a function of three numbers on a sample of its own.
template <class Function>
OutputAnalysis analysed(const StudySpace& space, const Function& function,
                        std::int64_t failedAt = -1) {
  std::vector<double> point(space.columns());
  const StudyAnalysis analysis =
      analyseSimulations(space, {{"y", {}}}, [&](const UseSimulation& use) {
        for (std::int64_t i = 0; i < space.size(); ++i) {
          space.pointInto(i, point);
          const double y = i == failedAt ? std::nan("") : function(point);
          use(i, {&y, 1});
        }
      });
  return analysis.outputs.front();
}

TEST(SobolIndices, OfTheIshigamiFunction) {
  // Ishigami and Homma (1990): y = sin x1 + a sin^2 x2 + b x3^4 sin x1 on (-pi, pi)^3.
  constexpr double a = 7, b = 0.1;
  std::vector<StudyAxis> axes;
  for (const char* key : kKeys) axes.push_back(axisOf(key, -pi, pi));
  const StudySpace space(axes, Sampling::Saltelli, 8192, 1);
  const OutputAnalysis found = analysed(space, [](const std::vector<double>& x) {
    return std::sin(x[0]) + a * std::pow(std::sin(x[1]), 2) +
           b * std::pow(x[2], 4) * std::sin(x[0]);
  });
  const double v1 = 0.5 * std::pow(1 + b * std::pow(pi, 4) / 5, 2), v2 = a * a / 8;
  const double v13 = b * b * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), v = v1 + v2 + v13;
  const double first[] = {v1 / v, v2 / v, 0}, total[] = {(v1 + v13) / v, v2 / v, v13 / v};
  ASSERT_EQ(found.indices.size(), 3U);
  EXPECT_EQ(found.blocks, 8192);
  EXPECT_NEAR(found.mean, a / 2, 0.01);
  EXPECT_NEAR(found.deviation * found.deviation / v, 1, 0.01);
  for (std::size_t i = 0; i < 3; ++i) {
    const SobolIndex& index = found.indices[i];
    EXPECT_NEAR(index.first.value, first[i], 0.01) << i;
    EXPECT_NEAR(index.total.value, total[i], 0.01) << i;
    // Sobol points are more even than random ones, so the jackknife is on the safe side.
    EXPECT_LE(std::abs(index.first.value - first[i]), 4 * index.first.standardError + 1e-4);
    EXPECT_LE(std::abs(index.total.value - total[i]), 4 * index.total.standardError + 1e-4);
    EXPECT_LT(index.first.standardError, 0.05);
  }
}

TEST(SobolIndices, OfASumAreTheSharesOfItsVariances) {
  // y = x1 + 2 x2 + 3 x3: the first orders are the total effects, 1 : 4 : 9; a mean far from 0 does
  // not disturb them.
  std::vector<StudyAxis> axes;
  for (const char* key : kKeys) axes.push_back(axisOf(key, 0, 1));
  const OutputAnalysis found =
      analysed(StudySpace(axes, Sampling::Saltelli, 2048, 3),
               [](const std::vector<double>& x) { return 1e4 + x[0] + 2 * x[1] + 3 * x[2]; });
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = static_cast<double>((i + 1) * (i + 1)) / 14;
    EXPECT_NEAR(found.indices[i].first.value, share, 0.005);
    EXPECT_NEAR(found.indices[i].total.value, share, 0.005);
  }
}

/// Table 2 (b) of Saltelli et al. (2010) is the mean of t = y_B (y_AB - y_A) / V. From n random
/// points it has the standard error sqrt(Var(t) / n), and from n Sobol points a smaller one: the
/// error that is stated has to be between that of the indices and that of random points.
TEST(SobolIndices, AreStatedWithASmallerErrorThanThoseOfRandomPoints) {
  constexpr std::int64_t kPoints = 2048;
  const auto sum = [](const std::vector<double>& x) { return x[0] + 2 * x[1] + 3 * x[2] - 3; };
  std::vector<StudyAxis> axes;
  for (const char* key : kKeys) axes.push_back(axisOf(key, 0, 1));
  std::mt19937 random(1);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr double kVariance = 14.0 / 12;
    double mean = 0, square = 0;
    constexpr int kDraws = 20000;
    for (int draw = 0; draw < kDraws; ++draw) {
      std::vector<double> a(3), b(3);
      for (std::vector<double>* point : {&a, &b})
        for (double& x : *point) x = static_cast<double>(random()) / 4294967296.0;
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      const double t = sum(b) * (sum(mixed) - sum(a)) / kVariance;
      mean += t / kDraws;
      square += t * t / kDraws;
    }
    const double ofRandom = std::sqrt((square - mean * mean) / static_cast<double>(kPoints));
    double stated = 0, squares = 0;
    constexpr int kSeeds = 10;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      const OutputAnalysis found =
          analysed(StudySpace(axes, Sampling::Saltelli, kPoints, seed), sum);
      const double share = static_cast<double>((i + 1) * (i + 1)) / 14;
      stated += found.indices[i].first.standardError / kSeeds;
      squares += std::pow(found.indices[i].first.value - share, 2) / kSeeds;
    }
    EXPECT_LT(stated, ofRandom) << i;
    EXPECT_GT(stated, std::sqrt(squares)) << i;
  }
}

/// The interval is that of Student's t (0.975) with one degree of freedom less than there are
/// groups: 4 blocks are 4 groups, many are 16.
TEST(SobolIndices, HaveTheIntervalOfTheirGroups) {
  for (const auto& [blocks, quantile] : {std::pair{4, 3.1824}, std::pair{512, 2.1314}}) {
    const OutputAnalysis found = analysed(
        StudySpace({axisOf(kKeys[0], 0, 1), axisOf(kKeys[1], 0, 1)}, Sampling::Saltelli, blocks, 3),
        [](const std::vector<double>& x) { return x[0] + x[1]; });
    EXPECT_NEAR(found.indices[0].halfInterval, quantile, 1e-3) << blocks;
  }
}

TEST(SobolIndices, ABlockWithAFailureIsLeftOut) {
  std::vector<StudyAxis> axes{axisOf(kKeys[0], 0, 1), axisOf(kKeys[1], 0, 1)};
  const OutputAnalysis found = analysed(
      StudySpace(axes, Sampling::Saltelli, 256, 3),
      [](const std::vector<double>& x) { return x[0] + x[1]; }, 9);
  EXPECT_EQ(found.blocks, 255);
  EXPECT_NEAR(found.indices[0].first.value, 0.5, 0.05);
}

TEST(SobolIndices, NeedADesign) {
  const OutputAnalysis found =
      analysed(StudySpace({axisOf(kKeys[0], 0, 1)}, Sampling::Sobol, 256, 3),
               [](const std::vector<double>& x) { return x[0]; });
  EXPECT_TRUE(found.indices.empty());
}

TEST(MainEffects, FollowTheMeanOverTheOtherKeys) {
  // y = x1^2 x2 with x2 uniform in 0 to 1: E(y | x1) = x1^2 / 2.
  const OutputAnalysis found = analysed(
      StudySpace({axisOf(kKeys[0], 0, 1), axisOf(kKeys[1], 0, 1)}, Sampling::Sobol, 8192, 1),
      [](const std::vector<double>& x) { return x[0] * x[0] * x[1]; });
  const ColumnEffect& effect = found.effects[0];
  ASSERT_EQ(effect.means.size(), 20U);
  for (const MainEffect& one : effect.means) {
    EXPECT_NEAR(one.mean, one.x * one.x / 2, 2e-3);
    EXPECT_GT(one.count, 300);
  }
}

TEST(Correlations, OfKnownFunctions) {
  const StudySpace space({axisOf(kKeys[0], 0, 1), axisOf(kKeys[1], 1e-3, 1e3, true)},
                         Sampling::Sobol, 4096, 1);
  // A power of the second key is a line over its logarithm only after its own logarithm.
  const OutputAnalysis found =
      analysed(space, [](const std::vector<double>& x) { return std::log(x[1]) + 0 * x[0]; });
  EXPECT_NEAR(found.effects[1].correlation, 1, 1e-12);
  EXPECT_NEAR(found.effects[1].rankCorrelation, 1, 1e-12);
  EXPECT_NEAR(found.effects[0].correlation, 0, 0.03);
  EXPECT_TRUE(found.effects[1].isLogarithmic);
  // Ranks do not care for a monotonous change; U(0, 1) against its cube has correlation
  // sqrt(21) / 5.
  const OutputAnalysis cube =
      analysed(space, [](const std::vector<double>& x) { return -x[0] * x[0] * x[0]; });
  EXPECT_NEAR(cube.effects[0].correlation, -std::sqrt(21.0) / 5, 1e-3);
  EXPECT_NEAR(cube.effects[0].rankCorrelation, -1, 1e-12);
}

TEST(Percentiles, OfAUniformNumber) {
  const OutputAnalysis found =
      analysed(StudySpace({axisOf(kKeys[0], 0, 1)}, Sampling::Sobol, 4096, 1),
               [](const std::vector<double>& x) { return 100 * x[0]; });
  for (std::size_t i = 0; i < kPercentiles.size(); ++i)
    EXPECT_NEAR(found.percentiles[i], kPercentiles[i], 0.1);
  EXPECT_NEAR(found.least, 0, 0.1);
  EXPECT_NEAR(found.largest, 100, 0.1);
}

TEST(CurveBands, AreThePercentilesAtEachValue) {
  const StudySpace space({axisOf(kKeys[0], 0, 1)}, Sampling::Sobol, 2048, 1);
  std::vector<double> point(1);
  const StudyAnalysis analysis =
      analyseSimulations(space, {{"curve.mu", {1, 10, 100}}}, [&](const UseSimulation& use) {
        for (std::int64_t i = 0; i < space.size(); ++i) {
          space.pointInto(i, point);
          const double y[] = {point[0], 2 * point[0], 3 + point[0]};
          use(i, y);
        }
      });
  ASSERT_EQ(analysis.bands.size(), 1U);
  EXPECT_NEAR(analysis.bands[0].percentiles[0][2], 0.5, 2e-3);
  EXPECT_NEAR(analysis.bands[0].percentiles[1][4], 1.9, 4e-3);
  EXPECT_NEAR(analysis.bands[0].percentiles[2][0], 3.05, 2e-3);
}

TEST(StudyAnalysis, OfOneSimulationSaysWhatItCan) {
  const OutputAnalysis found = analysed(StudySpace({axisOf(kKeys[0], 0, 1)}, Sampling::Sobol, 1, 1),
                                        [](const std::vector<double>&) { return 3.0; });
  EXPECT_EQ(found.mean, 3);
  EXPECT_TRUE(std::isnan(found.deviation));
  EXPECT_TRUE(std::isnan(found.effects[0].correlation));
}

}  // namespace
}  // namespace asperity
