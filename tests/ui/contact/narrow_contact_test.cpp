#include "ui/contact/narrow_contact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

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
  frame.normalForce = 1;
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

TEST(NarrowContact, NoneWhereAStretchIsWide) {
  Frame frame = apart();
  for (int i = 50; i <= 55; ++i) frame.pressure[static_cast<std::size_t>(i)] = 1;
  EXPECT_FALSE(narrowContact(frame, 4.9e-3));
  EXPECT_TRUE(narrowContact(frame, 5.1e-3));
}

TEST(NarrowContact, StretchAcrossTheEndOfThePeriod) {
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
  frame.normalForce = 1;
  EXPECT_EQ(narrowContact(frame, 1e-3), 37U);
  EXPECT_EQ(greatestPressure(frame), 0);
}

}  // namespace
}  // namespace asperity
