// What the friction diagram shows, without a widget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ui/chart/friction_chart_model.h"
#include "ui/language/language.h"

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
  made.state.mu = mu;
  return made;
}

Diagram diagramOf(const FrictionChartModel& chart) {
  return chart.sheet().diagrams.front();
}

DiagramSeries seriesOf(const FrictionChartModel& chart, int id) {
  for (const DiagramSeries& series : diagramOf(chart).series)
    if (series.id == id) return series;
  throw std::runtime_error("no such series");
}

AxisRange decadesOf(const DiagramAxis& axis) {
  return {std::log10(axis.from), std::log10(axis.to)};
}
AxisRange xRange(const FrictionChartModel& chart) {
  return decadesOf(diagramOf(chart).x);
}
AxisRange yRange(const FrictionChartModel& chart) {
  return decadesOf(diagramOf(chart).y);
}

/// Of the points that have a place on logarithmic axes.
std::vector<double> velocitiesOf(const FrictionChartModel& chart) {
  const Diagram diagram = diagramOf(chart);
  std::vector<double> velocities;
  for (const DiagramPoint& shown : seriesOf(chart, kPresentCurve).points)
    if (hasPosition(diagram, shown)) velocities.push_back(shown.x);
  return velocities;
}

TEST(FrictionChartModelTest, SkipsWhatHasNoPlaceOnLogarithmicAxes) {
  FrictionChartModel diagram;
  const double nan = std::nan("");
  ASSERT_TRUE(diagram.take(update({}, {point(1e-3, 1e-4), point(1e-2, 0), point(0.1, -2e-3),
                                       point(1, nan), point(10, 2e-3), point(100, 5e-3, nan, 0)})));
  EXPECT_THAT(velocitiesOf(diagram), ElementsAre(1e-3, 10));
  EXPECT_GT(seriesOf(diagram, kLawCurve).points.size(), 6U);
}

TEST(FrictionChartModelTest, KeepsErrorsAndStatesHowFarItIs) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1, 1e-3, 2e-4)}, 37));
  const DiagramPoint shown = seriesOf(diagram, kPresentCurve).points.front();
  EXPECT_DOUBLE_EQ(shown.high - shown.y, 2e-4);
  EXPECT_DOUBLE_EQ(shown.y - shown.low, 2e-4);
  EXPECT_EQ(diagram.sheet().status.english(), "37 of 200 lines");
  EXPECT_TRUE(diagram.sheet().isGrowing);
  EXPECT_DOUBLE_EQ(diagram.progress(), 37.0 / 200);
}

TEST(FrictionChartModelTest, ALessonThatHidesTheCurveSaysSo) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1, 1e-3, 2e-4)}, 200));
  diagram.conceal(AxisRange{1e-6, 1e-2});
  EXPECT_EQ(diagram.sheet().status.english(), "the lesson hides the curve");
  diagram.conceal(std::nullopt);
  EXPECT_EQ(diagram.sheet().status.english(), "200 of 200 lines");
}

/// Two digits of the error, and the value to the same place, with at least three digits.
TEST(FrictionChartModelTest, ValueAndErrorEndAtTheSamePlace) {
  const auto reading = [](double mu, double error) {
    FrictionChartModel diagram;
    diagram.take(update({}, {point(1, mu, error)}));
    return diagram.describe(kPresentCurve, 0).section('\n', 1, 1).toStdString();
  };
  EXPECT_EQ(reading(1e-3, 5.3e-6), "μ = 0.0010000 ± 0.0000053");
  EXPECT_EQ(reading(1.1626e-3, 1.24e-4), "μ = 0.00116 ± 0.00012");
  EXPECT_EQ(reading(1.1626e-3, 2.4e-3), "μ = 0.00116 ± 0.00240");
  EXPECT_EQ(reading(2.6374e-7, 1.2e-9), "μ = (2.637 ± 0.012)×10⁻⁷");
  EXPECT_EQ(reading(1e-7, 1.2e-9), "μ = (1.000 ± 0.012)×10⁻⁷");
  EXPECT_EQ(reading(1.1626e-3, kNotApplicable), "μ = 0.00116");
}

