// The error of a mean over rows of a topography: closed forms for rows of known correlation, the
// part of the stated intervals that contain the true mean, and independent rows, which keep the
// usual error.
#include "core/friction/line_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/base/statistics.h"
#include "core/friction/curve_difference.h"
#include "core/friction/jackknife.h"

namespace asperity {
namespace {

using Rows = std::vector<double>;

/// A stationary process of mean 0 and variance 1 whose correlation is r^k.
Rows autoregressive(std::mt19937_64& random, std::size_t count, double r) {
  std::normal_distribution<double> normal;
  Rows rows{normal(random)};
  while (rows.size() < count)
    rows.push_back(r * rows.back() + std::sqrt(1 - r * r) * normal(random));
  return rows;
}

/// Returns the variance of the mean of n such numbers (Priestley 1981, Section 5.3.2).
double varianceOfMean(double n, double r) {
  return ((1 + r) / (1 - r) - 2 * r * (1 - std::pow(r, n)) / (n * (1 - r) * (1 - r))) / n;
}

/// Moving averages over `width` independent numbers: the correlation falls linearly to 0.
Rows movingAverage(std::mt19937_64& random, std::size_t count, std::size_t width) {
  std::normal_distribution<double> normal;
  Rows numbers(count + width), rows;
  for (double& number : numbers) number = normal(random);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < width; ++j) sum += numbers[i + j];
    rows.push_back(sum / std::sqrt(static_cast<double>(width)));
  }
  return rows;
}

/// The mean square of the stated error, and how often the 95 % interval has the true mean 0.
struct Trial {
  double variance = 0, coverage = 0, degreesOfFreedom = 0;
};

Trial tryMany(int surfaces, const std::function<Rows(std::mt19937_64&)>& make) {
  std::mt19937_64 random(11);
  Trial trial;
  for (int i = 0; i < surfaces; ++i) {
    const Rows rows = make(random);
    RunningMean mean;
    for (const double row : rows) mean.add(row);
    const MeanError error = errorOfCorrelatedMean(rows);
    trial.variance += error.standardError * error.standardError / surfaces;
    trial.degreesOfFreedom += error.degreesOfFreedom / surfaces;
    if (std::abs(mean.mean()) < studentQuantile(error.degreesOfFreedom) * error.standardError)
      trial.coverage += 1.0 / surfaces;
  }
  return trial;
}

TEST(MeanErrorInOrder, IsThatOfTheClosedForm) {
  for (const double r : {0.3, 0.73, 0.9}) {
    const Trial trial =
        tryMany(600, [&](std::mt19937_64& random) { return autoregressive(random, 640, r); });
    EXPECT_NEAR(std::sqrt(trial.variance / varianceOfMean(640, r)), 1, 0.1) << r;
    EXPECT_GT(trial.coverage, 0.92) << r;
    EXPECT_LT(trial.coverage, 0.98) << r;
  }
}

/// The error of the mean of n moving averages over w numbers is nearly 1 / sqrt(n / w).
TEST(MeanErrorInOrder, FindsACorrelationOfAnyForm) {
  const Trial trial =
      tryMany(600, [](std::mt19937_64& random) { return movingAverage(random, 600, 12); });
  EXPECT_NEAR(std::sqrt(trial.variance * 600 / 12), 1, 0.12);
  EXPECT_GT(trial.coverage, 0.92);
  EXPECT_LT(trial.coverage, 0.98);
}

/// With few independent rows the error is badly known, and the interval is wider.
TEST(MeanErrorInOrder, HasFewDegreesOfFreedomForFewIndependentRows) {
  const Trial trial =
      tryMany(600, [](std::mt19937_64& random) { return movingAverage(random, 150, 24); });
  EXPECT_LT(trial.degreesOfFreedom, kFewDegreesOfFreedom);
  EXPECT_GT(trial.coverage, 0.89);
}

/// Each autocovariance lacks the variance of the mean. Where that is a large part, a sum that ends
/// at the first pair below 0 is too short, and the interval misses the mean once in seven times.
TEST(MeanErrorInOrder, AddsWhatTheSubtractedMeanTook) {
  const Trial trial =
      tryMany(4000, [](std::mt19937_64& random) { return autoregressive(random, 40, 0.9); });
  EXPECT_GT(trial.coverage, 0.88);
  EXPECT_NEAR(std::sqrt(trial.variance / varianceOfMean(40, 0.9)), 1, 0.15);
}

