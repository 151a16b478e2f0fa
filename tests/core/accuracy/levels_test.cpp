// Levels of resolution: allocation at least cost, what a plan promises, the quantile of Student.
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
  const auto lines = optimalLines(variances, costs, allowed, 1);
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

TEST(Levels, StudentQuantile) {
  EXPECT_NEAR(studentQuantile(1e9), 1.959964, 1e-6);
  EXPECT_NEAR(studentQuantile(7), 2.364624, 2e-3);
  EXPECT_NEAR(studentQuantile(15), 2.131450, 2e-4);
  EXPECT_NEAR(studentQuantile(30), 2.042272, 1e-4);
}

/// Levels with differences that fall as 1/16 and cost that doubles.
std::vector<LevelSums> sampleLevels(double spreadOfDifferences) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  std::vector<LevelSums> levels(4);
  for (int line = 0; line < 400; ++line) {
    double value = 1 + 0.3 * normal(generator);
    double difference = 0.02;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      if (l > 0) {
        const double correction = difference * (1 + spreadOfDifferences * normal(generator));
        levels[l].correction.add(correction);
        value += correction;
        difference /= 16;
      }
      levels[l].value.add(value);
      levels[l].direct.add(value);
      levels[l].operations.add(std::pow(2.0, static_cast<double>(l)));
    }
  }
  return levels;
}

TEST(Levels, CoarseTargetTakesTheCoarsestLine) {
  const auto levels = sampleLevels(0.1);
  const auto plan = planLevels(levels, 4, 0.1);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->last, 0);
  EXPECT_LE(plan->resolutionError, 0.05);
}

TEST(Levels, FineTargetCombinesLevelsAndIsCheaper) {
  const auto levels = sampleLevels(0.1);
  const auto plan = planLevels(levels, 4, 0.002);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->first, 0);
  EXPECT_EQ(plan->last, 2);
  EXPECT_LT(plan->operations, 0.6 * plan->plainOperations);
}

/// Differences that vary as much as friction itself: nothing is won, plain averaging is chosen.
TEST(Levels, PlainWhereDifferencesVaryMuch) {
  const auto levels = sampleLevels(20);
  const auto plan = planLevels(levels, 4, 0.02);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->first, plan->last);
}

TEST(Levels, AsksForAFinerLevel) {
  const auto levels = sampleLevels(0.1);
  EXPECT_FALSE(planLevels(std::span(levels).first(2), 2, 1e-4));
}

/// The sum over levels has the mean of the finest one and the error it states.
TEST(Levels, EstimateIsOfTheFinestLevel) {
  const auto levels = sampleLevels(0.1);
  LevelPlan plan{0, 2, {400, 400, 400}, 0, 0, 0};
  const LevelEstimate estimate = estimateOf(levels, plan);
  EXPECT_NEAR(estimate.mean, levels[2].value.mean(), 1e-12);
  EXPECT_GT(estimate.standardError, levels[0].direct.standardError());
  EXPECT_LT(estimate.standardError, 1.01 * levels[0].direct.standardError());
}

}  // namespace
}  // namespace asperity
