#include "core/contact/line/prepared_profile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

TEST(PreparedProfile, StartsAndEndsAtTheLowestPoint) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(300), scheme);
    EXPECT_EQ(line.heightAboveMinimum.front(), 0);
    EXPECT_EQ(line.heightAboveMinimum.back(), 0);
    EXPECT_GE(*std::min_element(line.heightAboveMinimum.begin(), line.heightAboveMinimum.end()), 0);
    EXPECT_EQ(line.position(0), 0);
    EXPECT_EQ(line.position(line.segments()), line.length);
    for (std::size_t i = 0; i < line.segments(); ++i)
      EXPECT_GT(line.position(i + 1), line.position(i));
    EXPECT_EQ(line.heightAboveMinimum.size(), line.segments() + 1);
  }
}

/// The lowest point of a smooth line lies between nodes; only `cubic` knows it.
TEST(PreparedProfile, CubicStartsInsideASegment) {
  const Line line = roughLine(300);
  const PreparedProfile cubic = prepareProfile(line, Scheme::Cubic);
  const PreparedProfile linear = prepareProfile(line, Scheme::Linear);
  EXPECT_TRUE(cubic.startsInsideSegment);
  EXPECT_FALSE(linear.startsInsideSegment);
  EXPECT_LT(cubic.lowestHeight, linear.lowestHeight);
  EXPECT_EQ(cubic.segments(), linear.segments() + 1);
}

TEST(PreparedProfile, BoundsHoldEverywhereInTheirSegment) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(300, 2), scheme);
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

/// Blocks of every size, those at the end of a vector too.
TEST(PreparedProfile, BlocksAreTheirSegmentsTogether) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const std::int64_t elements : {3, 5, 6, 38, 99, 1000}) {
      const PreparedProfile line = prepareProfile(roughLine(elements), scheme);
      for (std::size_t level = 0; level < line.blocks.size(); ++level)
        for (std::size_t i = 0; i < line.blockCount(level); ++i) {
          const SegmentBounds block = line.block(level, i);
          const std::size_t size = std::size_t{1} << (2 * level);
          SegmentBounds all{1, 0, -1, 0, 0};
          for (std::size_t k = 0; k < size; ++k) {
            const SegmentBounds one = line.bounds(1 + i * size + k);
            all.lowest = std::min(all.lowest, one.lowest);
            all.highest = std::max(all.highest, one.highest);
            all.steepest = std::max(all.steepest, one.steepest);
            all.heightIntegral += one.heightIntegral;
            all.slopeSquared += one.slopeSquared;
          }
          EXPECT_EQ(block.lowest, all.lowest);
          EXPECT_EQ(block.highest, all.highest);
          EXPECT_EQ(block.steepest, all.steepest);
          EXPECT_NEAR(block.heightIntegral, all.heightIntegral, 1e-14 * all.heightIntegral);
          EXPECT_NEAR(block.slopeSquared, all.slopeSquared, 1e-14 * all.slopeSquared);
        }
      EXPECT_EQ(line.blockCount(0), line.segments() - 2);
    }
}

TEST(PreparedProfile, ValuesReturnToTheNodesTheyCameFrom) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const Line line = roughLine(101);
    const PreparedProfile profile = prepareProfile(line, scheme);
    const std::vector<double> rises(profile.heightAboveMinimum.begin(),
                                    profile.heightAboveMinimum.end() - 1);
    const std::vector<double> ordered = inLineOrder(profile, rises);
    ASSERT_EQ(ordered.size(), line.nodes());
    for (std::size_t i = 0; i < line.nodes(); ++i)
      // Beside the lowest point rises are told apart better than heights are.
      EXPECT_NEAR(ordered[i], line.height[i] - profile.lowestHeight, 1e-15 * line.rmsHeight);
  }
}

/// Nothing but the search for the lowest point is done after it is told to stop.
TEST(PreparedProfile, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    PreparedProfile profile;
    EXPECT_FALSE(prepareProfileInto(profile, roughLine(100), scheme, stop.get_token()));
    EXPECT_TRUE(profile.heightAboveMinimum.empty());
    EXPECT_TRUE(prepareProfileInto(profile, roughLine(100), scheme));
    EXPECT_FALSE(profile.heightAboveMinimum.empty());
  }
}

/// Lines of a curve are prepared in the memory of the line before, which may be longer and of
/// another scheme.
TEST(PreparedProfile, MemoryOfAnotherLineLeavesNothing) {
  for (const Scheme before : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
    for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
      PreparedProfile used = prepareProfile(roughLine(1000), before);
      const Line line = roughLine(100);
      ASSERT_TRUE(prepareProfileInto(used, line, scheme));
      const PreparedProfile fresh = prepareProfile(line, scheme);
      EXPECT_EQ(used.heightAboveMinimum, fresh.heightAboveMinimum);
      EXPECT_EQ(used.blocks.size(), fresh.blocks.size());
      EXPECT_EQ(used.meanHeight, fresh.meanHeight);
      EXPECT_EQ(used.slopeSquaredIntegral, fresh.slopeSquaredIntegral);
      double slopes = 0;
      for (std::size_t i = 0; scheme != Scheme::Nodal && i < used.segments(); ++i)
        slopes += used.bounds(i).slopeSquared;
      EXPECT_NEAR(used.slopeSquaredIntegral, slopes, 1e-13 * slopes);
    }
}

}  // namespace
}  // namespace asperity
