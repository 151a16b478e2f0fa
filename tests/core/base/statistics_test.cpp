// Student's distribution, against printed tables and closed forms; quantiles of values.
#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace asperity {
namespace {

/// Two-sided quantiles 0.95 and 0.99 (Abramowitz and Stegun, table 26.10).
TEST(Statistics, StudentsDistributionIsThatOfTheTables) {
  struct Row {
    int degreesOfFreedom;
    double t95, t99;
  };
  constexpr double kRounding = 5.1e-4;  // of the table
  for (const Row& row : {Row{1, 12.706, 63.657}, Row{2, 4.303, 9.925}, Row{3, 3.182, 5.841},
                         Row{4, 2.776, 4.604}, Row{9, 2.262, 3.250}, Row{30, 2.042, 2.750}}) {
    for (const auto& [t, probability] : {std::pair{row.t95, 0.95}, std::pair{row.t99, 0.99}}) {
      EXPECT_LT(studentProbability(t - kRounding, row.degreesOfFreedom), probability)
          << row.degreesOfFreedom;
      EXPECT_GT(studentProbability(t + kRounding, row.degreesOfFreedom), probability)
          << row.degreesOfFreedom;
    }
  }
}

/// One degree of freedom has Cauchy's distribution, two have t = p sqrt(2 / (1 - p^2)); many have
/// the normal one.
TEST(Statistics, FewResidualsNeedMoreStandardErrors) {
  const double p = std::erf(3 / std::numbers::sqrt2);
  EXPECT_NEAR(studentDeviations(3, 1), std::tan(0.5 * std::numbers::pi * p), 1e-6);
  EXPECT_NEAR(studentDeviations(3, 2), p * std::sqrt(2 / (1 - p * p)), 1e-9);
  EXPECT_NEAR(studentDeviations(3, 100000), 3, 1e-3);
  for (int degreesOfFreedom = 1; degreesOfFreedom < 40; ++degreesOfFreedom)
    EXPECT_GT(studentDeviations(3, degreesOfFreedom), studentDeviations(3, degreesOfFreedom + 1));
}

/// Where degrees of freedom are those of rows that are alike, their number is small and not whole.
TEST(Statistics, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(studentQuantile(1), 12.706205, 1e-6);
  EXPECT_NEAR(studentQuantile(2), 4.302653, 1e-6);
  EXPECT_NEAR(studentQuantile(6), 2.446912, 1e-6);
  EXPECT_NEAR(studentQuantile(7), 2.364624, 1e-3);
  EXPECT_NEAR(studentQuantile(15), 2.131450, 1e-4);
  EXPECT_NEAR(studentQuantile(30), 2.042272, 1e-5);
  EXPECT_NEAR(studentQuantile(1e9), 1.959964, 1e-6);
}

/// Between whole freedoms the distribution is continuous and, by quadrature of its density, exact.
TEST(Statistics, TheFreedomIsAnyPositiveNumber) {
  for (const double degreesOfFreedom : {1.0, 2.0, 3.0, 9.0})
    for (const double t : {0.5, 2.0, 12.0})
      EXPECT_NEAR(studentProbability(t, degreesOfFreedom + 1e-9),
                  studentProbability(t, degreesOfFreedom), 1e-8);
  for (const double degreesOfFreedom : {0.7, 1.5, 2.5, 6.9}) {
    const double t = studentQuantile(degreesOfFreedom);
    constexpr int kSteps = 100000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double at = t * (i + 0.5) / kSteps;
      sum += std::pow(1 + at * at / degreesOfFreedom, -0.5 * (degreesOfFreedom + 1)) * t / kSteps;
    }
    const double density =
        std::exp(std::lgamma(0.5 * (degreesOfFreedom + 1)) - std::lgamma(0.5 * degreesOfFreedom)) /
        std::sqrt(degreesOfFreedom * std::numbers::pi);
    EXPECT_NEAR(2 * density * sum, 0.95, 1e-6) << degreesOfFreedom;
  }
}

TEST(Statistics, QuantilesLieBetweenTheValues) {
  const std::vector<double> values{1, 2, 4, 8};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 8);
  EXPECT_EQ(quantile(values, 0.5), median(values));
  EXPECT_NEAR(quantile(values, 0.25), 1.75, 1e-15);
  EXPECT_EQ(quantile(std::vector<double>{3}, 0.7), 3);
}

TEST(Statistics, TheRootMeanSquareHasNoSign) {
  EXPECT_NEAR(rms(std::vector<double>{-3, 4}), std::sqrt(12.5), 1e-15);
  EXPECT_TRUE(std::isnan(rms({})));
}

}  // namespace
}  // namespace asperity