/// Rows that share short waves and, to a quarter of their variance, long ones: what correlation is
/// left at far rows is a large part of the error.
TEST(MeanErrorInOrder, FindsASmallCorrelationThatReachesFar) {
  const double slow = 0.25;
  const Trial trial = tryMany(600, [&](std::mt19937_64& random) {
    Rows rows = autoregressive(random, 800, 0.6);
    const Rows waves = autoregressive(random, 800, 0.95);
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = std::sqrt(1 - slow) * rows[i] + std::sqrt(slow) * waves[i];
    return rows;
  });
  const double variance = (1 - slow) * varianceOfMean(800, 0.6) + slow * varianceOfMean(800, 0.95);
  EXPECT_NEAR(std::sqrt(trial.variance / variance), 1, 0.1);
  EXPECT_GT(trial.coverage, 0.89);
}

TEST(MeanErrorInOrder, OfIndependentRowsIsTheUsualOne) {
  for (const std::size_t count : {20U, 100U, 640U}) {
    const Trial trial =
        tryMany(600, [&](std::mt19937_64& random) { return autoregressive(random, count, 0); });
    EXPECT_NEAR(std::sqrt(trial.variance * static_cast<double>(count)), 1, 0.04) << count;
    EXPECT_NEAR(trial.coverage, 0.95, 0.03) << count;
  }
  const Rows alternating{1, -1, 1, -1, 1, -1};
  RunningMean usual;
  for (const double row : alternating) usual.add(row);
  EXPECT_EQ(errorOfCorrelatedMean(alternating).standardError, usual.standardError());
  EXPECT_EQ(errorOfCorrelatedMean(alternating).degreesOfFreedom, 5);
}

TEST(MeanErrorInOrder, NeedsTwoNumbersThatDiffer) {
  EXPECT_TRUE(std::isnan(errorOfCorrelatedMean({}).standardError));
  EXPECT_TRUE(std::isnan(errorOfCorrelatedMean(Rows{3.0}).standardError));
  EXPECT_EQ(errorOfCorrelatedMean(Rows(50, 3.0)).standardError, 0);
}

TEST(LineMean, OfRepeatedRowsIsNoMoreCertain) {
  std::mt19937_64 random(3);
  const Rows rows = autoregressive(random, 100, 0.8);
  LineMean once(100), twice(100), lines;
  for (const int round : {1, 2})
    for (const double row : rows) {
      if (round == 1) once.add(row);
      twice.add(row);
      lines.add(row);
    }
  EXPECT_EQ(twice.count(), 200);
  EXPECT_EQ(once.error().standardError, twice.error().standardError);
  EXPECT_EQ(once.error().standardError, errorOfCorrelatedMean(rows).standardError);
  EXPECT_GT(once.error().standardError, 1.5 * lines.error().standardError);
  EXPECT_EQ(lines.error().degreesOfFreedom, 199);
}

/// Leaving out one number at a time, the pseudo-values of a mean are the numbers.
TEST(Jackknife, OfRowsHasTheErrorOfRows) {
  std::mt19937_64 random(4);
  const Rows rows = autoregressive(random, 80, 0.8);
  const auto read = [&](int leftOut) {
    double sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (static_cast<int>(i) != leftOut) sum += rows[i];
    return sum / static_cast<double>(leftOut < 0 ? rows.size() : rows.size() - 1);
  };
  const double expected = errorOfCorrelatedMean(rows).standardError;
  EXPECT_NEAR(jackknife(80, read, 80).standardError / expected, 1, 1e-9);
  EXPECT_LT(jackknife(80, read).standardError, 0.8 * expected);
}

TEST(PairedMeans, OfRowsHaveTheErrorOfTheDifferencesInOrder) {
  std::mt19937_64 random(5);
  const Rows noise = autoregressive(random, 200, 0.9), rest = autoregressive(random, 200, 0.9);
  PairedMeans pairs(200, 200), different(200, 100);
  Rows a, b;
  for (std::size_t i = 0; i < 200; ++i) {
    a.push_back(10 + noise[i]);
    b.push_back(12 + noise[i] + 0.1 * rest[i]);
  }
  for (std::size_t i = 0; i < 200; ++i) {
    pairs.addPair(a[i], b[i]);
    if (i < 100)
      different.addPair(a[i], b[2 * i]);
    else
      different.addOnlyA(a[i]);
  }
  const double ratio = pairs.ratio().value;
  Rows left;
  for (std::size_t i = 0; i < 200; ++i) left.push_back(b[i] - ratio * a[i]);
  EXPECT_NEAR(pairs.ratio().standardError,
              errorOfCorrelatedMean(left).standardError / pairs.meanA(), 1e-12);
  EXPECT_NEAR(pairs.standardErrorB(), errorOfCorrelatedMean(b).standardError, 1e-12);
  EXPECT_GT(different.ratio().standardError, pairs.ratio().standardError);
}

}  // namespace
}  // namespace asperity
