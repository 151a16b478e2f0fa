// Contour lines of surfaces whose lines are known in closed form.
#include "core/chart/contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace asperity {
namespace {

struct Grid {
  std::vector<double> x, y, values;
};

Grid sampled(double from, double to, int n, const std::function<double(double, double)>& z) {
  Grid grid;
  for (int i = 0; i < n; ++i) grid.x.push_back(from + (to - from) * i / (n - 1));
  grid.y = grid.x;
  for (const double y : grid.y)
    for (const double x : grid.x) grid.values.push_back(z(x, y));
  return grid;
}

double lengthOf(const ContourLine& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    length += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
  return length;
}

/// On a plane linear interpolation is exact: z = 2 x + y - 0.3 has straight lines of known length.
TEST(Contours, OfAPlaneAreStraight) {
  const Grid grid = sampled(0, 1, 7, [](double x, double y) { return 2 * x + y - 0.3; });
  const auto lines = contourLines(grid.x, grid.y, grid.values, 1.05);
  ASSERT_EQ(lines.size(), 1U);
  for (const ContourPoint& place : lines[0]) EXPECT_NEAR(2 * place.x + place.y - 0.3, 1.05, 1e-14);
  // From (0.175, 1) to (0.675, 0).
  EXPECT_NEAR(lengthOf(lines[0]), std::hypot(0.5, 1.0), 1e-14);
}

/// Of z = x^2 + y^2 they are closed circles; linear interpolation is off by the square of the
/// spacing.
TEST(Contours, OfAParaboloidAreCircles) {
  double before = 0;
  for (const int n : {21, 41, 81}) {
    const Grid grid = sampled(-1, 1, n, [](double x, double y) { return x * x + y * y; });
    const auto lines = contourLines(grid.x, grid.y, grid.values, 0.49);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].front(), lines[0].back());
    double worst = 0;
    for (const ContourPoint& place : lines[0])
      worst = std::max(worst, std::abs(std::hypot(place.x, place.y) - 0.7));
    EXPECT_LT(worst, 2.0 / (n - 1) * 2.0 / (n - 1));
    if (before > 0) {
      EXPECT_GT(before / worst, 2.5);
    }
    before = worst;
  }
}

/// The lines of z = x y near 0 are hyperbolas, two of them for each level, which never cross.
TEST(Contours, OfASaddleAreTwo) {
  const Grid grid = sampled(-1, 1, 8, [](double x, double y) { return x * y; });
  for (const double level : {0.01, -0.01}) {
    const auto lines = contourLines(grid.x, grid.y, grid.values, level);
    ASSERT_EQ(lines.size(), 2U) << level;
    for (const ContourLine& line : lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        EXPECT_GE(line[i].x * line[i + 1].x, 0);  // each stays on its side
  }
}

TEST(Contours, AreInterruptedWhereNothingIsKnown) {
  Grid grid = sampled(0, 1, 9, [](double x, double) { return x; });
  grid.values[4 * 9 + 4] = std::numeric_limits<double>::quiet_NaN();
  const auto lines = contourLines(grid.x, grid.y, grid.values, 0.45);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lengthOf(lines[0]) + lengthOf(lines[1]), 1 - 2.0 / 8, 1e-14);
}

TEST(Contours, ThereAreNoneBesideTheRange) {
  const Grid grid = sampled(0, 1, 5, [](double x, double y) { return x + y; });
  EXPECT_TRUE(contourLines(grid.x, grid.y, grid.values, 2.1).empty());
  EXPECT_TRUE(contourLines(grid.x, grid.y, grid.values, -0.1).empty());
}

TEST(Contours, LevelsAreRound) {
  const std::vector<double> fifths = contourLevels(0, 1, false, 5);
  ASSERT_EQ(fifths.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(fifths[i], 0.2 * (static_cast<double>(i) + 1), 1e-15);
  const std::vector<double> decades = contourLevels(1e-6, 2e3, true, 9);
  ASSERT_EQ(decades.size(), 9U);
  EXPECT_NEAR(decades.front() / 1e-5, 1, 1e-12);
  EXPECT_NEAR(decades.back() / 1e3, 1, 1e-12);
  for (const auto& [from, to] : {std::pair{1e-8, 1e8}, {0.01, 0.3}, {0.99, 1.01}, {3.0, 80.0}}) {
    const std::vector<double> levels = contourLevels(from, to, true, 9);
    EXPECT_GE(levels.size(), 3U) << from;
    EXPECT_LE(levels.size(), 14U) << from;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      EXPECT_GT(levels[i], i > 0 ? levels[i - 1] : from);
      EXPECT_LT(levels[i], to);
    }
  }
  EXPECT_TRUE(contourLevels(1, 1, false, 5).empty());
  EXPECT_TRUE(contourLevels(0, 1, true, 5).empty());
}

/// As on a plateau whose values differ by their rounding alone.
TEST(Contours, LevelsOfARangeOfRoundingsEnd) {
  const double from = 1.2628984148934633e-05;
  double to = from;
  for (int roundings = 1; roundings < 40; ++roundings) {
    to = std::nextafter(to, 1);
    for (const bool isLogarithmic : {false, true}) {
      const std::vector<double> levels = contourLevels(from, to, isLogarithmic, 4);
      EXPECT_LE(levels.size(), 6U);
      for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_GT(levels[i], i > 0 ? levels[i - 1] : from);
        EXPECT_LT(levels[i], to);
      }
    }
  }
}

}  // namespace
}  // namespace asperity
