// Pins, axes and differences of the friction diagram, without a widget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"
#include "ui/chart/friction_plot.h"

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

const PlotSeries* seriesOf(const Plot& plot, int id) {
  for (const PlotSeries& series : plot.series)
    if (series.id == id) return &series;
  return nullptr;
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

  FrictionPlot diagram_;
};

TEST_F(PinnedCurves, StayWhileTheSceneChanges) {
  EXPECT_EQ(diagram_.pin(), 0) << "nothing to pin yet";
  show(smallScene());
  const auto before = seriesOf(diagram_.plot(), kPresentCurve)->points;
  const int id = diagram_.pin();
  ASSERT_GT(id, 0);
  EXPECT_EQ(diagram_.pin(), 0) << "it is kept already";
  show(stiff());
  const Plot plot = diagram_.plot();
  ASSERT_TRUE(seriesOf(plot, id));
  EXPECT_EQ(seriesOf(plot, id)->points, before);
  EXPECT_NE(seriesOf(plot, kPresentCurve)->points, before);
}

TEST_F(PinnedCurves, AreNamedByWhatDiffers) {
  show(smallScene());
  const int id = diagram_.pin();
  EXPECT_EQ(seriesOf(diagram_.plot(), id)->name, QStringLiteral("same parameters"));
  diagram_.expect(stiff());
  EXPECT_EQ(seriesOf(diagram_.plot(), id)->name, QStringLiteral("G = 10 MPa"));
}

TEST_F(PinnedCurves, ACurveInTheMakingSaysHowFarItWas) {
  CurveUpdate part = curveOf(smallScene());
  part.realizationsDone = 1;
  part.realizationsTotal = 200;
  part.isComplete = false;
  diagram_.expect(smallScene());
  diagram_.take(part);
  const int id = diagram_.pin();
  EXPECT_EQ(seriesOf(diagram_.plot(), id)->name,
            QStringLiteral("same parameters (1 of 200 lines)"));
  diagram_.take(curveOf(smallScene()));
  EXPECT_GT(diagram_.pin(), id) << "with more lines it is another curve";
}

TEST_F(PinnedCurves, AreNeverFaded) {
  show(smallScene());
  const int id = diagram_.pin();
  diagram_.expect(stiff());
  const Plot plot = diagram_.plot();
  EXPECT_TRUE(seriesOf(plot, kPresentCurve)->faded);
  EXPECT_FALSE(seriesOf(plot, id)->faded);
}

TEST_F(PinnedCurves, KeepTheirColourWhenOthersGo) {
  std::vector<int> ids;
  for (const double factor : {1.0, 2.0, 3.0}) {
    Scene scene = smallScene();
    scene.elastomer.shearModulus *= factor;
    show(scene);
    ids.push_back(diagram_.pin());
  }
  const auto placeOf = [&](int id) { return seriesOf(diagram_.plot(), id)->place; };
  EXPECT_THAT((std::vector{placeOf(ids[0]), placeOf(ids[1]), placeOf(ids[2])}),
              ElementsAre(0, 1, 2));
  diagram_.unpin(ids[1]);
  const Plot without = diagram_.plot();
  EXPECT_EQ(seriesOf(without, ids[1]), nullptr);
  EXPECT_EQ(placeOf(ids[2]), 2);
  Scene next = smallScene();
  next.elastomer.shearModulus *= 5;
  show(next);
  const int again = diagram_.pin();
  EXPECT_EQ(placeOf(again), 1) << "the free place";
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
  const DecadeRange range = diagram_.plot().y.range;
  const PlotSeries pinned = *seriesOf(diagram_.plot(), id);
  for (const PlotPoint& point : pinned.points) {
    EXPECT_LT(std::log10(point.y), range.to);
    EXPECT_GT(std::log10(point.y), range.from);
  }
  diagram_.unpinAll();
  EXPECT_LT(diagram_.plot().y.range.to, range.to) << "and shrinks without them";
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
  const PlotSeries series = *seriesOf(diagram_.plot(), kPresentCurve);
  for (const PlotPoint& point : series.points)
    EXPECT_EQ(diagram_.velocityOf(kPresentCurve, point.row),
              velocities[static_cast<std::size_t>(point.row)]);
  EXPECT_EQ(diagram_.velocityOf(kPresentCurve, 99), std::nullopt);
}

