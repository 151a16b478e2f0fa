// What the friction diagram shows, without a widget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ui/chart/decade_range.h"
#include "ui/chart/friction_plot.h"
#include "ui/chart/tick_label.h"

namespace asperity {
namespace {

using testing::ElementsAre;

CurvePoint point(double velocity, double mu, double error = kNotApplicable,
                 std::int64_t realizations = 2) {
  CurvePoint made;
  made.velocity = velocity;
  made.mu = mu;
  made.muStandardError = error;
  made.muLaw = 1e-3;
  made.realizations = realizations;
  return made;
}

CurveUpdate update(const Scene& scene, std::vector<CurvePoint> points, std::int64_t done = 2) {
  CurveUpdate made;
  made.scene = std::make_shared<const Scene>(scene);
  made.sceneNumber = 1;
  made.realizationsDone = done;
  made.realizationsTotal = 200;
  made.isComplete = done == 200;
  made.points = std::move(points);
  return made;
}

Frame frame(const Scene& scene, double mu) {
  Frame made;
  made.scene = std::make_shared<const Scene>(scene);
  made.muSteady = mu;
  return made;
}

const PlotSeries& seriesOf(const Plot& plot, PlotStyle style) {
  for (const PlotSeries& series : plot.series)
    if (series.style == style) return series;
  throw std::runtime_error("no such series");
}

std::vector<double> velocitiesOf(const PlotSeries& series) {
  std::vector<double> velocities;
  for (const PlotPoint& shown : series.points) velocities.push_back(shown.x);
  return velocities;
}

TEST(TickLabel, IsMultipliedByAPowerOfTenUnlessItIsZero) {
  const auto second = [](double to, const char* unit) {
    const AxisTicks axis = linearTicks(0, to, 4, unit);
    return labelWithUnit(axis.ticks[0], axis) + ", " + labelWithUnit(axis.ticks[1], axis);
  };
  EXPECT_EQ(second(0.004, ""), QStringLiteral("0, 2×10⁻³"));
  EXPECT_EQ(second(0.004, "%"), QStringLiteral("0 %, 2×10⁻³ %"));
  EXPECT_EQ(second(0.004, "m"), "0 mm, 2 mm");
  EXPECT_EQ(second(4, ""), "0, 2");
}

TEST(DecadeRange, SurroundsTheData) {
  EXPECT_EQ(decadesAround(2e-5, 30), (DecadeRange{-5, 2}));
  EXPECT_EQ(decadesAround(1e-5, 1e3), (DecadeRange{-5, 3}));
  EXPECT_EQ(decadesAround(1, 1), (DecadeRange{0, 1}));
}

TEST(DecadeRange, GrowsAtOnceAndShrinksReluctantly) {
  const DecadeRange shown{-6, -2};
  EXPECT_EQ(steadyRange(shown, {-7, -3}, false), (DecadeRange{-7, -2}));
  EXPECT_EQ(steadyRange(shown, {-3, -2}, false), shown);
  EXPECT_EQ(steadyRange(shown, {-5, -2}, true), shown);
  EXPECT_EQ(steadyRange(shown, {-3, -2}, true), (DecadeRange{-3, -2}));
  EXPECT_EQ(steadyRange({}, {-3, -2}, false), (DecadeRange{-3, -2}));
  EXPECT_EQ(steadyRange(shown, {}, true), shown);
}

TEST(DecadeRange, ReadingsReadLikePrint) {
  EXPECT_EQ(readingLabel(0.125), QStringLiteral("0.125"));
  EXPECT_EQ(readingLabel(2.5e-5), QStringLiteral("2.5×10⁻⁵"));
  EXPECT_EQ(readingLabel(1e-6), QStringLiteral("10⁻⁶"));
  EXPECT_EQ(readingLabel(0.01234, 2), QStringLiteral("0.012"));
  EXPECT_EQ(readingLabel(std::nan("")), QStringLiteral("–"));
  EXPECT_EQ(readingLabel(-0.41), QStringLiteral("−0.41"));
  EXPECT_EQ(readingLabel(-2.5e-5), QStringLiteral("−2.5×10⁻⁵"));
}

TEST(FrictionPlot, SkipsWhatHasNoPlaceOnLogarithmicAxes) {
  FrictionPlot diagram;
  const double nan = std::nan("");
  ASSERT_TRUE(diagram.take(update({}, {point(1e-3, 1e-4), point(1e-2, 0), point(0.1, -2e-3),
                                       point(1, nan), point(10, 2e-3), point(100, 5e-3, nan, 0)})));
  const Plot plot = diagram.plot();
  EXPECT_THAT(velocitiesOf(seriesOf(plot, PlotStyle::Points)), ElementsAre(1e-3, 10));
  EXPECT_EQ(seriesOf(plot, PlotStyle::Line).points.size(), 6U);
}

TEST(FrictionPlot, KeepsErrorsAndStatesHowFarItIs) {
  FrictionPlot diagram;
  diagram.take(update({}, {point(1, 1e-3, 2e-4)}, 37));
  const Plot plot = diagram.plot();
  EXPECT_EQ(seriesOf(plot, PlotStyle::Points).points.front().error, 2e-4);
  EXPECT_EQ(plot.note, QStringLiteral("37 of 200 realizations"));
  EXPECT_DOUBLE_EQ(plot.progress, 37.0 / 200);
}

TEST(FrictionPlot, MarksThePresentVelocityOfTheFrame) {
  FrictionPlot diagram;
  EXPECT_FALSE(diagram.plot().marker);
  Scene scene;
  scene.sliding.velocity = 0.25;
  diagram.mark(frame(scene, 3e-3));
  const Plot plot = diagram.plot();
  ASSERT_TRUE(plot.marker);
  EXPECT_EQ(plot.marker->x, 0.25);
  EXPECT_EQ(plot.marker->y, 3e-3);
  EXPECT_EQ(plot.marker->label, QStringLiteral("v = 0.25 m/s"));
}

Frame motionFrame(const std::vector<TransientSample>& samples) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Oscillation;
  scene.sliding.velocity = 0;
  scene.sliding.amplitude = 30;
  Frame moving = frame(scene, kNotApplicable);
  moving.velocity = samples.empty() ? 0 : samples.back().velocity;
  moving.transient = std::make_shared<const std::vector<TransientSample>>(samples);
  return moving;
}

TransientSample sample(double velocity, double mu) {
  TransientSample sample;
  sample.velocity = velocity;
  sample.mu = mu;
  return sample;
}

/// Friction of the moment over the magnitude of the velocity, and the way there.
TEST(FrictionPlot, AMotionMovesItsMarkerAndLeavesATrace) {
  FrictionPlot diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(motionFrame({sample(0.5, 1e-3), sample(-0.25, 8e-4)}));
  const Plot plot = diagram.plot();
  ASSERT_TRUE(plot.marker);
  EXPECT_TRUE(plot.marker->isFixed);
  EXPECT_EQ(plot.marker->x, 0.25);
  EXPECT_EQ(plot.marker->y, 8e-4);
  EXPECT_EQ(plot.marker->label, QStringLiteral("|v| = 0.25 m/s"));
  EXPECT_EQ(plot.marker->name, QStringLiteral("this motion, now"));
  ASSERT_EQ(plot.marker->trace.size(), 2U);
  EXPECT_EQ(plot.marker->trace[0].x, 0.5);
  EXPECT_EQ(plot.marker->trace[1].y, 8e-4);
}

/// At its turning points a motion is at rest, which has no place on a logarithmic axis.
TEST(FrictionPlot, AMotionAtItsTurningPointLeavesTheAxesAlone) {
  FrictionPlot diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(motionFrame({sample(0.5, 1e-3)}));
  const Plot before = diagram.plot();
  diagram.mark(motionFrame({sample(0.5, 1e-3), sample(1e-12, 1e-15)}));
  EXPECT_EQ(diagram.plot().x.range, before.x.range);
  EXPECT_EQ(diagram.plot().y.range, before.y.range);
  diagram.mark(motionFrame({sample(0, kNotApplicable)}));
  EXPECT_EQ(diagram.plot().x.range, before.x.range);
  EXPECT_EQ(diagram.plot().marker->x, 0);
}

/// A velocity far outside is left again, by Undo or otherwise, and the axis with it.
TEST(FrictionPlot, TheVelocityAxisFollowsBack) {
  FrictionPlot diagram;
  Scene scene;
  diagram.expect(scene);
  diagram.take(update(scene, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(frame(scene, 1e-3));
  const DecadeRange before = diagram.plot().x.range;
  Scene fast = scene;
  fast.sliding.velocity = 2e6;
  diagram.expect(fast);
  diagram.mark(frame(fast, 1e-3));
  EXPECT_EQ(diagram.plot().x.range.to, 7);
  diagram.expect(scene);
  diagram.mark(frame(scene, 1e-3));
  EXPECT_EQ(diagram.plot().x.range, before);
  scene.sweep.velocityTo = 1e4;
  diagram.expect(scene);
  EXPECT_EQ(diagram.plot().x.range.to, 4);
  scene.sweep.velocityTo = 1e3;
  diagram.expect(scene);
  EXPECT_EQ(diagram.plot().x.range, before);
}

/// F_N / (4 eta v) = 0.1 h at 1.7 m/s; in dimensionless axes likewise.
TEST(FrictionPlot, TintsWhereFewSummitsCarryTheLoad) {
  const Scene scene;
  const auto whole = [](double velocity, double mu) {
    CurvePoint made = point(velocity, mu);
    made.normalizedMu = mu / 2e-3;  // of a rms slope of 2e-3
    made.dimensionlessVelocity = 1e-3 * velocity * 2e-3 / (std::sqrt(2) * 5e-7);
    return made;
  };
  FrictionPlot diagram;
  diagram.expect(scene);
  diagram.take(update(scene, {whole(0.01, 1e-3), whole(1, 2e-3), whole(100, 1e-3)}));
  std::vector<PlotSpan> shades = diagram.plot().shades;
  ASSERT_EQ(shades.size(), 1U);
  EXPECT_EQ(shades[0].name, "few summits carry the load");
  EXPECT_NEAR(shades[0].from, 1.7, 1e-9);
  EXPECT_EQ(shades[0].to, 100);
  diagram.setAxes(CurveAxes::Dimensionless);
  shades = diagram.plot().shades;
  ASSERT_EQ(shades.size(), 1U);
  EXPECT_NEAR(shades[0].from / 1.7, 1e-3 * 2e-3 / (std::sqrt(2) * 5e-7), 1e-9);
  Scene solid;
  solid.elastomer.rheology = Rheology::StandardSolid;
  diagram.expect(solid);
  for (const PlotSpan& shade : diagram.plot().shades) EXPECT_TRUE(shade.faded);
  diagram.take(update(solid, {whole(0.01, 1e-3), whole(1, 2e-3), whole(100, 1e-3)}));
  EXPECT_TRUE(diagram.plot().shades.empty());
}

TEST(FrictionPlot, FadesTheOldCurveUntilTheNewOneArrives) {
  FrictionPlot diagram;
  Scene old, fresh;
  fresh.elastomer.shearModulus = 2e7;
  diagram.expect(old);
  diagram.take(update(old, {point(1, 1e-3)}));
  EXPECT_FALSE(diagram.isStale());

  diagram.expect(fresh);
  EXPECT_TRUE(diagram.isStale());
  for (const PlotSeries& series : diagram.plot().series) EXPECT_TRUE(series.faded);
  for (const PlotSpan& span : diagram.plot().spans) EXPECT_TRUE(span.faded);
  EXPECT_EQ(diagram.plot().progress, 0);

  EXPECT_FALSE(diagram.take(update(old, {point(1, 1e-3), point(2, 1e-3)}, 3)));
  EXPECT_FALSE(diagram.take(update(fresh, {point(1, 0, 0, 0)})));  // nothing known yet
  EXPECT_TRUE(diagram.isStale());

  EXPECT_TRUE(diagram.take(update(fresh, {point(7, 1e-3)})));
  EXPECT_FALSE(diagram.isStale());
  EXPECT_THAT(velocitiesOf(seriesOf(diagram.plot(), PlotStyle::Points)), ElementsAre(7));
}

TEST(FrictionPlot, AnotherVelocityLeavesTheCurveAsItIs) {
  FrictionPlot diagram;
  Scene scene;
  diagram.expect(scene);
  diagram.take(update(scene, {point(1, 1e-3)}));
  scene.sliding.velocity *= 3;
  diagram.expect(scene);
  EXPECT_FALSE(diagram.isStale());
}

TEST(FrictionPlot, RangesHoldStillWhileRealizationsArrive) {
  FrictionPlot diagram;
  diagram.take(update({}, {point(1e-5, 3e-7), point(1e3, 2e-3)}));
  const Plot first = diagram.plot();
  for (const double mu : {2.6e-7, 4e-7, 9e-7}) {
    diagram.take(update({}, {point(1e-5, mu), point(1e3, 2e-3)}));
    EXPECT_EQ(diagram.plot().x.range, first.x.range);
    EXPECT_EQ(diagram.plot().y.range, first.y.range);
  }
  EXPECT_EQ(first.x.range, (DecadeRange{-5, 3}));
  EXPECT_EQ(first.y.range, (DecadeRange{-7, -2}));
}

TEST(FrictionPlot, ShowsTheVelocitiesOfTheSweepAtOnce) {
  FrictionPlot diagram;
  Scene scene;
  scene.sweep.velocityFrom = 1e-4;
  scene.sweep.velocityTo = 1e2;
  diagram.expect(scene);
  EXPECT_EQ(diagram.plot().x.range, (DecadeRange{-4, 2}));
  diagram.mark(frame(scene, 0.05));  // v = 1 m/s
  EXPECT_EQ(diagram.plot().x.range, (DecadeRange{-4, 2}));
  EXPECT_LE(diagram.plot().y.range.from, -4);
  EXPECT_GE(diagram.plot().y.range.to, -1);

  scene.sweep.velocityTo = 1e4;
  diagram.expect(scene);
  EXPECT_EQ(diagram.plot().x.range, (DecadeRange{-4, 4}));
}

TEST(FrictionPlot, OneLineIsNoMean) {
  FrictionPlot diagram;
  Scene sine;
  sine.surface.kind = SurfaceKind::Sine;
  CurveUpdate curve = update(sine, {point(1, 1e-3)}, 1);
  curve.realizationsTotal = 1;
  diagram.take(curve);
  diagram.mark(frame(sine, 1e-3));
  const Plot plot = diagram.plot();
  EXPECT_EQ(seriesOf(plot, PlotStyle::Points).name, QStringLiteral("this line"));
  EXPECT_EQ(plot.note, QString());
  EXPECT_EQ(plot.marker->name, QStringLiteral("now"));

  diagram.take(update({}, {point(1, 1e-3)}));
  EXPECT_TRUE(seriesOf(diagram.plot(), PlotStyle::Points).name.contains("mean"));
  EXPECT_EQ(diagram.plot().note, QStringLiteral("2 of 200 realizations"));
}

TEST(FrictionPlot, SaysWhyThereIsNothingToSee) {
  FrictionPlot diagram;
  EXPECT_EQ(diagram.plot().blank, QString());
  Scene elastic;
  elastic.elastomer.rheology = Rheology::Elastic;
  diagram.expect(elastic);
  diagram.take(update(elastic, {point(1, 0), point(2, 0)}));
  EXPECT_EQ(diagram.plot().blank,
            QStringLiteral("no friction: nothing positive to show on a logarithmic axis"));
  diagram.take(update(elastic, {point(1, -1e-9), point(2, std::nan(""))}));
  EXPECT_TRUE(diagram.plot().blank.contains("no positive"));
  diagram.take(update(elastic, {point(1, 0), point(2, 1e-3)}));
  EXPECT_EQ(diagram.plot().blank, QString());
}

}  // namespace
}  // namespace asperity
