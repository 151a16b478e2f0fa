#include "core/chart/curve_diagram.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene smallScene() {
  return sceneOfSize(500, 17, 3);
}

NamedCurve curveOf(const Scene& scene, std::string name = {}, int place = 0) {
  return {std::move(name), scene, frictionCurve(scene).points, place};
}

TEST(CurveDiagram, ShadesAndNamesTheRegions) {
  const Scene scene = smallScene();
  const DiagramSheet sheet = curveSheet(scene, frictionCurve(scene).points);
  ASSERT_EQ(sheet.diagrams.size(), 1U);
  const auto& spans = sheet.diagrams.front().spans;
  ASSERT_EQ(spans.size(), 4U);
  EXPECT_EQ(spans[0].label.english(), "I linear");
  EXPECT_EQ(spans[3].label.english(), "IV decrease");
  EXPECT_EQ(spans[1].shortLabel, "II");
  EXPECT_THAT(sheet.note.english(), testing::HasSubstr("read from the curve"));
}

TEST(CurveDiagram, PinnedCurvesHaveMarksAndColoursOfTheirOwn) {
  const Scene scene = smallScene();
  Scene stiff = scene;
  stiff.elastomer.shearModulus *= 10;
  CurveSet set;
  set.present = curveOf(scene);
  for (int place = 0; place < 2 * kPinColours; ++place)
    set.pinned.push_back(curveOf(stiff, "G = 100 MPa", place));
  const auto series = curveSheet(set).diagrams.front().series;
  ASSERT_EQ(series.size(), set.pinned.size() + 2);
  for (std::size_t i = 0; i < series.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(series[i].colour == series[j].colour && series[i].mark == series[j].mark)
          << i << " and " << j << " look alike";
}

/// The first colour is the present curve's alone.
TEST(CurveDiagram, EightCurvesHaveEightColours) {
  std::set<int> colours{0};
  for (int place = 0; place < 7; ++place) colours.insert(colourOfPin(place));
  EXPECT_EQ(colours.size(), 8U);
}

/// However few velocities the sweep has: exactly Eq. (11) at every point, and no corners.
TEST(CurveDiagram, TheLawIsSampledFinely) {
  Scene scene = smallScene();
  scene.sweep = {1e-4, 1e2, 4};
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  const auto series = curveSheet(scene, points).diagrams.front().series;
  ASSERT_EQ(series.front().name, "Eq. (11)");
  const std::vector<DiagramPoint>& law = series.front().points;
  EXPECT_GT(law.size(), 100U);
  Scene fine = scene;
  fine.sweep.points = static_cast<std::int64_t>(law.size());
  const std::vector<CurvePoint> exact = frictionCurve(fine).points;
  for (std::size_t i = 0; i < law.size(); ++i) {
    EXPECT_NEAR(law[i].x / exact[i].velocity, 1, 1e-12);
    EXPECT_NEAR(law[i].y / exact[i].muLaw, 1, 1e-9);
  }
}

/// A scene whose lines differ in their slopes has another factor at each velocity.
TEST(CurveDiagram, DimensionlessPointsAreThoseOfTheTable) {
  Scene scene = smallScene();
  scene.surface.summitCorrelation = 2;
  CurveSet set;
  set.present = curveOf(scene);
  set.axes = CurveAxes::Dimensionless;
  const DiagramSeries mean = curveSheet(set).diagrams.front().series.back();
  ASSERT_EQ(mean.points.size(), set.present.points.size());
  for (std::size_t i = 0; i < mean.points.size(); ++i) {
    EXPECT_EQ(mean.points[i].x, set.present.points[i].dimensionlessVelocity);
    EXPECT_EQ(mean.points[i].y, set.present.points[i].normalizedMu);
  }
}

/// What lies beyond the axis stands at its end.
TEST(CurveDiagram, ADifferenceBeyondItsAxisIsATriangle) {
  CurveSet set;
  set.present = curveOf(smallScene());
  set.difference = CurveDifference{nullptr, {Scheme::Linear, 2, 3}, {}, 6, 6};
  set.difference->points = {{1e-3, 1, 0.1, 0.5, 0.1}, {1e-2, 1, 0.1, 7, 0.1}};
  const Diagram below = curveSheet(set).diagrams[1];
  EXPECT_EQ(below.y.to, 200);
  ASSERT_EQ(below.series.size(), 3U);
  EXPECT_EQ(below.series[1].points.size(), 2U);
  ASSERT_EQ(below.series[2].points.size(), 1U);
  EXPECT_EQ(below.series[2].mark, SeriesMark::Triangle);
  EXPECT_EQ(below.series[2].points[0].y, 200);
  EXPECT_EQ(below.series[2].points[0].row, 1);
}

TEST(CurveDiagram, DimensionlessAxesAreThoseOfEq13) {
  const Scene scene = smallScene();
  CurveSet set;
  set.present = curveOf(scene);
  set.axes = CurveAxes::Dimensionless;
  const auto series = curveSheet(set).diagrams.front().series;
  const LineSource source(scene, 2);
  const auto [height, slope] = source.statistics();
  for (std::size_t i = 0; i < set.present.points.size(); ++i) {
    const CurvePoint& point = set.present.points[i];
    const double vbar =
        scene.elastomer.relaxationTime * point.velocity * slope / (std::sqrt(2) * height);
    EXPECT_NEAR(series.back().points[i].x / vbar, 1, 1e-12);
    EXPECT_NEAR(series.back().points[i].y / (point.mu / slope), 1, 1e-12);
  }
}

TEST(CurveDiagram, WhatHasNoDimensionlessVelocityIsNotDrawnThere) {
  Scene scene = smallScene();
  scene.elastomer.rheology = Rheology::StandardSolid;
  scene.sweep.points = 5;
  CurveSet set;
  set.present = curveOf(scene);
  set.axes = CurveAxes::Dimensionless;
  const DiagramSheet sheet = curveSheet(set);
  for (const DiagramPoint& point : sheet.diagrams.front().series.back().points)
    EXPECT_TRUE(std::isnan(point.x));
}

TEST(CurveDiagram, ADifferenceStandsBelowOverTheSameAxis) {
  Scene scene = smallScene();
  CurveSet set;
  set.present = curveOf(scene);
  set.difference = curveDifference(scene, {Scheme::Linear, 2, 3});
  const DiagramSheet sheet = curveSheet(set);
  ASSERT_EQ(sheet.diagrams.size(), 2U);
  EXPECT_TRUE(sheet.sharesAxis);
  const Diagram &above = sheet.diagrams[0], &below = sheet.diagrams[1];
  EXPECT_LT(below.height, above.height);
  EXPECT_EQ(below.x.from, above.x.from);
  EXPECT_EQ(below.x.to, above.x.to);
  EXPECT_GT(above.x.to, scene.sweep.velocityTo);
  EXPECT_EQ(below.y.unit, "%");
  EXPECT_EQ(below.series[1].points.size(), set.difference->points.size());
  const DiagramPoint& drawn = below.series[1].points[2];
  const DifferencePoint& computed = set.difference->points[2];
  EXPECT_NEAR(drawn.y, 100 * computed.relative, 1e-12);
  EXPECT_NEAR(drawn.high - drawn.y, 100 * computed.standardError, 1e-9);
  EXPECT_NEAR(drawn.y - drawn.low, 100 * computed.standardError, 1e-9);
}

}  // namespace
}  // namespace asperity