TEST(FrictionChartModelTest, MarksThePresentVelocityOfTheFrame) {
  FrictionChartModel diagram;
  EXPECT_FALSE(diagramOf(diagram).marker);
  Scene scene;
  scene.sliding.velocity = 0.25;
  diagram.mark(frame(scene, 3e-3));
  const Diagram plot = diagramOf(diagram);
  ASSERT_TRUE(plot.marker);
  EXPECT_EQ(plot.marker->x, 0.25);
  EXPECT_EQ(plot.marker->y, 3e-3);
  EXPECT_EQ(plot.marker->label.english(), "v = 250 mm/s");
  EXPECT_EQ(plot.marker->name.english(), "this line, now");
  Frame settling = frame(scene, 3e-3);
  settling.isSettling = true;
  diagram.mark(settling);
  EXPECT_EQ(diagram.marker()->name.english(), "this line, settled")
      << "the picture, whose friction may be another one, is still on its way there";
  // At rest it has no place on a logarithmic axis, and no entry in the legend.
  scene.sliding.velocity = 0;
  diagram.mark(frame(scene, 0));
  EXPECT_TRUE(diagramOf(diagram).marker->name.empty());
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
TEST(FrictionChartModelTest, AMotionMovesItsMarkerAndLeavesATrace) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(motionFrame({sample(0.5, 1e-3), sample(-0.25, 8e-4)}));
  const Diagram plot = diagramOf(diagram);
  ASSERT_TRUE(plot.marker);
  EXPECT_TRUE(plot.marker->isFixed);
  EXPECT_EQ(plot.marker->x, 0.25);
  EXPECT_EQ(plot.marker->y, 8e-4);
  EXPECT_EQ(plot.marker->label.english(), "|v| = 250 mm/s");
  EXPECT_EQ(plot.marker->name.english(), "this motion, now");
  const std::vector<DiagramPoint>& trace = plot.marker->trace;
  ASSERT_GE(trace.size(), 3U);
  EXPECT_EQ(trace.front().x, 0.5);
  EXPECT_EQ(
      std::ranges::count_if(trace, [](const DiagramPoint& point) { return std::isnan(point.x); }),
      1)
      << "no line through rest";
  EXPECT_EQ(trace.back().y, 8e-4);
}

/// Straight lines between the steps are bent on logarithmic axes, near rest and where friction
/// changes its direction. The path is drawn in this form, and not beyond the steps.
TEST(FrictionChartModelTest, TheTraceOfAMotionIsSmoothNearRest) {
  const auto at = [](double velocity, double friction) {
    TransientSample one = sample(velocity, std::abs(friction));
    one.tangentialForce = friction;
    return one;
  };
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(motionFrame({at(1, 1e-3), at(0.1, 1e-4), at(0.01, -2e-4), at(-0.1, -1e-3)}));
  const std::vector<DiagramPoint> trace = diagramOf(diagram).marker->trace;
  double before = kNotApplicable, lowest = 1;
  int gaps = 0, zeros = 0;
  for (const DiagramPoint& point : trace) {
    if (std::isnan(point.x)) {
      ++gaps;
      before = kNotApplicable;
      continue;
    }
    EXPECT_GE(point.x, 1e-5) << "the least velocity of the sweep";
    if (point.y == 0) {
      ++zeros;
      EXPECT_NEAR(point.x, 0.07, 1e-4) << "on the straight line between the samples";
    } else {
      lowest = std::min(lowest, point.y);
      if (gaps == 0 && point.x > 0.01 && point.x < 0.1) {
        EXPECT_NEAR(point.y, std::abs(1e-4 + (point.x - 0.1) * 3e-4 / 0.09), 1e-12);
      }
    }
    if (!std::isnan(before)) {
      EXPECT_LT(std::abs(std::log(point.x / before)), std::log(2)) << point.x;
    }
    before = point.x;
  }
  EXPECT_EQ(gaps, 1) << "velocity through 0";
  EXPECT_EQ(zeros, 1) << "friction through 0, where the path leaves the axes";
  EXPECT_LT(lowest, 1e-7) << "the straight way to 0 is bent on the axes, and has no corner";
  EXPECT_NEAR(trace[1].y / trace[1].x, 1e-3, 1e-12) << "between the first two samples";
}

