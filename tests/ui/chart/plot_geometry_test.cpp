// Places, targets, zoom and panning of a plot, without a widget.
#include "ui/chart/plot_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

const PlotGeometry kMap{QRectF(100, 50, 600, 300), {-3, 3}, {-4, -1}, QRectF(100, 360, 600, 80)};

Plot samplePlot() {
  Plot plot;
  plot.series = {{"law", PlotStyle::Line, false, {{1e-2, 1e-2}}},
                 {"points", PlotStyle::Points, false, {{1e-1, 1e-2}, {1, 1e-2}, {1.02, 1e-2}}}};
  plot.marker = PlotMarker{"now", "v", 10, 1e-3};
  plot.spans = {{"I", "linear", {}, 1e-3, 0.1, false}, {"II", "transition", {}, 0.1, 1e3, false}};
  plot.strip = PlotStrip{"difference", "", "", -10, 10, false, {{0.1, 3}, {1, -4}}};
  return plot;
}

QPointF at(double x, double y) {
  return {kMap.xOf(x), kMap.yOf(y)};
}

TEST(PlotGeometry, ValuesGoToPixelsAndBack) {
  EXPECT_DOUBLE_EQ(kMap.xOf(1), 400);
  EXPECT_DOUBLE_EQ(kMap.yOf(1e-4), 350);
  for (const double value : {1e-3, 0.02, 7.0, 1e3})
    EXPECT_NEAR(kMap.valueAt(kMap.xOf(value)) / value, 1, 1e-12);
}

TEST(PlotGeometry, FindsTheNearestPoint) {
  const PlotTarget target = targetAt(kMap, samplePlot(), at(1, 1e-2) + QPointF(-3, 2));
  EXPECT_EQ(target.series, 1);
  EXPECT_EQ(target.point, 1);
  EXPECT_FALSE(target.isMarker);
  EXPECT_FALSE(targetAt(kMap, samplePlot(), at(1, 1e-2) + QPointF(0, 12)).isPoint());
  EXPECT_FALSE(targetAt(kMap, samplePlot(), at(1e-2, 1e-2)).isPoint()) << "a line has no points";
}

TEST(PlotGeometry, FindsTheMarkerAtAnyHeight) {
  for (const double y : {2e-4, 5e-2})
    EXPECT_TRUE(targetAt(kMap, samplePlot(), at(10, y) + QPointF(5, 0)).isMarker);
  EXPECT_FALSE(targetAt(kMap, samplePlot(), at(10, 1e-2) + QPointF(8, 0)).isMarker);
}

TEST(PlotGeometry, FindsNamesAndStrip) {
  EXPECT_EQ(targetAt(kMap, samplePlot(), QPointF(kMap.xOf(5), 40)).span, 1);
  EXPECT_EQ(targetAt(kMap, samplePlot(), QPointF(kMap.xOf(0.01), 40)).span, 0);
  EXPECT_EQ(targetAt(kMap, samplePlot(), QPointF(kMap.xOf(1) + 4, 400)).stripPoint, 1);
  EXPECT_EQ(targetAt(kMap, samplePlot(), QPointF(10, 10)), PlotTarget{});
}

TEST(PlotGeometry, TheWheelZoomsTheAxesItIsOver) {
  EXPECT_TRUE(axesAt(kMap, {300, 200}).x && axesAt(kMap, {300, 200}).y);
  EXPECT_TRUE(axesAt(kMap, {300, 355}).x && !axesAt(kMap, {300, 355}).y);
  EXPECT_TRUE(!axesAt(kMap, {60, 200}).x && axesAt(kMap, {60, 200}).y);
  EXPECT_FALSE(axesAt(kMap, {60, 20}).x || axesAt(kMap, {60, 20}).y);
}

TEST(PlotGeometry, ZoomKeepsThePlaceUnderThePointer) {
  const QPointF place = at(0.3, 2e-3);
  const PlotWindow window = zoomed(kMap, place, 0.5, {true, true});
  const PlotGeometry next{kMap.area, window.x, window.y, {}};
  EXPECT_NEAR(next.xOf(0.3), place.x(), 1e-9);
  EXPECT_NEAR(next.yOf(2e-3), place.y(), 1e-9);
  EXPECT_NEAR(window.x.size(), 3, 1e-12);
  EXPECT_EQ(zoomed(kMap, place, 0.5, {true, false}).y, kMap.y);
  EXPECT_NEAR(zoomed(kMap, place, 1e-9, {true, true}).x.size(), 0.1, 1e-12) << "not endlessly";
}

TEST(PlotGeometry, PanningMovesWithThePointer) {
  const PlotWindow window = panned(kMap, {100, 100});
  const PlotGeometry next{kMap.area, window.x, window.y, {}};
  EXPECT_NEAR(next.xOf(1), kMap.xOf(1) + 100, 1e-9);
  EXPECT_NEAR(next.yOf(1e-2), kMap.yOf(1e-2) + 100, 1e-9);
}

TEST(PlotGeometry, AWindowIsHeldWhereThereIsSomethingToShow) {
  const PlotWindow whole{{-3, 3}, {-4, -1}};
  EXPECT_EQ(heldWithin(whole, whole), whole);
  const PlotWindow inside{{-1, 1}, {-3, -2}};
  EXPECT_EQ(heldWithin(inside, whole), inside);
  const PlotWindow far = heldWithin({{100, 102}, {-200, -190}}, whole);
  EXPECT_NEAR(far.x.from, 2, 1e-12) << "half of it beyond the end";
  EXPECT_NEAR(far.x.size(), 2, 1e-12);
  EXPECT_NEAR(far.y.to, -1, 1e-12) << "wider than all: all of it is seen";
  EXPECT_NEAR(far.y.size(), 10, 1e-12);
}

TEST(PlotGeometry, ACurveIsSeenBetweenItsPoints) {
  Plot plot;
  plot.series = {{QString(), PlotStyle::Points, false, {{1e-3, 1e-3}, {1e3, 1e-3}, {1e3, -1}}}};
  EXPECT_TRUE(showsCurves({{-0.1, 0.1}, {-3.1, -2.9}}, plot));
  EXPECT_FALSE(showsCurves({{-0.1, 0.1}, {-2.9, -2.7}}, plot));
  EXPECT_FALSE(showsCurves({{3.1, 4}, {-3.1, -2.9}}, plot));
  EXPECT_FALSE(showsCurves({{-3, 3}, {-4, 0}}, Plot{}));
}

}  // namespace
}  // namespace asperity
