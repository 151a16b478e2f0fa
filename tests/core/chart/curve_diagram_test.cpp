#include "core/chart/curve_diagram.h"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_EQ(spans[0].label, "I linear");
  EXPECT_EQ(spans[3].label, "IV decrease");
  EXPECT_NE(sheet.note.find("read from the curve"), sheet.note.npos);
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
  EXPECT_EQ(below.series.back().points.size(), set.difference->points.size());
  const DiagramPoint& drawn = below.series.back().points[2];
  const DifferencePoint& computed = set.difference->points[2];
  EXPECT_NEAR(drawn.y, 100 * computed.relative, 1e-12);
  EXPECT_NEAR(drawn.high - drawn.y, 100 * computed.standardError, 1e-9);
  EXPECT_NEAR(drawn.y - drawn.low, 100 * computed.standardError, 1e-9);
}

}  // namespace
}  // namespace asperity
