// Levels of resolution: allocation at least cost, what a plan promises.
#include "core/accuracy/levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asperity {
namespace {

/// Lagrange: n_l ~ sqrt(V_l / c_l); no other distribution of the same variance is cheaper.
TEST(Levels, AllocationMeetsTheVarianceAtLeastCost) {
  const std::vector<double> variances{4, 0.3, 0.01}, costs{1, 3, 6};
  const double allowed = 1e-4;
  const auto lines = optimalLines(variances, costs, allowed, std::vector<std::int64_t>{1, 1, 1});
  double variance = 0, cost = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    variance += variances[k] / static_cast<double>(lines[k]);
    cost += costs[k] * static_cast<double>(lines[k]);
  }
  EXPECT_LE(variance, allowed);
  EXPECT_GT(variance, 0.99 * allowed);
  for (const double shift : {0.7, 1.4}) {
    // Move lines between two levels at constant variance.
    const double n0 = static_cast<double>(lines[0]) * shift;
    const double rest = allowed - variances[0] / n0 - variances[2] / static_cast<double>(lines[2]);
    if (rest <= 0) continue;
    const double n1 = variances[1] / rest;
    EXPECT_GT(costs[0] * n0 + costs[1] * n1 + costs[2] * static_cast<double>(lines[2]),
              0.999 * cost);
  }
}

/// Levels with differences that fall as 1/16 and cost that doubles; the second half of the lines
/// may spread more than the first.
Halves sampleLevels(double spreadOfDifferences, double spreadOfSecond = 0.3) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  Halves halves{std::vector<LevelSums>(4), std::vector<LevelSums>(4)};
  for (std::size_t half = 0; half < 2; ++half)
    for (int line = 0; line < 400; ++line) {
      double value = 1 + (half == 0 ? 0.3 : spreadOfSecond) * normal(generator);
      double difference = 0.02;
      for (std::size_t l = 0; l < 4; ++l) {
        LevelSums& sums = halves[half][l];
        if (l > 0) {
          const double correction = difference * (1 + spreadOfDifferences * normal(generator));
          sums.correction.add(correction);
          value += correction;
          difference /= 16;
        }
        sums.value.add(value);
        sums.direct.add(value);
        sums.operations.add(std::pow(2.0, static_cast<double>(l)));
      }
    }
  return halves;
}

double meanOn(const Halves& halves, std::size_t level) {
  return (halves[0][level].value.mean() + halves[1][level].value.mean()) / 2;
}

TEST(Levels, CoarseTargetTakesTheCoarsestLineWhoseErrorIsKnown) {
  const auto plan = planLevels(sampleLevels(0.1), 4, 0.1);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->last, 1);
  EXPECT_LE(plan->resolutionError, 0.03);
  EXPECT_GE(plan->resolutionError, 0.02 / 3.1);
}

TEST(Levels, FineTargetCombinesLevelsAndIsCheaper) {
  const auto plan = planLevels(sampleLevels(0.1), 4, 0.002);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->first, 0);
  EXPECT_GE(plan->last, 2);
  EXPECT_LT(plan->operations, 0.6 * plan->plainOperations);
}

/// Differences that vary more than friction itself: nothing is won by the level below.
TEST(Levels, LevelsWhoseDifferenceVariesMuchAreNotCombined) {
  const auto plan = planLevels(sampleLevels(20), 4, 0.01);
  ASSERT_TRUE(plan);
  EXPECT_GE(plan->first, 1);
}

TEST(Levels, AsksForAFinerLevel) {
  EXPECT_FALSE(planLevels(sampleLevels(0.1), 2, 2e-3));
  EXPECT_TRUE(planLevels(sampleLevels(0.1), 3, 2e-3));
}

/// Lines do not decide about the lines beside them.
TEST(Levels, TheSpreadOfOneHalfPlansTheOther) {
  const Halves halves = sampleLevels(0.1, 0.6);
  const auto plan = planLevels(halves, 4, 0.01);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(static_cast<double>(plan->lines[0][0]) / static_cast<double>(plan->lines[1][0]), 4,
              1);
}

/// Differences of either sign have a mean of 0, and lines are wrong by their spread all the same.
TEST(Levels, NoMeanDifferenceIsNoProofOfResolution) {
  Halves halves{std::vector<LevelSums>(2), std::vector<LevelSums>(2)};
  for (auto& half : halves)
    for (const double difference : {-0.1, 0.1, -0.1, 0.1}) half[1].correction.add(difference);
  EXPECT_GT(estimateResolutionError(halves, 1), 0.008);
}

/// The sum over levels has the mean of the finest one and the error it states.
TEST(Levels, EstimateIsOfTheFinestLevel) {
  const Halves halves = sampleLevels(0.1);
  const LevelEstimate estimate = estimateMean(halves, {0, 2, {}, 0, 0, 0});
  EXPECT_NEAR(estimate.mean, meanOn(halves, 2), 1e-12);
  RunningMean all = halves[0][0].direct;
  all.add(halves[1][0].direct);
  EXPECT_NEAR(estimate.standardError / all.standardError(), 1, 0.01);
}

TEST(Levels, ALineThatAgreesOnceIsNotTakenAtItsWord) {
  EXPECT_GT(lineError(std::vector{1.0, 1.1, 1.1}), 0.1 / 4 / 1.01);
  EXPECT_GT(lineError(std::vector{1.0, 1.0, 1.1}), 0.1 / 1.01);
  EXPECT_GT(lineError(std::vector{9.0, 1.0, 1.1, 1.1}), 0.1 / 4 / 1.01);
}

TEST(RunningMean, OfTwoStreamsIsThatOfAllNumbers) {
  RunningMean a, b, all;
  for (const double value : {3.0, 4.5, -1.0}) a.add(value), all.add(value);
  for (const double value : {100.0, 2.0}) b.add(value), all.add(value);
  a.add(RunningMean{});
  a.add(b);
  EXPECT_EQ(a.count(), 5);
  EXPECT_NEAR(a.mean(), all.mean(), 1e-12);
  EXPECT_NEAR(a.variance(), all.variance(), 1e-9);
}

}  // namespace
}  // namespace asperity
