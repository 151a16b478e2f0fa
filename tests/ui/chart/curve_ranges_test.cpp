// The ranges of the axes of a friction chart.
#include "ui/chart/curve_ranges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

AxisRange decadesAround(double low, double high) {
  return rangeAround({std::log10(low), std::log10(high)}, AxisScale::Logarithmic);
}

TEST(DecadeRanges, SurroundsTheData) {
  EXPECT_EQ(decadesAround(2e-5, 30), (AxisRange{-5, 2}));
  EXPECT_EQ(decadesAround(1e-5, 1e3), (AxisRange{-5, 3}));
  EXPECT_EQ(decadesAround(1, 1), (AxisRange{0, 1}));
  EXPECT_TRUE(rangeAround({}, AxisScale::Logarithmic).isEmpty());
}

TEST(DecadeRanges, GrowsAtOnceAndShrinksReluctantly) {
  const AxisRange shown{-6, -2};
  EXPECT_EQ(steadyRange(shown, {-7, -3}, false), (AxisRange{-7, -2}));
  EXPECT_EQ(steadyRange(shown, {-3, -2}, false), shown);
  EXPECT_EQ(steadyRange(shown, {-5, -2}, true), shown);
  EXPECT_EQ(steadyRange(shown, {-3, -2}, true), (AxisRange{-3, -2}));
  EXPECT_EQ(steadyRange({}, {-3, -2}, false), (AxisRange{-3, -2}));
  EXPECT_EQ(steadyRange(shown, {}, true), shown);
}

/// A range that nearly reaches zero begins there.
TEST(LinearRanges, LeaveAMargin) {
  EXPECT_EQ(rangeAround({10, 20}, AxisScale::Linear), (AxisRange{9.6, 20.4}));
  EXPECT_EQ(rangeAround({1, 26}, AxisScale::Linear), (AxisRange{0, 27}));
  EXPECT_EQ(rangeAround({5, 5}, AxisScale::Linear), (AxisRange{2.5, 7.5}));
  const AxisRange tiny = rangeAround({4e-15, 4e-15}, AxisScale::Linear);
  EXPECT_DOUBLE_EQ(tiny.from, 2e-15);
  EXPECT_DOUBLE_EQ(tiny.to, 6e-15);
  EXPECT_EQ(rangeAround({0, 0}, AxisScale::Linear), (AxisRange{-0.5, 0.5}));
}

/// A value that rises frame by frame moves the axis a few times, not each time.
TEST(LinearRanges, GrowInSteps) {
  AxisRange shown{0, 1};
  int changes = 0;
  for (double value = 1; value < 3; value *= 1.01) {
    const AxisRange next = grownRange(shown, rangeAround({0, value}, AxisScale::Linear));
    ASSERT_GE(next.to, value);
    changes += next == shown ? 0 : 1;
    shown = next;
  }
  EXPECT_LE(changes, 8);
  EXPECT_EQ(shown.from, 0) << "an end that did not move stays";
  EXPECT_LT(shown.to, 3.6);
  EXPECT_EQ(grownRange({}, {1, 2}), (AxisRange{1, 2}));
  EXPECT_EQ(grownRange({1, 2}, {}), (AxisRange{1, 2}));
}

}  // namespace
}  // namespace asperity