/// At its turning points a motion is at rest, which has no place on a logarithmic axis.
TEST(FrictionChartModelTest, AMotionAtItsTurningPointLeavesTheAxesAlone) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(motionFrame({sample(0.5, 1e-3)}));
  const AxisRange x = xRange(diagram), y = yRange(diagram);
  diagram.mark(motionFrame({sample(0.5, 1e-3), sample(1e-12, 1e-15)}));
  EXPECT_EQ(xRange(diagram), x);
  EXPECT_EQ(yRange(diagram), y);
  diagram.mark(motionFrame({sample(0, kNotApplicable)}));
  EXPECT_EQ(xRange(diagram), x);
  EXPECT_EQ(diagramOf(diagram).marker->x, 0);
}

/// A frame at rest between two time steps has no marker at the velocity of the last one.
TEST(FrictionChartModelTest, AMotionAtRestHasNoPlaceOnTheCurve) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  Frame atRest = motionFrame({sample(0.5, 1e-3), sample(0.008, 8e-4)});
  atRest.velocity = 0;
  diagram.mark(atRest);
  EXPECT_EQ(diagramOf(diagram).marker->x, 0);
}

/// A velocity far outside is left again, by Undo or otherwise, and the axis with it.
TEST(FrictionChartModelTest, TheVelocityAxisFollowsBack) {
  FrictionChartModel diagram;
  Scene scene;
  diagram.expect(scene);
  diagram.take(update(scene, {point(1e-5, 1e-5), point(1e3, 2e-3)}));
  diagram.mark(frame(scene, 1e-3));
  const AxisRange before = xRange(diagram);
  Scene fast = scene;
  fast.sliding.velocity = 2e6;
  diagram.expect(fast);
  diagram.mark(frame(fast, 1e-3));
  EXPECT_EQ(xRange(diagram).to, 7);
  diagram.expect(scene);
  diagram.mark(frame(scene, 1e-3));
  EXPECT_EQ(xRange(diagram), before);
  scene.sweep.velocityTo = 1e4;
  diagram.expect(scene);
  EXPECT_EQ(xRange(diagram).to, 4);
  scene.sweep.velocityTo = 1e3;
  diagram.expect(scene);
  EXPECT_EQ(xRange(diagram), before);
}

/// F_N / (4 eta v) = 0.1 h at 1.7 m/s; in dimensionless axes likewise.
TEST(FrictionChartModelTest, TintsWhereFewContactsCarryTheLoad) {
  const Scene scene;
  const auto whole = [](double velocity, double mu) {
    CurvePoint made = point(velocity, mu);
    made.normalizedMu = mu / 2e-3;  // of a rms slope of 2e-3
    made.dimensionlessVelocity = 1e-3 * velocity * 2e-3 / (std::sqrt(2) * 5e-7);
    return made;
  };
  FrictionChartModel diagram;
  diagram.expect(scene);
  diagram.take(update(scene, {whole(0.01, 1e-3), whole(1, 2e-3), whole(100, 1e-3)}));
  std::vector<DiagramSpan> shades = diagramOf(diagram).shades;
  ASSERT_EQ(shades.size(), 1U);
  EXPECT_EQ(shades[0].label.english(), "few contacts carry the load");
  EXPECT_NEAR(shades[0].from, 1.7, 1e-9);
  EXPECT_EQ(shades[0].to, 100);
  diagram.setAxes(CurveAxes::Dimensionless);
  shades = diagramOf(diagram).shades;
  ASSERT_EQ(shades.size(), 1U);
  EXPECT_NEAR(shades[0].from / 1.7, 1e-3 * 2e-3 / (std::sqrt(2) * 5e-7), 1e-9);
  Scene solid;
  solid.elastomer.rheology = Rheology::StandardSolid;
  diagram.expect(solid);
  const std::vector<DiagramSpan> stale = diagramOf(diagram).shades;
  for (const DiagramSpan& shade : stale) EXPECT_TRUE(shade.isFaded);
  diagram.take(update(solid, {whole(0.01, 1e-3), whole(1, 2e-3), whole(100, 1e-3)}));
  EXPECT_TRUE(diagramOf(diagram).shades.empty());
}

