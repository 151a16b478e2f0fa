#include "ui/draw/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

double lengthOf(const Polyline& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    length += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
  return length;
}

TEST(Dashed, PiecesAndGapsOfAStraightLine) {
  const std::vector<Polyline> dashes = dashed({{0, 0}, {30, 40}}, 6, 4);
  ASSERT_EQ(dashes.size(), 5U);
  for (std::size_t i = 0; i < dashes.size(); ++i) {
    EXPECT_NEAR(lengthOf(dashes[i]), 6, 1e-4);
    EXPECT_NEAR(dashes[i].front().x, 0.6 * 10 * static_cast<double>(i), 1e-4);
    EXPECT_NEAR(dashes[i].front().y, 0.8 * 10 * static_cast<double>(i), 1e-4);
  }
}

/// Along a spiral of short segments the length counts, not the segments.
TEST(Dashed, LengthsFollowTheLineRoundItsCorners) {
  Polyline spiral;
  for (int i = 0; i < 4000; ++i) {
    const float t = 0.01F * static_cast<float>(i), r = 20 + 3 * t;
    spiral.push_back({r * std::cos(t), r * std::sin(t)});
  }
  const std::vector<Polyline> dashes = dashed(spiral, 7, 3);
  ASSERT_GT(dashes.size(), 100U);
  double dashLength = 0;
  for (std::size_t i = 0; i + 1 < dashes.size(); ++i) {
    EXPECT_NEAR(lengthOf(dashes[i]), 7, 0.01);
    EXPECT_GT(dashes[i].size(), 2U);  // corners are kept
    dashLength += lengthOf(dashes[i]);
  }
  EXPECT_NEAR(dashLength / lengthOf(spiral), 0.7, 0.005);
}

TEST(Dashed, DotsAreSinglePlaces) {
  const std::vector<Polyline> dots = dashed({{0, 0}, {10, 0}, {10, 10}}, 0, 2.5F);
  ASSERT_EQ(dots.size(), 9U);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    ASSERT_EQ(dots[i].size(), 1U);
    const float along = 2.5F * static_cast<float>(i);
    EXPECT_NEAR(dots[i][0].x, std::min(along, 10.0F), 1e-4);
    EXPECT_NEAR(dots[i][0].y, std::max(along - 10, 0.0F), 1e-4);
  }
}

TEST(Dashed, NothingComesOfNothing) {
  EXPECT_TRUE(dashed({}, 3, 2).empty());
  EXPECT_TRUE(dashed({{0, 0}, {1, 0}}, 3, 0).empty());
  EXPECT_EQ(dashed({{0, 0}, {1, 0}}, 3, 2).size(), 1U);
}

constexpr Box kBox{10, 20, 100, 50};

TEST(ClippedTo, KeepsWhatIsInsideAndCutsAtTheEdge) {
  const std::vector<Polyline> inside = clippedTo(kBox, {{20, 30}, {50, 60}, {90, 25}});
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_EQ(inside[0].size(), 3U);
  // A diagonal through the whole box leaves where x = 10 and x = 110.
  const std::vector<Polyline> through = clippedTo(kBox, {{-90, -5}, {210, 95}});
  ASSERT_EQ(through.size(), 1U);
  EXPECT_NEAR(through[0][0].x, 10, 1e-4);
  EXPECT_NEAR(through[0][0].y, 28.3333, 1e-3);
  EXPECT_NEAR(through[0][1].x, 110, 1e-4);
  EXPECT_NEAR(through[0][1].y, 61.6667, 1e-3);
}

TEST(ClippedTo, LeavesAndComesBackInSeveralParts) {
  const std::vector<Polyline> parts = clippedTo(kBox, {{20, 30}, {20, 200}, {60, 200}, {60, 30}});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].back().y, 70);
  EXPECT_EQ(parts[1].front().y, 70);
  EXPECT_TRUE(clippedTo(kBox, {{0, 0}, {200, 0}}).empty());
}

TEST(ClippedTo, BreaksWhereAPlaceIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(clippedTo(kBox, {{20, 30}, {30, 30}, {nan, 30}, {50, 30}, {60, 30}}).size(), 2U);
  EXPECT_TRUE(clippedTo(kBox, {{nan, 1}}).empty());
  EXPECT_EQ(clippedTo(kBox, {{20, 30}}).size(), 1U);
  EXPECT_TRUE(clippedTo(kBox, {{0, 0}}).empty());
}

}  // namespace
}  // namespace asperity
