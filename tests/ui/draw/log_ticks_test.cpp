#include "ui/draw/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/number_text.h"

namespace asperity {
namespace {

std::string labels(double from, double to, int most) {
  std::string all;
  for (const Tick& tick : logTicks(from, to, most)) all += tick.label + " ";
  return all;
}

TEST(LogTicks, PowersOfTen) {
  EXPECT_EQ(powerOfTen(0), "10⁰");
  EXPECT_EQ(powerOfTen(-12), "10⁻¹²");
  EXPECT_EQ(powerOfTen(307), "10³⁰⁷");
}

TEST(LogTicks, EveryDecadeWhereTheyFit) {
  EXPECT_EQ(labels(-2, 2, 10), "10⁻² 10⁻¹ 10⁰ 10¹ 10² ");
  EXPECT_EQ(labels(-1.99, 1.99, 10), "10⁻¹ 10⁰ 10¹ ");
}

TEST(LogTicks, ThinnedToRoundExponents) {
  EXPECT_EQ(labels(-20, 1, 5), "10⁻²⁰ 10⁻¹⁵ 10⁻¹⁰ 10⁻⁵ 10⁰ ");
  EXPECT_EQ(labels(-7.2, 6.8, 3), "10⁻⁴ 10⁰ 10⁴ ");
}

TEST(LogTicks, MultiplesWhereDecadesAreFew) {
  EXPECT_EQ(labels(2.2, 3.8, 10), "2×10² 5×10² 10³ 2×10³ 5×10³ ");
  EXPECT_EQ(labels(0.45, 0.65, 10), "3 4 ");
  EXPECT_EQ(labels(-1.05, -0.25, 10), "0.1 0.2 0.5 ");
  EXPECT_EQ(labels(-1.8, 0.1, 10), "0.02 0.05 0.1 0.2 0.5 1 ");
  EXPECT_EQ(labels(-2.8, -1.2, 10), "2×10⁻³ 5×10⁻³ 10⁻² 2×10⁻² 5×10⁻² ");
}

/// One label alone says nothing of the scale.
TEST(LogTicks, TwoWhereThereAreLessThanTwoDecades) {
  EXPECT_EQ(labels(2.2, 3.8, 2), "2×10² 5×10³ ");
  EXPECT_EQ(labels(0.1, 1.9, 4), "3 10 30 ");
  for (double from = -9; from < 9; from += 0.37)
    for (double width = 0.8; width < 2.5; width *= 1.1)
      for (const int most : {2, 3, 4, 5, 9}) {
        const auto count = static_cast<int>(logTicks(from, from + width, most).size());
        EXPECT_GE(count, 2) << from << " " << width << " " << most;
      }
}

TEST(LogTicks, InsideAscendingAndNeverTooMany) {
  for (double from = -9; from < 9; from += 0.37) {
    for (double width = 0.05; width < 30; width *= 1.3) {
      for (const int most : {1, 2, 5, 9}) {
        const auto ticks = logTicks(from, from + width, most);
        EXPECT_LE(static_cast<int>(ticks.size()), most) << from << " " << width;
        double last = from - 1e-6;
        for (const Tick& tick : ticks) {
          EXPECT_GT(tick.value, last);
          EXPECT_LT(tick.value, from + width + 1e-6);
          last = tick.value;
        }
        if (width > 1 && most > 2) {
          EXPECT_GE(ticks.size(), 1U) << from << " " << width << " " << most;
        }
      }
    }
  }
}

TEST(LogTicks, NoneWithoutSense) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(logTicks(1, 1, 5).empty());
  EXPECT_TRUE(logTicks(2, 1, 5).empty());
  EXPECT_TRUE(logTicks(0, 5, 0).empty());
  EXPECT_TRUE(logTicks(-inf, 5, 5).empty());
  EXPECT_TRUE(logTicks(0, std::nan(""), 5).empty());
}

std::vector<double> minor(double from, double to, int most, double decadePixels) {
  return minorLogTicks(from, to, logTicks(from, to, most), decadePixels, 3);
}

TEST(MinorLogTicks, AreTheMultiplesBetweenTheDecades) {
  const std::vector<double> all = minor(-1, 1, 10, 100);
  ASSERT_EQ(all.size(), 16U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(std::pow(10, all[i]), 0.1 * static_cast<double>(i + 2), 1e-12);
    EXPECT_NEAR(std::pow(10, all[i + 8]), static_cast<double>(i + 2), 1e-12);
  }
}

TEST(MinorLogTicks, AreFewerWhereTheyWouldCrowd) {
  EXPECT_EQ(minor(-1, 1, 10, 30).size(), 4U);    // 2 and 5
  EXPECT_EQ(minor(-1, 1, 10, 10).size(), 0U);    // every decade has its label
  EXPECT_EQ(minor(-10, 10, 5, 10).size(), 16U);  // the decades between the labels
  EXPECT_EQ(minor(-10, 10, 5, 2).size(), 0U);
}

TEST(MinorLogTicks, NeverStandAtATick) {
  for (double to = 0.2; to < 3; to += 0.17)
    for (const Tick& tick : logTicks(0, to, 8))
      for (const double place : minorLogTicks(0, to, logTicks(0, to, 8), 200, 3))
        EXPECT_GT(std::abs(place - tick.value), 1e-6);
  EXPECT_TRUE(minorLogTicks(1, 1, {}, 100, 3).empty());
  EXPECT_TRUE(minorLogTicks(0, std::numeric_limits<double>::infinity(), {}, 100, 3).empty());
}

}  // namespace
}  // namespace asperity