TEST(FrictionChartModelTest, FadesTheOldCurveUntilTheNewOneArrives) {
  FrictionChartModel diagram;
  Scene old, fresh;
  fresh.elastomer.shearModulus = 2e7;
  diagram.expect(old);
  diagram.take(update(old, {point(1, 1e-3)}));
  EXPECT_FALSE(diagram.isStale());

  diagram.expect(fresh);
  EXPECT_TRUE(diagram.isStale());
  const Diagram shown = diagramOf(diagram);
  for (const DiagramSeries& series : shown.series) EXPECT_TRUE(series.isFaded);
  for (const DiagramSpan& span : shown.spans) EXPECT_TRUE(span.isFaded);
  EXPECT_EQ(diagram.progress(), 0);

  EXPECT_FALSE(diagram.take(update(old, {point(1, 1e-3), point(2, 1e-3)}, 3)));
  EXPECT_FALSE(diagram.take(update(fresh, {point(1, 0, 0, 0)})));  // nothing known yet
  EXPECT_TRUE(diagram.isStale());

  EXPECT_TRUE(diagram.take(update(fresh, {point(7, 1e-3)})));
  EXPECT_FALSE(diagram.isStale());
  EXPECT_THAT(velocitiesOf(diagram), ElementsAre(7));
}

TEST(FrictionChartModelTest, AnotherVelocityLeavesTheCurveAsItIs) {
  FrictionChartModel diagram;
  Scene scene;
  diagram.expect(scene);
  diagram.take(update(scene, {point(1, 1e-3)}));
  scene.sliding.velocity *= 3;
  diagram.expect(scene);
  EXPECT_FALSE(diagram.isStale());
}

TEST(FrictionChartModelTest, RangesHoldStillWhileRealizationsArrive) {
  FrictionChartModel diagram;
  diagram.take(update({}, {point(1e-5, 3e-7), point(1e3, 2e-3)}));
  const AxisRange x = xRange(diagram), y = yRange(diagram);
  for (const double mu : {2.6e-7, 4e-7, 9e-7}) {
    diagram.take(update({}, {point(1e-5, mu), point(1e3, 2e-3)}));
    EXPECT_EQ(xRange(diagram), x);
    EXPECT_EQ(yRange(diagram), y);
  }
  EXPECT_EQ(x, (AxisRange{-5, 3}));
  EXPECT_EQ(y, (AxisRange{-7, -2}));
}

/// A change of the scene leaves a decade that is empty now; another scene does not begin with it.
TEST(FrictionChartModelTest, AnotherSceneBeginsTheAxesAnew) {
  for (const bool isOpened : {false, true}) {
    FrictionChartModel diagram;
    diagram.take(update({}, {point(1e-5, 3e-7), point(1e3, 2e-3)}));
    Scene other;
    other.surface.hurst = 0.5;
    diagram.expect(other);
    if (isOpened) diagram.resetAxes();
    diagram.take(update(other, {point(1e-5, 3e-6), point(1e3, 2e-3)}));
    EXPECT_EQ(yRange(diagram).from, isOpened ? -6 : -7);
    // Also where the curve came before the first picture of the scene.
    diagram.mark(frame(other, 1e-4));
    EXPECT_EQ(yRange(diagram).from, isOpened ? -6 : -7);
    diagram.fitVerticalAxis();
    EXPECT_EQ(yRange(diagram), (AxisRange{-6, -2}));
  }
}

TEST(FrictionChartModelTest, ShowsTheVelocitiesOfTheSweepAtOnce) {
  FrictionChartModel diagram;
  Scene scene;
  scene.sweep.velocityFrom = 1e-4;
  scene.sweep.velocityTo = 1e2;
  diagram.expect(scene);
  EXPECT_EQ(xRange(diagram), (AxisRange{-4, 2}));
  diagram.mark(frame(scene, 0.05));  // v = 1 m/s
  EXPECT_EQ(xRange(diagram), (AxisRange{-4, 2}));
  EXPECT_LE(yRange(diagram).from, -4);
  EXPECT_GE(yRange(diagram).to, -1);

  scene.sweep.velocityTo = 1e4;
  diagram.expect(scene);
  EXPECT_EQ(xRange(diagram), (AxisRange{-4, 4}));
}

