// Places, targets, zoom and panning of a chart, without a widget.
#include "ui/chart/chart_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

const ChartGeometry kMap{QRectF(100, 50, 600, 300), {-3, 3}, {-4, -1}};
const ChartGeometry kBelow{
    QRectF(100, 360, 600, 80), {-3, 3}, {-10, 10}, AxisScale::Logarithmic, AxisScale::Linear};

DiagramSheet sampleSheet() {
  DiagramSeries law, points;
  law.id = -2;
  law.points = {{1e-2, 1e-2}};
  points.id = 0;
  points.mark = SeriesMark::Circle;
  points.points = {{1e-1, 1e-2}, {1, 1e-2}, {1.02, 1e-2}};
  Diagram diagram;
  diagram.series = {law, points};
  diagram.marker = DiagramMarker{"now", "v", 10, 1e-3};
  diagram.spans = {{1e-3, 0.1, "I linear", "I"}, {0.1, 1e3, "II transition", "II"}};
  Diagram below;
  below.y.scale = AxisScale::Linear;
  DiagramSeries difference = points;
  difference.id = -3;
  difference.points = {{0.1, 3}, {1, -4}};
  below.series = {difference};
  DiagramSheet sheet;
  sheet.diagrams = {diagram, below};
  return sheet;
}

ChartTarget targetAt(QPointF place) {
  return asperity::targetAt({kMap, kBelow}, sampleSheet(), place);
}

QPointF at(double x, double y) {
  return {kMap.mapX(x), kMap.mapY(y)};
}

TEST(ChartGeometryTest, ValuesGoToPixelsAndBack) {
  EXPECT_DOUBLE_EQ(kMap.mapX(1), 400);
  EXPECT_DOUBLE_EQ(kMap.mapY(1e-4), 350);
  EXPECT_GT(kMap.mapY(0), 350) << "below a logarithmic axis";
  for (const double value : {1e-3, 0.02, 7.0, 1e3})
    EXPECT_NEAR(kMap.xAt(kMap.mapX(value)) / value, 1, 1e-12);
}

TEST(ChartGeometryTest, FindsTheNearestPoint) {
  const ChartTarget target = targetAt(at(1, 1e-2) + QPointF(-3, 2));
  EXPECT_EQ(target.series, 1);
  EXPECT_EQ(target.point, 1);
  EXPECT_FALSE(target.isMarker);
  EXPECT_FALSE(targetAt(at(1, 1e-2) + QPointF(0, 12)).isPoint());
  EXPECT_FALSE(targetAt(at(1e-2, 1e-2)).isPoint()) << "a line has no points";
}

TEST(ChartGeometryTest, FindsTheMarkerAtAnyHeight) {
  for (const double y : {2e-4, 5e-2}) EXPECT_TRUE(targetAt(at(10, y) + QPointF(5, 0)).isMarker);
  EXPECT_FALSE(targetAt(at(10, 1e-2) + QPointF(8, 0)).isMarker);
}

TEST(ChartGeometryTest, FindsNamesAndStrip) {
  EXPECT_EQ(targetAt(QPointF(kMap.mapX(5), 40)).span, 1);
  EXPECT_EQ(targetAt(QPointF(kMap.mapX(0.01), 40)).span, 0);
  EXPECT_EQ(targetAt(QPointF(kMap.mapX(1) + 4, 400)).diagram, 1);
  EXPECT_EQ(targetAt(QPointF(kMap.mapX(1) + 4, 400)).point, 1);
  EXPECT_EQ(targetAt(QPointF(10, 10)), ChartTarget{});
}

TEST(ChartGeometryTest, TheWheelZoomsTheAxesItIsOver) {
  EXPECT_TRUE(axesAt(kMap, {300, 200}).x && axesAt(kMap, {300, 200}).y);
  EXPECT_TRUE(axesAt(kMap, {300, 355}).x && !axesAt(kMap, {300, 355}).y);
  EXPECT_TRUE(!axesAt(kMap, {60, 200}).x && axesAt(kMap, {60, 200}).y);
  EXPECT_FALSE(axesAt(kMap, {60, 20}).x || axesAt(kMap, {60, 20}).y);
}

