// The label of a point on the chart: it hides no curve where there is room for it.
#include "ui/window/lesson/prediction_point.h"

#include <gtest/gtest.h>

#include <QTest>

#include "core/chart/curve_diagram.h"
#include "ui/chart/chart_view.h"

namespace asperity {
namespace {

/// Curves at all heights up to the middle; the upper half of the frame is free.
DiagramSheet crowdedSheet() {
  Diagram diagram;
  diagram.x = {"x", "", AxisScale::Linear, 0, 1};
  diagram.y = {"y", "", AxisScale::Linear, 0, 1};
  for (int i = 0; i < 21; ++i) {
    DiagramSeries series;
    series.id = kPresentCurve;
    series.points = {{0, 0.025 * i}, {1, 0.025 * i}};
    diagram.series.push_back(series);
  }
  DiagramSheet sheet;
  sheet.diagrams = {diagram};
  return sheet;
}

TEST(PredictionPoint, ItsLabelGoesToFreeRoomFartherAway) {
  ChartView chart;
  chart.resize(800, 500);
  chart.setTheme(printTheme());
  chart.setSheet(crowdedSheet());
  chart.show();
  QTest::qWait(1);  // the layout is made with the first events
  PredictionPoint point(chart);
  point.showDecided(0.5, 0.3, PredictionPoint::Whose::Computed);
  point.grab();
  const QRectF label = point.label();
  ASSERT_FALSE(label.isEmpty());
  EXPECT_LT(label.bottom(), chart.mapToPosition(0.5, 0.5).y());
  EXPECT_GE(label.top(), chart.mapToPosition(0.5, 1).y() - 1);
  EXPECT_FALSE(chart.covered().greatestUnder(toBox(label)) > 0);
}

TEST(PredictionPoint, ItsLabelIsBesideItWhereThatIsFree) {
  ChartView chart;
  chart.resize(800, 500);
  chart.setTheme(printTheme());
  chart.setSheet(crowdedSheet());
  chart.show();
  QTest::qWait(1);
  PredictionPoint point(chart);
  point.showDecided(0.5, 0.85, PredictionPoint::Whose::Computed);
  point.grab();
  const QPointF at = chart.mapToPosition(0.5, 0.85);
  EXPECT_TRUE(point.label().adjusted(-15, -15, 15, 15).contains(at));
}

TEST(PredictionPoint, ItsLabelDoesNotLieOnThatOfTheMarker) {
  ChartView chart;
  chart.resize(800, 500);
  chart.setTheme(printTheme());
  DiagramSheet sheet = crowdedSheet();
  sheet.diagrams[0].series.resize(1);
  DiagramMarker marker;
  marker.x = 0.5;
  marker.y = 0.8;
  marker.label = Message::name("v = 10 mm/s");
  sheet.diagrams[0].marker = marker;
  chart.setSheet(sheet);
  chart.show();
  QTest::qWait(1);
  // Beside the line of the marker, where its label is: at the foot of the frame.
  PredictionPoint point(chart);
  point.showDecided(0.56, 0.03, PredictionPoint::Whose::Computed);
  point.grab();
  const QPointF foot = chart.mapToPosition(0.5, 0);
  const QRectF ofMarker(foot + QPointF(6, -22), QSizeF(50, 12));  // inside the marker's label
  ASSERT_FALSE(point.label().isEmpty());
  EXPECT_FALSE(point.label().intersects(ofMarker));
}

}  // namespace
}  // namespace asperity