/// The curve of a scene may be there before its first picture, while the marker is the old one.
TEST(FrictionChartModelTest, AxesForgetTheMarkerOfTheSceneBefore) {
  FrictionChartModel diagram;
  Frame before = frame({}, 0.5);
  before.sceneNumber = 1;
  diagram.mark(before);
  Scene next;
  next.load.normalForce = 1e-3;
  diagram.expect(next);
  diagram.take(update(next, {point(1e-3, 1e-5), point(1, 2e-3)}));
  EXPECT_GE(yRange(diagram).to, 0);
  Frame now = frame(next, 1e-3);
  now.sceneNumber = 2;
  diagram.mark(now);
  EXPECT_LT(yRange(diagram).to, -1);
}

/// A table: what is measured far from the curve is within the axes, and its ratio to what is
/// computed, over decades, has a logarithmic axis.
TEST(FrictionChartModelTest, MeasuredFrictionIsWithinTheAxes) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  FrictionChartModel diagram;
  diagram.take(update(scene, {point(1e-3, 1e-5), point(1, 2e-3)}));
  MeasuredCurve measured;
  measured.data.name = "table";
  for (const double velocity : {1e-6, 1e5}) {
    MeasuredPoint seen;
    seen.velocity = velocity;
    seen.mu = velocity < 1 ? 0.8 : 50;
    measured.data.points.push_back(seen);
    measured.abscissas.push_back(velocity);
    measured.computed.push_back(point(velocity, 1e-3));
  }
  CurveSet comparisons;
  comparisons.measured = {measured};
  diagram.showComparisons(scene, comparisons);
  EXPECT_LE(xRange(diagram).from, -6);
  EXPECT_GE(xRange(diagram).to, 5);
  EXPECT_GE(yRange(diagram).to, std::log10(50));
  const DiagramSheet sheet = diagram.sheet();
  ASSERT_EQ(sheet.diagrams.size(), 2U);
  EXPECT_EQ(sheet.diagrams[1].y.scale, AxisScale::Logarithmic);
}

/// While a new curve is computed, measured points, their ratios and the axes stay; what belongs to
/// the scene before is faded.
TEST(FrictionChartModelTest, MeasuredFrictionStaysWhileANewCurveIsComputed) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  FrictionChartModel diagram;
  diagram.take(update(scene, {point(1e-3, 1e-5), point(1, 2e-3)}, 200));
  MeasuredCurve measured;
  measured.data.name = "table";
  for (const double velocity : {1e-6, 1e5}) {
    MeasuredPoint seen;
    seen.velocity = velocity;
    seen.mu = 0.8;
    measured.data.points.push_back(seen);
    measured.abscissas.push_back(velocity);
    measured.computed.push_back(point(velocity, 0.5));
  }
  CurveSet comparisons;
  comparisons.measured = {measured};
  diagram.showComparisons(scene, comparisons);
  const AxisRange x = xRange(diagram), y = yRange(diagram);
  const auto expectKept = [&](bool areRatiosOld) {
    EXPECT_EQ(xRange(diagram), x);
    EXPECT_EQ(yRange(diagram), y);
    ASSERT_EQ(diagram.sheet().diagrams.size(), 2U);
    EXPECT_EQ(seriesOf(diagram, kMeasuredCurves).points.size(), 2U);
    EXPECT_FALSE(seriesOf(diagram, kMeasuredCurves).isFaded);
    EXPECT_EQ(diagram.sheet().diagrams[1].series.back().isFaded, areRatiosOld);
  };
  expectKept(false);
  Scene softer = scene;
  softer.elastomer.shearModulus /= 2;
  diagram.expect(softer);
  expectKept(false);  // of the curve that is still there
  EXPECT_TRUE(seriesOf(diagram, kPresentCurve).isFaded);
  diagram.take(update(softer, {point(1e-3, 2e-5), point(1, 3e-3)}));
  expectKept(true);
  // Another table is another matter.
  Scene other = softer;
  other.comparison.data = {{"other.csv", {}}};
  diagram.expect(other);
  diagram.take(update(other, {point(1e-3, 2e-5), point(1, 3e-3)}));
  EXPECT_EQ(diagram.sheet().diagrams.size(), 1U);
}

