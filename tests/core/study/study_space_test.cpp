// Points of a study: evenness of the samples, of the sequence of Sobol with the direction numbers
// of Joe and Kuo, moments of the distributions, and that a point is a function of the study and its
// number alone.
#include "core/study/study_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace asperity {
namespace {

StudyAxis rangeAxis(const char* key, double from, double to, bool isLogarithmic = false) {
  const Parameter* row = findParameter(key);
  StudyAxis axis{.columns = {{row, {}, {}}},
                 .range = ParameterRange{row, from, to, 1, isLogarithmic}};
  return axis;
}

StudyAxis listAxis(const char* key, std::vector<double> values) {
  StudyAxis axis;
  axis.columns = {{findParameter(key), std::move(values), {}}};
  return axis;
}

std::vector<double> pointOf(const StudySpace& space, std::int64_t index) {
  std::vector<double> point(space.columns());
  space.pointInto(index, point);
  return point;
}

TEST(Distribution, NormalQuantileInvertsTheErrorFunction) {
  for (double p = 1e-300; p < 0.5; p *= 7) {
    const double below = 0.5 * std::erfc(-normalQuantile(p) / std::numbers::sqrt2);
    EXPECT_NEAR(below / p, 1, 1e-12) << p;
    if (p > 1e-10) {
      EXPECT_NEAR(normalQuantile(1 - p), -normalQuantile(p), 1e-6) << p;
    }
  }
  EXPECT_NEAR(normalQuantile(0.5), 0, 1e-15);
  EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-13);
}

TEST(Distribution, HasItsMeanAndDeviation) {
  for (const DistributionKind kind :
       {DistributionKind::Normal, DistributionKind::Lognormal, DistributionKind::Uniform}) {
    const Distribution one{kind, 3, 0.8};
    constexpr int kCount = 200000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kCount; ++i) {
      const double x = one.quantile((i + 0.5) / kCount);
      sum += x;
      squares += x * x;
    }
    const double mean = sum / kCount;
    EXPECT_NEAR(mean, 3, 1e-4);
    EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 0.8, 2e-3);
  }
}

TEST(Distribution, StaysBetweenItsLimits) {
  const Distribution one{DistributionKind::Normal, 0.7, 0.2, 0.1, 1};
  double before = 0.1;
  for (int i = 0; i < 1000; ++i) {
    const double x = one.quantile((i + 0.5) / 1000);
    EXPECT_GE(x, before);
    EXPECT_LE(x, 1);
    before = x;
  }
  // What is cut off is spread over the rest: F((x - F(a)) / (F(b) - F(a))).
  const auto below = [](double x) {
    return 0.5 * std::erfc(-(x - 0.7) / 0.2 / std::numbers::sqrt2);
  };
  EXPECT_NEAR(below(one.quantile(0.3)), below(0.1) + 0.3 * (below(1) - below(0.1)), 1e-12);
}

TEST(StudySpace, AGridGoesThroughAllValuesTheLastFastest) {
  const StudySpace space(
      {listAxis("surface.hurst", {0.3, 0.7}), listAxis("load.normal_force", {1, 2, 3})},
      Sampling::Grid, 0, 1);
  ASSERT_EQ(space.size(), 6);
  EXPECT_EQ(pointOf(space, 0), (std::vector<double>{0.3, 1}));
  EXPECT_EQ(pointOf(space, 2), (std::vector<double>{0.3, 3}));
  EXPECT_EQ(pointOf(space, 3), (std::vector<double>{0.7, 1}));
}

TEST(StudySpace, ALatinHypercubeHasOnePointInEachPartOfEachAxis) {
  for (const std::int64_t count : {1, 2, 37, 1000}) {
    const StudySpace space(
        {rangeAxis("surface.hurst", 0, 1), rangeAxis("load.normal_force", 1e-3, 10, true)},
        Sampling::LatinHypercube, count, 5);
    std::set<std::int64_t> first, second;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::vector<double> point = pointOf(space, i);
      first.insert(static_cast<std::int64_t>(point[0] * static_cast<double>(count)));
      const double part = std::log(point[1] / 1e-3) / std::log(1e4);
      second.insert(static_cast<std::int64_t>(part * static_cast<double>(count) - 1e-9));
    }
    EXPECT_EQ(static_cast<std::int64_t>(first.size()), count);
    EXPECT_GE(static_cast<std::int64_t>(second.size()), count - 1);  // by rounding of the logarithm
  }
}

