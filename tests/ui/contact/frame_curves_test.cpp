#include "ui/contact/frame_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace asperity {
namespace {

Frame randomFrame(int points, double contactShare, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Frame frame;
  frame.length = 1;
  frame.spacing = 1.0 / points;
  for (int i = 0; i < points; ++i) {
    const bool contact = unit(random) < contactShare;
    frame.surfaceHeight.push_back(-unit(random));
    frame.lineHeight.push_back(frame.surfaceHeight.back() + (contact ? 0 : 0.5));
    frame.pressure.push_back(contact ? 1 + unit(random) : 0);
  }
  return frame;
}

std::size_t wrapped(std::int64_t index, std::int64_t points) {
  return static_cast<std::size_t>((index % points + points) % points);
}

bool covers(const std::vector<std::vector<CurveVertex>>& intervals, double x, double pixel) {
  return std::any_of(intervals.begin(), intervals.end(), [&](const auto& interval) {
    return x >= interval.front().x - pixel && x <= interval.back().x + pixel;
  });
}

TEST(Decimate, FewPointsAreAllThere) {
  const Frame frame = randomFrame(60, 0.3, 1);
  const PointRange range = pointsWithin(frame, 0.25, 1);
  const auto curve = decimated(frame, frame.lineHeight, range, {0.25, 1280});
  ASSERT_EQ(static_cast<std::int64_t>(curve.size()), range.count());
  EXPECT_LE(curve.front().x, 0.25);
  EXPECT_GE(curve.back().x, 1.25);
  for (const CurveVertex& v : curve) {
    EXPECT_EQ(v.height, frame.lineHeight[wrapped(std::lround(v.x * 60), 60)]);
  }
}

TEST(Decimate, AtMostTwoVerticesAColumnAndNoExtremeLost) {
  const Frame frame = randomFrame(100000, 0.3, 2);
  const PointRange range = pointsWithin(frame, -0.4, 1);
  const auto curve = decimated(frame, frame.lineHeight, range, {-0.4, 1000});
  EXPECT_LE(curve.size(), 2U * 1003);
  EXPECT_GT(curve.size(), 1900U);
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(),
                             [](const auto& a, const auto& b) { return a.x < b.x; }));
  const auto [low, high] = std::minmax_element(frame.lineHeight.begin(), frame.lineHeight.end());
  const auto byHeight = [](const auto& a, const auto& b) { return a.height < b.height; };
  EXPECT_EQ(std::min_element(curve.begin(), curve.end(), byHeight)->height, *low);
  EXPECT_EQ(std::max_element(curve.begin(), curve.end(), byHeight)->height, *high);
}

TEST(Decimate, NeverLosesAContact) {
  for (const int points : {1, 2, 60, 5000, 50000}) {
    for (const double share : {0.0001, 0.01, 0.5, 1.0}) {
      for (const double left : {0.0, 0.37, -5.2}) {
        Frame frame = randomFrame(points, share, static_cast<unsigned>(points));
        frame.pressure[static_cast<std::size_t>(points / 3)] = 5;  // at least one
        const PointRange range = pointsWithin(frame, left, 1);
        const double pixels = 777;
        const auto intervals = intervalsAbove(frame, range, {left, pixels}, frame.pressure, 0);
        EXPECT_LE(intervals.size(), 780U);
        double greatest = 0;
        for (const auto& interval : intervals) {
          ASSERT_FALSE(interval.empty());
          for (const CurveVertex& v : interval) greatest = std::max(greatest, v.value);
        }
        EXPECT_EQ(greatest, 5);
        for (std::int64_t i = range.first; i <= range.last; ++i) {
          if (frame.pressure[wrapped(i, points)] == 0) continue;
          ASSERT_TRUE(covers(intervals, static_cast<double>(i) * frame.spacing, 1 / pixels));
        }
      }
    }
  }
}

TEST(Decimate, LightsOnlyPointsInContact) {
  const Frame frame = randomFrame(5000, 0.1, 7);
  for (const auto& interval :
       intervalsAbove(frame, pointsWithin(frame, 0, 1), {0, 640}, frame.pressure, 0))
    for (const CurveVertex& v : interval) {
      EXPECT_GT(frame.pressure[wrapped(std::lround(v.x * 5000), 5000)], 0);
    }
}

