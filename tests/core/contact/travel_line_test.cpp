#include "core/contact/travel_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

TEST(TravelLine, StartsAndEndsAtTheLowestPoint) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
    for (const Direction direction : {Direction::Forward, Direction::Backward}) {
      const TravelLine line = prepareTravel(roughLine(300), scheme, direction);
      EXPECT_EQ(line.rise.front(), 0);
      EXPECT_EQ(line.rise.back(), 0);
      EXPECT_GE(*std::min_element(line.rise.begin(), line.rise.end()), 0);
      EXPECT_EQ(line.position.front(), 0);
      EXPECT_NEAR(line.position.back(), line.length, 1e-15 * line.length);
      EXPECT_TRUE(std::is_sorted(line.position.begin(), line.position.end()));
      EXPECT_EQ(line.rise.size(), line.segments() + 1);
    }
}

/// The lowest point of a smooth line lies between nodes; only `cubic` knows it.
TEST(TravelLine, CubicStartsInsideASegment) {
  const Line line = roughLine(300);
  const TravelLine cubic = prepareTravel(line, Scheme::Cubic);
  const TravelLine linear = prepareTravel(line, Scheme::Linear);
  EXPECT_TRUE(cubic.startsInsideSegment);
  EXPECT_FALSE(linear.startsInsideSegment);
  EXPECT_LT(cubic.lowestHeight, linear.lowestHeight);
  EXPECT_EQ(cubic.segments(), linear.segments() + 1);
}

TEST(TravelLine, BoundsHoldEverywhereInTheirSegment) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const TravelLine line = prepareTravel(roughLine(300, 2), scheme);
    for (std::size_t i = 0; i < line.segments(); ++i) {
      const Cubic rise = line.segment(i);
      const SegmentBounds bounds = line.bounds(i);
      for (int k = 0; k <= 20; ++k) {
        const double t = k / 20.0;
        EXPECT_GE(rise(t), bounds.lowest - 1e-21);
        EXPECT_LE(rise(t), bounds.highest + 1e-21);
        EXPECT_LE(rise.derivative(t) / line.segmentLength(i), bounds.steepest + 1e-15);
      }
    }
  }
}

TEST(TravelLine, ValuesReturnToTheNodesTheyCameFrom) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
    for (const Direction direction : {Direction::Forward, Direction::Backward}) {
      const Line line = roughLine(101);
      const TravelLine travel = prepareTravel(line, scheme, direction);
      const std::vector<double> rises(travel.rise.begin(), travel.rise.end() - 1);
      const std::vector<double> ordered = inLineOrder(travel, rises, direction);
      ASSERT_EQ(ordered.size(), line.nodes());
      for (std::size_t i = 0; i < line.nodes(); ++i)
        // Beside the lowest point rises are told apart better than heights are.
        EXPECT_NEAR(ordered[i], line.height[i] - travel.lowestHeight, 1e-15 * line.rmsHeight);
    }
}

/// Nothing but the search for the lowest point is done after it is told to stop.
TEST(TravelLine, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    TravelLine travel;
    EXPECT_FALSE(
        prepareTravelInto(travel, roughLine(100), scheme, Direction::Forward, stop.get_token()));
    EXPECT_TRUE(travel.rise.empty());
    EXPECT_TRUE(prepareTravelInto(travel, roughLine(100), scheme));
    EXPECT_FALSE(travel.rise.empty());
  }
}

}  // namespace
}  // namespace asperity