TEST_F(PinnedCurves, DimensionlessAxesScaleEveryCurveByItsOwn) {
  Scene slow = smallScene();
  slow.elastomer.relaxationTime *= 100;
  show(slow);
  const int id = diagram_.pin();
  show(smallScene());
  diagram_.setAxes(CurveAxes::Dimensionless);
  const Plot plot = diagram_.plot();
  const double ratio = seriesOf(plot, id)->points[3].x / seriesOf(plot, kPresentCurve)->points[3].x;
  EXPECT_NEAR(ratio, 100, 1e-9);
  const CurveUpdate curve = curveOf(smallScene());
  const PlotSeries present = *seriesOf(plot, kPresentCurve);
  for (const PlotPoint& point : present.points) {
    const CurvePoint& row = curve.points[static_cast<std::size_t>(point.row)];
    EXPECT_NEAR(point.y / row.normalizedMu, 1, 1e-12);
    EXPECT_NEAR(point.x / row.dimensionlessVelocity, 1, 1e-12);
  }
  EXPECT_EQ(plot.spans.front().from, seriesOf(plot, kPresentCurve)->points.front().x);
  EXPECT_TRUE(plot.x.title.contains("∇z"));
}

TEST_F(PinnedCurves, TheMarkerFollowsTheAxesAndBack) {
  show(smallScene());
  Frame frame;
  Scene scene = smallScene();
  scene.sliding.velocity = 0.02;
  frame.scene = std::make_shared<const Scene>(scene);
  frame.rmsHeight = 5e-7;
  frame.rmsSlope = 1e-3;
  frame.muSteady = 2e-4;
  diagram_.mark(frame);
  diagram_.setAxes(CurveAxes::Dimensionless);
  const double vbar = 1e-3 * 0.02 * 1e-3 / (std::sqrt(2) * 5e-7);
  EXPECT_NEAR(diagram_.marker()->x / vbar, 1, 1e-12);
  EXPECT_NEAR(diagram_.marker()->y, 0.2, 1e-12);
  EXPECT_NEAR(*diagram_.velocityAt(vbar), 0.02, 1e-15);
}

TEST_F(PinnedCurves, WithoutARelaxationTimeAxesSayWhyTheyAreEmpty) {
  Scene solid = smallScene();
  solid.elastomer.rheology = Rheology::StandardSolid;
  solid.sweep.points = 5;
  show(solid);
  diagram_.setAxes(CurveAxes::Dimensionless);
  EXPECT_TRUE(diagram_.plot().blank.contains("one relaxation time"));
  EXPECT_TRUE(seriesOf(diagram_.plot(), kPresentCurve)->points.empty());
}

TEST_F(PinnedCurves, ADifferenceStandsInTheStripWhileItIsOfThisCurve) {
  show(smallScene());
  const CurveSetting setting{Scheme::Linear, 1, 2};
  diagram_.showDifference(curveDifference(smallScene(), setting));
  Plot plot = diagram_.plot();
  ASSERT_TRUE(plot.strip);
  EXPECT_FALSE(plot.strip->faded);
  EXPECT_EQ(plot.strip->points.size(), 21U);
  EXPECT_LT(plot.strip->from, 0);
  EXPECT_GT(plot.strip->to, 0);
  EXPECT_TRUE(plot.strip->name.contains("linear x1, 2 lines"));
  EXPECT_TRUE(diagram_.describe(kStripCurve, 3).contains("difference"));
  diagram_.expect(stiff());
  EXPECT_TRUE(diagram_.plot().strip->faded);
  EXPECT_EQ(diagram_.shown({})->pinned.size(), 0U);
  diagram_.showDifference(std::nullopt);
  EXPECT_FALSE(diagram_.plot().strip);
}

TEST_F(PinnedCurves, WhatIsShownCanBeWritten) {
  EXPECT_FALSE(diagram_.shown({}));
  show(smallScene());
  diagram_.pin();
  show(stiff());
  const CurveSet set = *diagram_.shown(PlotWindow{{-3, 2}, {-5, -1}});
  EXPECT_EQ(set.present.scene, stiff());
  ASSERT_EQ(set.pinned.size(), 1U);
  EXPECT_EQ(set.pinned[0].name, "G = 10 MPa");
  EXPECT_DOUBLE_EQ(set.xFrom, 1e-3);
  EXPECT_DOUBLE_EQ(set.yTo, 0.1);
}

}  // namespace
}  // namespace asperity