TEST(ChartGeometryTest, ZoomKeepsThePlaceUnderThePointer) {
  const QPointF place = at(0.3, 2e-3);
  const VisibleRange window = zoomed(kMap, place, 0.5, {true, true});
  const ChartGeometry next{kMap.area, window.x, window.y};
  EXPECT_NEAR(next.mapX(0.3), place.x(), 1e-9);
  EXPECT_NEAR(next.mapY(2e-3), place.y(), 1e-9);
  EXPECT_NEAR(window.x.size(), 3, 1e-12);
  EXPECT_EQ(zoomed(kMap, place, 0.5, {true, false}).y, kMap.y);
  EXPECT_NEAR(zoomed(kMap, place, 1e-9, {true, true}).x.size(), 0.1, 1e-12) << "not endlessly";
}

TEST(ChartGeometryTest, PanningMovesWithThePointer) {
  const VisibleRange window = panned(kMap, {100, 100});
  const ChartGeometry next{kMap.area, window.x, window.y};
  EXPECT_NEAR(next.mapX(1), kMap.mapX(1) + 100, 1e-9);
  EXPECT_NEAR(next.mapY(1e-2), kMap.mapY(1e-2) + 100, 1e-9);
}

TEST(ChartGeometryTest, AWindowIsHeldWhereThereIsSomethingToShow) {
  const VisibleRange whole{{-3, 3}, {-4, -1}};
  EXPECT_EQ(clampedTo(whole, whole), whole);
  const VisibleRange inside{{-1, 1}, {-3, -2}};
  EXPECT_EQ(clampedTo(inside, whole), inside);
  const VisibleRange far = clampedTo({{100, 102}, {-200, -190}}, whole);
  EXPECT_NEAR(far.x.from, 2, 1e-12) << "half of it beyond the end";
  EXPECT_NEAR(far.x.size(), 2, 1e-12);
  EXPECT_NEAR(far.y.to, -1, 1e-12) << "wider than all: all of it is seen";
  EXPECT_NEAR(far.y.size(), 10, 1e-12);
}

TEST(ChartGeometryTest, ACurveIsSeenBetweenItsPoints) {
  Diagram diagram;
  DiagramSeries series;
  series.points = {{1e-3, 1e-3}, {1e3, 1e-3}, {1e3, -1}};
  diagram.series = {series};
  EXPECT_TRUE(showsCurves({{-0.1, 0.1}, {-3.1, -2.9}}, diagram));
  EXPECT_FALSE(showsCurves({{-0.1, 0.1}, {-2.9, -2.7}}, diagram));
  EXPECT_FALSE(showsCurves({{3.1, 4}, {-3.1, -2.9}}, diagram));
  EXPECT_FALSE(showsCurves({{-3, 3}, {-4, 0}}, Diagram{}));
}

/// A marker that stands at a point leaves it, also where values are negative.
TEST(ChartGeometry, TheNextPointIsAnotherOne) {
  Diagram diagram;
  diagram.x.scale = diagram.y.scale = AxisScale::Linear;
  DiagramSeries curve, other;
  curve.id = 3;
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) curve.points.push_back({x, 1});
  curve.points.push_back({0.75, std::nan("")});
  other.points = {{0.1, 1}};
  diagram.series = {other, curve};
  const auto next = [&](double x, bool isForward) {
    const DiagramPoint* point = nextPoint(diagram, 3, x, isForward);
    return point ? point->x : 99;
  };
  EXPECT_EQ(next(-0.5, true), 0);
  EXPECT_EQ(next(-0.5, false), -1);
  EXPECT_EQ(next(0, true), 0.5);
  EXPECT_EQ(next(0.5 * (1 + 1e-12), true), 1);
  EXPECT_EQ(next(1, true), 99);
  EXPECT_EQ(next(-1, false), 99);
}

}  // namespace
}  // namespace asperity
