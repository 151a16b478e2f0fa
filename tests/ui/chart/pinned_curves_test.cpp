// Pins, axes and differences of the friction diagram, without a widget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"
#include "ui/chart/friction_chart_model.h"

namespace asperity {
namespace {

using testing::ElementsAre;

Scene smallScene() {
  return sceneOfSize(200, 21, 2);
}

CurveUpdate curveOf(const Scene& scene) {
  CurveUpdate update;
  update.scene = std::make_shared<const Scene>(scene);
  update.points = frictionCurve(scene).points;
  update.realizationsDone = update.realizationsTotal = scene.ensemble.realizations;
  update.isComplete = true;
  return update;
}

std::optional<DiagramSeries> seriesOf(const DiagramSheet& sheet, int id) {
  for (const Diagram& diagram : sheet.diagrams)
    for (const DiagramSeries& series : diagram.series)
      if (series.id == id) return series;
  return std::nullopt;
}

class PinnedCurves : public testing::Test {
 protected:
  void show(const Scene& scene) {
    diagram_.expect(scene);
    ASSERT_TRUE(diagram_.take(curveOf(scene)));
  }
  static Scene stiff() {
    Scene scene = smallScene();
    scene.elastomer.shearModulus *= 2;
    return scene;
  }

  FrictionChartModel diagram_;
};

TEST_F(PinnedCurves, StayWhileTheSceneChanges) {
  EXPECT_EQ(diagram_.pin(), 0) << "nothing to pin yet";
  show(smallScene());
  const auto before = seriesOf(diagram_.sheet(), kPresentCurve)->points;
  const int id = diagram_.pin();
  ASSERT_GT(id, 0);
  EXPECT_EQ(diagram_.pin(), 0) << "it is kept already";
  show(stiff());
  const DiagramSheet plot = diagram_.sheet();
  ASSERT_TRUE(seriesOf(plot, id));
  EXPECT_EQ(seriesOf(plot, id)->points, before);
  EXPECT_NE(seriesOf(plot, kPresentCurve)->points, before);
}

TEST_F(PinnedCurves, AreNamedByWhatDiffers) {
  show(smallScene());
  const int id = diagram_.pin();
  EXPECT_EQ(seriesOf(diagram_.sheet(), id)->name.english(), "same parameters");
  diagram_.expect(stiff());
  EXPECT_EQ(seriesOf(diagram_.sheet(), id)->name.english(), "G = 10 MPa");
}

TEST_F(PinnedCurves, ACurveInTheMakingSaysHowFarItWas) {
  CurveUpdate part = curveOf(smallScene());
  part.realizationsDone = 1;
  part.realizationsTotal = 200;
  part.isComplete = false;
  diagram_.expect(smallScene());
  diagram_.take(part);
  const int id = diagram_.pin();
  EXPECT_EQ(seriesOf(diagram_.sheet(), id)->name.english(), "same parameters, 1 of 200 lines");
  diagram_.take(curveOf(smallScene()));
  EXPECT_GT(diagram_.pin(), id) << "with more lines it is another curve";
}

TEST_F(PinnedCurves, AreNeverFaded) {
  show(smallScene());
  const int id = diagram_.pin();
  diagram_.expect(stiff());
  const DiagramSheet plot = diagram_.sheet();
  EXPECT_TRUE(seriesOf(plot, kPresentCurve)->isFaded);
  EXPECT_FALSE(seriesOf(plot, id)->isFaded);
}

TEST_F(PinnedCurves, KeepTheirColourWhenOthersGo) {
  std::vector<int> ids;
  for (const double factor : {1.0, 2.0, 3.0}) {
    Scene scene = smallScene();
    scene.elastomer.shearModulus *= factor;
    show(scene);
    ids.push_back(diagram_.pin());
  }
  const auto toQColor = [&](int id) { return seriesOf(diagram_.sheet(), id)->colour; };
  EXPECT_THAT((std::vector{toQColor(ids[0]), toQColor(ids[1]), toQColor(ids[2])}),
              ElementsAre(pinColour(0), pinColour(1), pinColour(2)));
  diagram_.unpin(ids[1]);
  const DiagramSheet without = diagram_.sheet();
  EXPECT_FALSE(seriesOf(without, ids[1]));
  EXPECT_EQ(toQColor(ids[2]), pinColour(2));
  Scene next = smallScene();
  next.elastomer.shearModulus *= 5;
  show(next);
  const int again = diagram_.pin();
  EXPECT_EQ(toQColor(again), pinColour(1)) << "the free place";
  EXPECT_GT(again, ids[2]) << "numbers are not used again";
  diagram_.unpinAll();
  EXPECT_TRUE(diagram_.pinned().empty());
}

TEST_F(PinnedCurves, TheRangeCoversThem) {
  Scene high = smallScene();
  high.surface.rmsHeight *= 1000;
  show(high);
  const int id = diagram_.pin();
  show(smallScene());
  const DiagramAxis axis = diagram_.sheet().diagrams[0].y;
  const DiagramSeries pinned = *seriesOf(diagram_.sheet(), id);
  for (const DiagramPoint& point : pinned.points) {
    EXPECT_LT(point.y, axis.to);
    EXPECT_GT(point.y, axis.from);
  }
  diagram_.unpinAll();
  EXPECT_LT(diagram_.sheet().diagrams[0].y.to, axis.to) << "and shrinks without them";
}

TEST_F(PinnedCurves, ReadingsTellTheCurveAndThePoint) {
  show(smallScene());
  const int id = diagram_.pin();
  show(stiff());
  const QString own = diagram_.describe(kPresentCurve, 4);
  EXPECT_TRUE(own.startsWith("v = ")) << own.toStdString();
  EXPECT_TRUE(own.contains("±") && own.contains("in contact"));
  EXPECT_TRUE(diagram_.describe(id, 4).startsWith("G = 10 MPa\nv = "));
  EXPECT_EQ(diagram_.describe(id, 400), QString());
  EXPECT_EQ(diagram_.describe(77, 0), QString());
}

TEST_F(PinnedCurves, APointHasExactlyItsVelocity) {
  show(smallScene());
  const std::vector<double> velocities = sweepVelocities(smallScene().sweep);
  const DiagramSeries series = *seriesOf(diagram_.sheet(), kPresentCurve);
  for (const DiagramPoint& point : series.points)
    EXPECT_EQ(diagram_.sweptValue(kPresentCurve, point.row),
              velocities[static_cast<std::size_t>(point.row)]);
  EXPECT_EQ(diagram_.sweptValue(kPresentCurve, 99), std::nullopt);
}

TEST_F(PinnedCurves, DimensionlessAxesScaleEveryCurveByItsOwn) {
  Scene slow = smallScene();
  slow.elastomer.relaxationTime *= 100;
  show(slow);
  const int id = diagram_.pin();
  show(smallScene());
  diagram_.setAxes(CurveAxes::Dimensionless);
  const DiagramSheet plot = diagram_.sheet();
  const double ratio = seriesOf(plot, id)->points[3].x / seriesOf(plot, kPresentCurve)->points[3].x;
  EXPECT_NEAR(ratio, 100, 1e-9);
  const CurveUpdate curve = curveOf(smallScene());
  const DiagramSeries present = *seriesOf(plot, kPresentCurve);
  for (const DiagramPoint& point : present.points) {
    const CurvePoint& row = curve.points[static_cast<std::size_t>(point.row)];
    EXPECT_NEAR(point.y / row.normalizedMu, 1, 1e-12);
    EXPECT_NEAR(point.x / row.dimensionlessVelocity, 1, 1e-12);
  }
  EXPECT_NEAR(plot.diagrams[0].spans.front().from / present.points.front().x, 1, 1e-12);
  EXPECT_NE(plot.diagrams[0].x.title.english().find("∇z"), std::string::npos);
}

TEST_F(PinnedCurves, TheMarkerFollowsTheAxesAndBack) {
  show(smallScene());
  Frame frame;
  Scene scene = smallScene();
  scene.sliding.velocity = 0.02;
  frame.scene = std::make_shared<const Scene>(scene);
  frame.rmsHeight = 5e-7;
  frame.rmsSlope = 1e-3;
  frame.state.mu = 2e-4;
  diagram_.mark(frame);
  diagram_.setAxes(CurveAxes::Dimensionless);
  const double vbar = 1e-3 * 0.02 * 1e-3 / (std::sqrt(2) * 5e-7);
  EXPECT_NEAR(diagram_.marker()->x / vbar, 1, 1e-12);
  EXPECT_NEAR(diagram_.marker()->y, 0.2, 1e-12);
  EXPECT_NEAR(*diagram_.sweptAt(vbar), 0.02, 1e-15);
}

TEST_F(PinnedCurves, WithoutARelaxationTimeAxesSayWhyTheyAreEmpty) {
  Scene solid = smallScene();
  solid.elastomer.rheology = Rheology::StandardSolid;
  solid.sweep.points = 5;
  show(solid);
  diagram_.setAxes(CurveAxes::Dimensionless);
  const Diagram diagram = diagram_.sheet().diagrams[0];
  EXPECT_NE(diagram.blank.english().find("one relaxation time"), std::string::npos);
  const DiagramSeries present = *seriesOf(diagram_.sheet(), kPresentCurve);
  for (const DiagramPoint& point : present.points) EXPECT_FALSE(hasPosition(diagram, point));
}

TEST_F(PinnedCurves, ADifferenceStandsInTheStripWhileItIsOfThisCurve) {
  show(smallScene());
  const CurveSetting setting{Scheme::Linear, 1, 2};
  diagram_.showDifference(curveDifference(smallScene(), setting));
  const DiagramSeries strip = *seriesOf(diagram_.sheet(), kDifferenceCurve);
  EXPECT_FALSE(strip.isFaded);
  EXPECT_EQ(strip.points.size(), 21U);
  const DiagramAxis axis = diagram_.sheet().diagrams[1].y;
  EXPECT_LT(axis.from, 0);
  EXPECT_GT(axis.to, 0);
  EXPECT_TRUE(strip.name.english().starts_with("linear x1, 2 lines"));
  EXPECT_TRUE(diagram_.describe(kDifferenceCurve, 3).contains("difference"));
  diagram_.expect(stiff());
  EXPECT_TRUE(seriesOf(diagram_.sheet(), kDifferenceCurve)->isFaded);
  EXPECT_EQ(diagram_.shown({})->pinned.size(), 0U);
  diagram_.showDifference(std::nullopt);
  EXPECT_EQ(diagram_.sheet().diagrams.size(), 1U);
}

TEST_F(PinnedCurves, WhatIsShownCanBeWritten) {
  EXPECT_FALSE(diagram_.shown({}));
  show(smallScene());
  diagram_.pin();
  show(stiff());
  const CurveSet set = *diagram_.shown(VisibleRange{{-3, 2}, {-5, -1}});
  EXPECT_EQ(set.present.scene, stiff());
  ASSERT_EQ(set.pinned.size(), 1U);
  EXPECT_EQ(set.pinned[0].name.english(), "G = 10 MPa");
  EXPECT_DOUBLE_EQ(set.xFrom, 1e-3);
  EXPECT_DOUBLE_EQ(set.yTo, 0.1);
}

}  // namespace
}  // namespace asperity
