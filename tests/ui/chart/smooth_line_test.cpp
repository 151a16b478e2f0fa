#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/run/line_diagrams.h"
#include "core/surface/line.h"
#include "ui/chart/diagram_series.h"

namespace asperity {
namespace {

TEST(SmoothLine, PassesThroughTheNodesAndBetweenThem) {
  const double amplitude = 5e-7, length = 0.02;
  const Line line = sineLine(length, 48, amplitude, 4);
  const auto points = sampledLine(line, 1000);
  ASSERT_EQ(points.size(), 48U * 21 + 1);
  for (std::size_t i = 0; i < 48; ++i) EXPECT_EQ(points[21 * i].height, line.height[i]);
  EXPECT_EQ(points.back().x, length);
  EXPECT_EQ(points.back().height, points.front().height);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].x, points[i - 1].x);
  for (const LinePoint& point : points) {
    const double exact = amplitude * std::cos(8 * std::numbers::pi * point.x / length);
    // A cubic with 12 nodes a wave: h^4 / 384 of the fourth derivative.
    EXPECT_NEAR(point.height, exact, 2.1e-4 * amplitude);
  }
}

TEST(SmoothLine, ThreeNodesMakeARoundCrest) {
  const Line line = sineLine(0.02, 3, 5e-7, 1);
  const auto points = sampledLine(line, 600);
  const auto lowest = std::min_element(points.begin(), points.end(),
                                       [](auto& a, auto& b) { return a.height < b.height; });
  EXPECT_NEAR(lowest->x, 0.01, 1e-4);
  EXPECT_LT(lowest->height, -4e-7);  // the nodes reach -2.5e-7
}

TEST(SmoothLine, CornersAndStraightSidesStay) {
  const Line line = wedgeLine(0.02, 6, 1e-3);
  const auto points = sampledLine(line, 300);
  const double step = points[1].x - points[0].x;
  int corners = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double slope = (points[i].height - points[i - 1].height) / step;
    EXPECT_NEAR(std::abs(slope), 1e-3, 1e-9);
    if (i > 1) {
      const double before = (points[i - 1].height - points[i - 2].height) / step;
      corners += before * slope < 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(corners, 1);  // the other one is the end of the period
}

TEST(SmoothLine, ManyNodesAreTakenAsTheyAre) {
  Line line = sineLine(0.02, 5000, 5e-7, 4);
  EXPECT_EQ(sampledLine(line, 1280).size(), 5001U);
  line = sineLine(0.02, 10, 5e-7, 1);
  line.slopeAfter.clear();
  EXPECT_EQ(sampledLine(line, 1280).size(), 11U);
  EXPECT_TRUE(sampledLine(Line{}, 1280).empty());
}

TEST(Thinned, KeepsTheEndsAndTheExtremesOfEveryColumn) {
  std::vector<DrawPoint> places;
  for (int i = 0; i <= 100000; ++i)
    places.push_back({static_cast<float>(i) * 0.01F, static_cast<float>((i * 7919) % 1009)});
  const auto kept = thinned(places);
  EXPECT_LE(kept.size(), 2U * 1001 + 2);
  EXPECT_EQ(kept.front().x, places.front().x);
  EXPECT_EQ(kept.back().x, places.back().x);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](auto& a, auto& b) { return a.x < b.x; }));
  const auto lower = [](const DrawPoint& a, const DrawPoint& b) { return a.y < b.y; };
  EXPECT_EQ(std::min_element(kept.begin(), kept.end(), lower)->y, 0);
  EXPECT_EQ(std::max_element(kept.begin(), kept.end(), lower)->y, 1008);
  const std::vector<DrawPoint> few{{0, 1}, {5, 2}, {9, 0}};
  EXPECT_EQ(thinned(few).size(), 3U);
  EXPECT_EQ(thinned({{1, 2}}).size(), 1U);
  EXPECT_TRUE(thinned({}).empty());
}

}  // namespace
}  // namespace asperity