/// A table with one point, and what was computed beside it.
CurveSet comparisonsAt(double velocity) {
  MeasuredCurve measured;
  measured.data.name = "table";
  measured.data.points.resize(1);
  measured.data.points[0].velocity = velocity;
  measured.data.points[0].normalForce = 1e-3;
  measured.data.points[0].mu = 0.8;
  measured.abscissas = {velocity};
  measured.computed = {point(velocity, 0.5)};
  CurveSet comparisons;
  comparisons.measured = {measured};
  comparisons.theories = {{Theory::Eq11, {}}};
  comparisons.notes = {"a note"};
  return comparisons;
}

/// Files and pictures show nothing as faded, and bear the name of the present scene.
TEST(FrictionChartModelTest, WrittenCurvesHaveNothingThatWasComputedForTheSceneBefore) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  FrictionChartModel diagram;
  diagram.take(update(scene, {point(1e-3, 1e-5), point(1, 2e-3)}, 200));
  diagram.showComparisons(scene, comparisonsAt(0.1));
  ASSERT_EQ(diagram.shown({})->theories.size(), 1U);
  ASSERT_EQ(diagram.shown({})->measured.at(0).computed.size(), 1U);
  scene.elastomer.shearModulus /= 2;
  diagram.expect(scene);
  EXPECT_EQ(diagram.shown({})->theories.size(), 1U)
      << "the curve is still that of the scene before";
  diagram.take(update(scene, {point(1e-3, 2e-5), point(1, 3e-3)}));
  EXPECT_TRUE(diagram.shown({})->theories.empty());
  ASSERT_EQ(diagram.shown({})->measured.size(), 1U) << "it is measured, whatever the scene";
  EXPECT_TRUE(diagram.shown({})->measured[0].computed.empty());
}

/// The scene chooses the rows of a table that are shown over the force.
TEST(FrictionChartModelTest, OverAnotherKeyWrittenCurvesHaveNoRowsOfTheSceneBefore) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1e-4;
  scene.sweep.to = 1e-2;
  FrictionChartModel diagram;
  diagram.expect(scene);
  diagram.take(update(scene, {point(1, 1e-3), point(1, 2e-3)}, 200));
  diagram.showComparisons(scene, comparisonsAt(1));
  ASSERT_EQ(diagram.shown({})->measured.size(), 1U);
  ASSERT_EQ(diagram.shown({})->notes.size(), 1U);
  scene.sliding.velocity *= 2;
  diagram.expect(scene);
  diagram.take(update(scene, {point(2, 1e-3), point(2, 2e-3)}));
  EXPECT_TRUE(diagram.shown({})->measured.empty());
  EXPECT_TRUE(diagram.shown({})->notes.empty());
}

TEST(FrictionChartModelTest, ATableOfTheSameNameInAnotherFolderIsAnotherTable) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  scene.folder = "here";
  FrictionChartModel diagram;
  diagram.take(update(scene, {point(1e-3, 1e-5), point(1, 2e-3)}, 200));
  diagram.showComparisons(scene, comparisonsAt(0.1));
  ASSERT_EQ(diagram.shown({})->measured.size(), 1U);
  scene.folder = "there";
  diagram.expect(scene);
  diagram.take(update(scene, {point(1e-3, 1e-5), point(1, 2e-3)}));
  EXPECT_TRUE(diagram.shown({})->measured.empty());
}

/// A measured point under the pointer says at which velocity and temperature it was measured, and
/// where it stands on the axis.
TEST(FrictionChartModelTest, AShiftedPointSaysItsTemperature) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  FrictionChartModel diagram;
  diagram.take(update(scene, {point(1e-3, 1e-2), point(1, 2e-1)}, 200));
  MeasuredCurve measured;
  measured.data.name = "table";
  measured.data.points.resize(1);
  measured.data.points[0].velocity = 1e-3;
  measured.data.points[0].mu = 0.5;
  measured.data.points[0].temperature = 280;
  measured.abscissas = {9e-3};
  CurveSet comparisons;
  comparisons.measured = {measured};
  comparisons.isReduced = true;
  diagram.showComparisons(scene, comparisons);
  const std::string text = diagram.describe(kMeasuredCurves, 0).toStdString();
  for (const char* part : {"v = 1 mm/s", "a\u1D1B v = 9 mm/s", "T = 6.9 \u00B0C"})
    EXPECT_NE(text.find(part), std::string::npos) << text << " has no " << part;
}

