// Student's distribution, against printed tables and closed forms.
#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <utility>

namespace asperity {
namespace {

/// Two-sided quantiles 0.95 and 0.99 (Abramowitz and Stegun, table 26.10).
TEST(Statistics, StudentsDistributionIsThatOfTheTables) {
  struct Row {
    int freedom;
    double t95, t99;
  };
  constexpr double kRounding = 5.1e-4;  // of the table
  for (const Row& row : {Row{1, 12.706, 63.657}, Row{2, 4.303, 9.925}, Row{3, 3.182, 5.841},
                         Row{4, 2.776, 4.604}, Row{9, 2.262, 3.250}, Row{30, 2.042, 2.750}}) {
    for (const auto& [t, probability] : {std::pair{row.t95, 0.95}, std::pair{row.t99, 0.99}}) {
      EXPECT_LT(studentProbability(t - kRounding, row.freedom), probability) << row.freedom;
      EXPECT_GT(studentProbability(t + kRounding, row.freedom), probability) << row.freedom;
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
  for (int freedom = 1; freedom < 40; ++freedom)
    EXPECT_GT(studentDeviations(3, freedom), studentDeviations(3, freedom + 1));
}

}  // namespace
}  // namespace asperity