TEST(StudySpace, AxesOfALatinHypercubeAreInDifferentOrders) {
  constexpr std::int64_t kCount = 4000;
  const StudySpace space({rangeAxis("surface.hurst", 0, 1), rangeAxis("surface.slope", 0, 1)},
                         Sampling::LatinHypercube, kCount, 1);
  double products = 0;
  for (std::int64_t i = 0; i < kCount; ++i) {
    const std::vector<double> point = pointOf(space, i);
    products += (point[0] - 0.5) * (point[1] - 0.5);
  }
  EXPECT_NEAR(12 * products / kCount, 0, 4 / std::sqrt(kCount));
}

TEST(StudySpace, ASaltelliDesignExchangesOneCoordinateAtATime) {
  const StudySpace space({rangeAxis("surface.hurst", 0, 1), rangeAxis("surface.slope", 0, 1),
                          rangeAxis("load.normal_force", 0, 1)},
                         Sampling::Saltelli, 64, 3);
  ASSERT_EQ(space.size(), 64 * 5);
  for (std::int64_t block = 0; block < 64; ++block) {
    const std::vector<double> a = pointOf(space, 5 * block), b = pointOf(space, 5 * block + 4);
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      EXPECT_EQ(pointOf(space, 5 * block + 1 + static_cast<std::int64_t>(i)), mixed);
      EXPECT_NE(a[i], b[i]);
    }
  }
}

TEST(StudySpace, TheSeedMakesOtherPoints) {
  for (const Sampling sampling : {Sampling::LatinHypercube, Sampling::Sobol}) {
    const auto space = [&](std::int64_t seed) {
      return StudySpace({rangeAxis("surface.hurst", 0, 1)}, sampling, 100, seed);
    };
    EXPECT_EQ(pointOf(space(1), 17), pointOf(space(1), 17));
    EXPECT_NE(pointOf(space(1), 17), pointOf(space(2), 17));
  }
}

TEST(StudySpace, WholeNumbersAreAllEquallyLikely) {
  const StudySpace space({rangeAxis("surface.seed", 1, 4)}, Sampling::Sobol, 400, 1);
  std::map<double, int> counts;
  for (std::int64_t i = 0; i < 400; ++i) ++counts[pointOf(space, i)[0]];
  ASSERT_EQ(counts.size(), 4U);
  for (const auto& [value, count] : counts) {
    EXPECT_EQ(value, std::round(value));
    EXPECT_NEAR(count, 100, 8);
  }
}

TEST(SobolSequence, BeginsAsThatOfJoeAndKuo) {
  // The example of their program, three dimensions.
  const double points[8][3] = {{0, 0, 0},          {.5, .5, .5},       {.75, .25, .25},
                               {.25, .75, .75},    {.375, .375, .625}, {.875, .875, .125},
                               {.625, .125, .875}, {.125, .625, .375}};
  for (std::uint32_t i = 0; i < 8; ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(sobolNumber(i, d) * 0x1p-32, points[i][d]) << i << " " << d;
}

TEST(SobolSequence, PutsOnePointInEachPartOfEveryAxis) {
  constexpr std::uint32_t kCount = 1024;
  for (int d = 0; d < kMaxSobolDimensions; ++d) {
    std::set<std::uint32_t> parts;
    for (std::uint32_t i = 0; i < kCount; ++i) parts.insert(sobolNumber(i, d) >> 22);
    EXPECT_EQ(parts.size(), kCount) << d;
  }
}

TEST(SobolSequence, FirstTwoDimensionsAreAnEvenNet) {
  // Every rectangle of 2^-j by 2^(j - 8) holds one of 256 points: a (0, 8, 2)-net.
  for (int j = 0; j <= 8; ++j) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < 256; ++i)
      cells.emplace(j == 0 ? 0 : sobolNumber(i, 0) >> (32 - j),
                    j == 8 ? 0 : sobolNumber(i, 1) >> (24 + j));
    EXPECT_EQ(cells.size(), 256U) << j;
  }
}

}  // namespace
}  // namespace asperity