TEST(FrictionChartModelTest, ReadingsAreWrittenInTheLanguage) {
  Scene scene;
  scene.comparison.data = {{"table.csv", {}}};
  FrictionChartModel diagram;
  CurvePoint whole = point(1, 2e-1);
  whole.power = 0.0125;
  diagram.take(update(scene, {whole}, 200));
  CurveSet comparisons = comparisonsAt(1e-3);
  comparisons.measured[0].data.points[0].temperature = 280.5;
  diagram.showComparisons(scene, comparisons);
  diagram.setQuantity(CurveQuantity::Power);
  useLanguage("de");
  const std::string measured = diagram.describe(kMeasuredCurves, 0).toStdString();
  const std::string computed = diagram.describe(kPresentCurve, 0).toStdString();
  useLanguage("en");
  EXPECT_NE(measured.find("T = 7,4 \u00B0C"), std::string::npos) << measured;
  EXPECT_NE(computed.find("= 12,5 mW"), std::string::npos) << computed;
}

TEST(FrictionChartModelTest, OneLineIsNoMean) {
  FrictionChartModel diagram;
  Scene sine;
  sine.surface.kind = SurfaceKind::Sine;
  CurveUpdate curve = update(sine, {point(1, 1e-3, kNotApplicable, 1)}, 1);
  curve.realizationsTotal = 1;
  diagram.take(curve);
  diagram.mark(frame(sine, 1e-3));
  EXPECT_EQ(seriesOf(diagram, kPresentCurve).name.english(), "this line");
  EXPECT_EQ(diagram.sheet().status.english(), "");
  EXPECT_EQ(diagram.marker()->name.english(), "now");

  diagram.take(update({}, {point(1, 1e-3)}));
  EXPECT_TRUE(seriesOf(diagram, kPresentCurve).name.english().starts_with("mean"));
  EXPECT_EQ(diagram.sheet().status.english(), "2 of 200 lines");
}

/// Over another key each value has lines of its own; the legend speaks of those of one value.
TEST(FrictionChartModelTest, OverAnotherKeyStatusAndLegendCountTheSameLines) {
  Scene scene;
  scene.sweep.key = "elastomer.shear_modulus";
  scene.sweep.from = 1e6;
  scene.sweep.to = 1e8;
  FrictionChartModel diagram;
  diagram.expect(scene);
  CurveUpdate curve = update(scene, {point(1, 1e-3, 1e-5, 200), point(1, 2e-3, 1e-5, 200)}, 300);
  curve.points[0].swept = 1e6;
  curve.points[1].swept = 1e8;
  curve.realizationsTotal = 600;
  diagram.take(curve);
  EXPECT_EQ(diagram.sheet().status.english(), "50 % of the curve");
  curve.realizationsDone = 600;
  curve.isComplete = true;
  diagram.take(curve);
  EXPECT_EQ(diagram.sheet().status.english(), "200 of 200 lines");
  EXPECT_FALSE(diagram.sheet().isGrowing);
  EXPECT_TRUE(seriesOf(diagram, kPresentCurve).name.english().starts_with("mean of 200 lines"));
}

TEST(FrictionChartModelTest, SaysWhyThereIsNothingToSee) {
  FrictionChartModel diagram;
  EXPECT_EQ(diagramOf(diagram).blank.english(), "");
  Scene elastic;
  elastic.elastomer.rheology = Rheology::Elastic;
  diagram.expect(elastic);
  diagram.take(update(elastic, {point(1, 0), point(2, 0)}));
  EXPECT_EQ(diagramOf(diagram).blank.english(),
            "no friction: nothing positive to show on a logarithmic axis");
  diagram.take(update(elastic, {point(1, -1e-9), point(2, std::nan(""))}));
  EXPECT_TRUE(diagramOf(diagram).blank.english().starts_with("no positive"));
  diagram.take(update(elastic, {point(1, 0), point(2, 1e-3)}));
  EXPECT_EQ(diagramOf(diagram).blank.english(), "");
}

}  // namespace
}  // namespace asperity