TEST(Decimate, OnePointAloneIsAInterval) {
  Frame frame = randomFrame(5000, 0, 3);
  frame.pressure[4999] = 2;
  const auto intervals =
      intervalsAbove(frame, pointsWithin(frame, 0.1, 1), {0.1, 1280}, frame.pressure, 0);
  ASSERT_EQ(intervals.size(), 1U);
  EXPECT_EQ(intervals[0].size(), 1U);
  EXPECT_NEAR(intervals[0][0].x, 4999 / 5000.0, 1e-12);
}

TEST(Decimate, RefusesFramesWithoutSense) {
  Frame frame;
  EXPECT_FALSE(isDrawable(frame));
  frame = randomFrame(5, 1, 1);
  EXPECT_TRUE(isDrawable(frame));
  frame.pressure.pop_back();
  EXPECT_FALSE(isDrawable(frame));
  frame = randomFrame(5, 1, 1);
  frame.spacing = 0;
  EXPECT_FALSE(isDrawable(frame));
  frame.spacing = 1e-9;
  EXPECT_EQ(pointsWithin(frame, 1e30, 1).count(), 0);
}

// ---- Narrow contacts

/// 100 points, a millimetre apart, nowhere in contact; the smallest gap is at point 37.
Frame apart() {
  Frame frame;
  frame.length = 0.1;
  frame.spacing = 1e-3;
  for (int i = 0; i < 100; ++i) frame.lineHeight.push_back(1e-6 * (1 + std::abs(i - 37)));
  frame.surfaceHeight.assign(100, 0);
  frame.pressure.assign(100, 0);
  return frame;
}

TEST(NarrowContact, SmallestGapWhereContactLiesBetweenPoints) {
  Frame frame = apart();
  EXPECT_FALSE(narrowContact(frame, 1e-3));  // nothing touches
  frame.state.normalForce = 1;
  EXPECT_EQ(narrowContact(frame, 1e-3), 37U);
  frame.lineHeight[20] = std::nan("");
  EXPECT_EQ(narrowContact(frame, 1e-3), 37U);
}

TEST(NarrowContact, GreatestPressureOfPointsAlone) {
  Frame frame = apart();
  frame.pressure[10] = 1;
  EXPECT_EQ(narrowContact(frame, 1e-9), 10U);
  frame.pressure[60] = 3;
  EXPECT_EQ(narrowContact(frame, 1e-9), 60U);
  EXPECT_EQ(greatestPressure(frame), 3);
}

TEST(NarrowContact, PressuresOfPointsAreLeftOutWhereContactLiesBetweenThem) {
  Frame frame = apart();
  frame.pressure[10] = 3;
  EXPECT_EQ(greatestPressure(frame), 3);
  frame.steadyPressure = std::nan("");
  EXPECT_EQ(greatestPressure(frame), 0);
  EXPECT_EQ(narrowContact(frame, 1e-9), 10U);  // it still has its mark
}

TEST(NarrowContact, NoneWhereAIntervalIsWide) {
  Frame frame = apart();
  for (int i = 50; i <= 55; ++i) frame.pressure[static_cast<std::size_t>(i)] = 1;
  EXPECT_FALSE(narrowContact(frame, 4.9e-3));
  EXPECT_TRUE(narrowContact(frame, 5.1e-3));
}

TEST(NarrowContact, IntervalAcrossTheEndOfThePeriod) {
  Frame frame = apart();
  for (const std::size_t i : {98U, 99U, 0U, 1U}) frame.pressure[i] = 1;
  EXPECT_FALSE(narrowContact(frame, 2.9e-3));
  EXPECT_TRUE(narrowContact(frame, 3.1e-3));
}

TEST(NarrowContact, FullContactIsWideAndDamagedFramesHaveNone) {
  Frame frame = apart();
  frame.pressure.assign(100, 1);
  EXPECT_FALSE(narrowContact(frame, 0.05));
  EXPECT_FALSE(narrowContact(Frame{}, 1));
  frame.pressure.assign(100, std::nan(""));
  frame.state.normalForce = 1;
  EXPECT_EQ(narrowContact(frame, 1e-3), 37U);
  EXPECT_EQ(greatestPressure(frame), 0);
}

}  // namespace
}  // namespace asperity
