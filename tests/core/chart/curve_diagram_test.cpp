#include "core/chart/curve_diagram.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/chart/curve_set.h"
#include "core/friction/ensemble.h"
#include "core/friction/steady_states.h"
#include "core/material/temperature_shift.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene drawnScene() {
  return sceneOfSize(500, 17, 3);
}

NamedCurve curveOf(const Scene& scene, std::string name = {}, int index = 0) {
  return {std::move(name), scene, frictionCurve(scene).points, index};
}

/// The points of a curve over another key than velocity.
std::vector<CurvePoint> pointsOver(const Scene& scene) {
  const std::vector<double> values = sweepValues(scene);
  std::vector<Scene> states;
  for (const double value : values) states.push_back(sceneAt(scene, value));
  std::vector<CurvePoint> points = slideStates(states).points;
  for (std::size_t i = 0; i < points.size(); ++i) points[i].swept = values[i];
  return points;
}

TEST(CurveDiagram, ShadesAndNamesTheRegions) {
  const Scene scene = drawnScene();
  const DiagramSheet sheet = curveSheet(scene, frictionCurve(scene).points);
  ASSERT_EQ(sheet.diagrams.size(), 1U);
  const auto& spans = sheet.diagrams.front().spans;
  ASSERT_EQ(spans.size(), 4U);
  EXPECT_EQ(spans[0].label.english(), "I linear");
  EXPECT_EQ(spans[3].label.english(), "IV decrease");
  EXPECT_EQ(spans[1].shortLabel, "II");
  EXPECT_THAT(sheet.note.english(), testing::HasSubstr("read from the curve"));
}

/// Without friction nothing is drawn, over the axis of the sweep and some decades of friction.
TEST(CurveDiagram, AnElasticBodyHasTheAxesOfItsSweep) {
  Scene scene = drawnScene();
  scene.elastomer.rheology = Rheology::Elastic;
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  const Diagram diagram = curveSheet(scene, points).diagrams.front();
  EXPECT_FALSE(diagram.blank.empty());
  EXPECT_LT(diagram.x.from, points.front().velocity);
  EXPECT_GT(diagram.x.from, points.front().velocity / 2);
  EXPECT_GT(diagram.x.to, points.back().velocity);
  EXPECT_LT(diagram.x.to, points.back().velocity * 2);
  EXPECT_EQ(diagram.y.from, kEmptyFrictionFrom);
  EXPECT_EQ(diagram.y.to, kEmptyFrictionTo);
  CurveSet chosen;
  chosen.present = {{}, scene, points};
  chosen.yFrom = 1e-3;
  chosen.yTo = 1;
  EXPECT_EQ(curveSheet(chosen).diagrams.front().y.from, 1e-3);
}

TEST(CurveDiagram, PinnedCurvesHaveMarksAndColoursOfTheirOwn) {
  const Scene scene = drawnScene();
  Scene stiff = scene;
  stiff.elastomer.shearModulus *= 10;
  CurveSet set;
  set.present = curveOf(scene);
  for (int index = 0; index < 2 * kPinColours; ++index)
    set.pinned.push_back(curveOf(stiff, "G = 100 MPa", index));
  const auto series = curveSheet(set).diagrams.front().series;
  ASSERT_EQ(series.size(), set.pinned.size() + 2);
  for (std::size_t i = 0; i < series.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(series[i].colour == series[j].colour && series[i].mark == series[j].mark &&
                   series[i].stroke == series[j].stroke)
          << i << " and " << j << " look alike";
}

/// The first colour is the present curve's alone.
TEST(CurveDiagram, EightCurvesHaveEightColours) {
  std::set<int> colours{0};
  for (int index = 0; index < 7; ++index) colours.insert(pinColour(index));
  EXPECT_EQ(colours.size(), 8U);
}

/// However few velocities the sweep has: exactly Eq. (11) at every point, and no corners.
TEST(CurveDiagram, TheLawIsSampledFinely) {
  Scene scene = drawnScene();
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
  Scene scene = drawnScene();
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
  set.present = curveOf(drawnScene());
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
  const Scene scene = drawnScene();
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
  Scene scene = drawnScene();
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
  Scene scene = drawnScene();
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

/// A student who predicts a curve sees those beside it, and nothing that the curve itself adds.
TEST(CurveDiagram, AHiddenCurveLeavesThePinnedOnes) {
  Scene scene = drawnScene();
  CurveSet set;
  set.present = curveOf(scene);
  set.pinned = {curveOf(sceneOfSize(500, 17, 1), "one line", 0)};
  set.difference = curveDifference(scene, {Scheme::Linear, 2, 3});
  const DiagramSheet whole = curveSheet(set), hidden = withoutCurve(whole, 1e-4, 1e-1);
  ASSERT_EQ(hidden.diagrams.size(), 1U);
  const Diagram& diagram = hidden.diagrams.front();
  ASSERT_EQ(diagram.series.size(), 1U);
  EXPECT_EQ(diagram.series.front().name, "one line");
  EXPECT_FALSE(whole.diagrams.front().spans.empty());
  EXPECT_TRUE(diagram.spans.empty());
  EXPECT_TRUE(diagram.shades.empty());
  EXPECT_TRUE(hidden.note.empty());
  EXPECT_EQ(diagram.y.from, 1e-4);
  EXPECT_EQ(diagram.y.to, 1e-1);
}

/// A curve over another key: the axis is that of the key, and regions, which are of friction over
/// velocity, are not named.
TEST(CurveDiagram, AnyNumberMayBeTheAxis) {
  Scene scene = drawnScene();
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1;
  scene.sweep.to = 1e-3;
  scene.sweep.points = 5;
  CurveSet set;
  set.present = {{}, scene, pointsOver(scene)};
  addComparisons(set, {});
  const Diagram diagram = curveSheet(set).diagrams.front();
  EXPECT_EQ(diagram.x.unit, "N");
  EXPECT_THAT(diagram.x.title.english(), testing::HasSubstr("normal force"));
  EXPECT_EQ(diagram.x.scale, AxisScale::Logarithmic);
  EXPECT_TRUE(diagram.spans.empty());
  const DiagramSeries& mean = diagram.series.back();
  ASSERT_EQ(mean.points.size(), 5U);
  EXPECT_EQ(mean.points.front().x, 1);
  EXPECT_EQ(mean.points.back().x, 1e-3);
  // Eq. (11) is sampled finely, and is at each force that of the curve over velocity.
  const DiagramSeries& law = diagram.series.front();
  ASSERT_EQ(law.name, "Eq. (11)");
  ASSERT_EQ(law.points.size(), 160U);
  EXPECT_NEAR(law.points.front().y / set.present.points.front().muLaw, 1, 1e-12);
  EXPECT_NEAR(law.points.back().y / set.present.points.back().muLaw, 1, 1e-12);
  EXPECT_EQ(curveSheet(set).title.english(), "Friction over normal force");
}

TEST(CurveDiagram, EachQuantityStandsOnTheVerticalAxis) {
  Scene scene = drawnScene();
  CurveSet set;
  set.present = curveOf(scene);
  for (const QuantityEntry& entry : quantityEntries()) {
    set.y = entry.quantity;
    const Diagram diagram = curveSheet(set).diagrams.front();
    EXPECT_EQ(diagram.y.unit, entry.unit);
    const DiagramSeries& mean = diagram.series.back();
    for (std::size_t i = 0; i < mean.points.size(); ++i) {
      const CurvePoint& point = set.present.points[i];
      EXPECT_EQ(mean.points[i].y, entry.value(point));
      // Error bars are those of friction, in the quantity's unit.
      EXPECT_EQ(std::isfinite(mean.points[i].low), entry.isFriction) << entry.word.text();
    }
    EXPECT_EQ(findQuantity(entry.word), entry.quantity);
  }
  EXPECT_EQ(findQuantity("velocity"), std::nullopt);
}

/// The foundation's contact fraction at low velocity stands beside the computed one.
TEST(CurveDiagram, ATheoryIsDrawnForWhatItSays) {
  Scene scene = drawnScene();
  scene.surface.rollOffWavelength = scene.surface.length / 20;  // several waves are in contact
  scene.load.normalForce = 0.03;
  scene.comparison.theory = {Theory::GaussianFoundation, Theory::PerssonHalfSpace};
  CurveSet set;
  set.present = curveOf(scene);
  set.y = CurveQuantity::ContactFraction;
  addComparisons(set, {});
  EXPECT_EQ(curveSheet(set).diagrams.front().series.size(), 3U);
  EXPECT_THAT(curveSheet(set).note.english(), testing::Not(testing::HasSubstr("has no line")));
  set.y = CurveQuantity::Indentation;
  EXPECT_EQ(curveSheet(set).diagrams.front().series.size(), 1U);
  EXPECT_THAT(curveSheet(set).note.english(),
              testing::HasSubstr(
                  "Not drawn: Gaussian foundation, low velocity, which does not predict this"));
}

/// Measured friction over force: rows of the scene's own velocity, and a note about the others.
TEST(CurveDiagram, MeasuredRowsOfOtherVelocitiesAreNotShownOverForce) {
  Scene scene = drawnScene();
  scene.sliding.velocity = 0.1;
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1e-3;
  scene.sweep.to = 1;
  scene.sweep.points = 3;
  CurveSet set;
  set.present = {{}, scene, pointsOver(scene)};
  FrictionData table{"a table", {{0.1, 0.01}, {0.1, 0.02}, {5, 0.03}}};
  table.points[0].normalForce = 0.01;
  table.points[1].normalForce = 0.1;
  table.points[2].normalForce = 0.1;
  FrictionData forceless{"without forces", {{0.1, 0.01}, {0.2, 0.02}}};
  addComparisons(set, {table, forceless});
  ASSERT_EQ(set.measured.size(), 1U);
  EXPECT_EQ(set.measured[0].abscissas, (std::vector<double>{0.01, 0.1}));
  ASSERT_EQ(set.notes.size(), 2U);
  EXPECT_THAT(set.notes[0].english(), testing::HasSubstr("a table: 2 of 3 points"));
  EXPECT_THAT(set.notes[1].english(),
              testing::HasSubstr("without forces is not shown: it has no column of normal force"));
}

/// A nominal pressure of a table becomes a force by the width, which a scene of a force has not.
TEST(CurveDiagram, SaysWhichForceTheNominalPressureOfATableGives) {
  Scene scene = drawnScene();
  scene.surface.length = 0.02;
  FrictionData table{"a table", {{0.1, 0.01}, {0.2, 0.02}}};
  for (MeasuredPoint& point : table.points) point.nominalPressure = 2e4;
  table.points[1].nominalPressure = 4e4;
  const auto noteOf = [&] {
    CurveSet set;
    set.present = {{}, scene, {}};
    addComparisons(set, {table});
    EXPECT_EQ(set.notes.size(), 1U);
    return set.notes.empty() ? std::string() : set.notes[0].english();
  };
  EXPECT_THAT(noteOf(),
              testing::AllOf(testing::HasSubstr("a table: the nominal pressure of 20 kPa to 40 kPa "
                                                "is a normal force of 8 N to 16 N: pressure times "
                                                "the period of 20 mm times the width, for which "
                                                "the period is taken because none is given"),
                             testing::HasSubstr("set load.width")));
  scene.load.kind = LoadKind::Pressure;
  scene.load.width = 0.01;
  EXPECT_THAT(noteOf(), testing::HasSubstr("4 N to 8 N: pressure times the period of 20 mm times "
                                           "the width of 10 mm (load.width)"));
  for (MeasuredPoint& point : table.points) point.nominalPressure = kNotApplicable;
  CurveSet set;
  set.present = {{}, scene, {}};
  addComparisons(set, {table});
  EXPECT_TRUE(set.notes.empty());
}

/// Equal steps stand in equal distances; a chosen scale and chosen ends are taken.
TEST(CurveDiagram, TheHorizontalAxisIsAsTheSweepOrAsChosen) {
  Scene scene = drawnScene();
  CurveSet set;
  set.present = {{}, scene, {}};
  EXPECT_EQ(curveSheet(set).diagrams.front().x.scale, AxisScale::Logarithmic);
  scene.sweep.key = "surface.hurst";
  scene.sweep.from = 0.3;
  scene.sweep.to = 0.9;
  scene.sweep.scale = SweepScale::Linear;
  set.present = {{}, scene, {}};
  EXPECT_EQ(curveSheet(set).diagrams.front().x.scale, AxisScale::Linear);
  set.xScale = AxisScale::Logarithmic;
  set.xFrom = 0.2;
  set.xTo = 1;
  const DiagramAxis axis = curveSheet(set).diagrams.front().x;
  EXPECT_EQ(axis.scale, AxisScale::Logarithmic);
  EXPECT_EQ(axis.from, 0.2);
  EXPECT_EQ(axis.to, 1);
}

TEST(CurveDiagram, ShiftedVelocitiesAreCalledReduced) {
  CurveSet set;
  set.present = {{}, drawnScene(), {}};
  set.isReduced = true;
  EXPECT_THAT(curveSheet(set).diagrams.front().x.title.english(),
              testing::StartsWith("reduced sliding velocity a\u1D1B v at "));
}

/// A rubber whose times are shifted by WLF, at a temperature (K).
Scene shiftedScene(double temperature) {
  Scene scene = drawnScene();
  scene.elastomer.shift.kind = ShiftKind::Wlf;
  scene.elastomer.shift.c1 = 6.3;
  scene.elastomer.shift.c2 = 140;
  scene.elastomer.shift.referenceTemperature = 293.15;
  scene.elastomer.temperature = temperature;
  return scene;
}

/// One rubber at two temperatures, each over the velocities at which it is as fast: on the axis of
/// the reduced velocity both curves and the measured points are one (superposition).
TEST(CurveDiagram, OnTheReducedAxisEveryCurveIsShiftedByItsOwnFactor) {
  const Scene cold = shiftedScene(278.15), warm = shiftedScene(298.15);
  const double factor = temperatureShift(warm.elastomer) / temperatureShift(cold.elastomer);
  ASSERT_LT(factor, 0.5);
  CurveSet set;
  set.present = curveOf(cold);
  set.pinned = {{"warm", warm, set.present.points}};
  for (CurvePoint& point : set.pinned[0].points) point.velocity /= factor;
  MeasuredCurve measured;
  for (const CurvePoint& point : set.pinned[0].points) {
    MeasuredPoint seen{.velocity = point.velocity, .mu = point.mu, .temperature = 298.15};
    measured.data.points.push_back(seen);
  }
  set.measured = {measured};
  placeMeasured(set);
  EXPECT_TRUE(set.isReduced);
  const Diagram diagram = curveSheet(set).diagrams.front();
  const auto seriesOf = [&](int id) {
    return std::ranges::find(diagram.series, id, &DiagramSeries::id)->points;
  };
  const std::vector<DiagramPoint> present = seriesOf(kPresentCurve);
  ASSERT_EQ(present.size(), set.present.points.size());
  for (const int id : {1, kMeasuredCurves})
    for (std::size_t i = 0; i < present.size(); ++i) {
      EXPECT_NEAR(seriesOf(id)[i].x / present[i].x, 1, 1e-12);
      EXPECT_EQ(seriesOf(id)[i].y, present[i].y);
    }
  // Without another measured temperature the axis is that of the velocity itself.
  set.measured.clear();
  placeMeasured(set);
  EXPECT_FALSE(set.isReduced);
  EXPECT_EQ(abscissa(set.pinned[0].points[0], warm, set), set.pinned[0].points[0].velocity);
}

/// Each temperature of a table has a mark of its own, in the colour of the table, which stays
/// whatever is pinned.
TEST(CurveDiagram, AMeasuredTableKeepsItsColourAndTellsItsTemperaturesApart) {
  CurveSet set;
  set.present = curveOf(shiftedScene(293.15));
  MeasuredCurve measured;
  measured.data.name = "friction";
  for (const double temperature : {278.15, 293.15, 318.15})
    for (const double velocity : {0.1, 1.0}) {
      MeasuredPoint seen{.velocity = velocity, .mu = 0.5, .temperature = temperature};
      measured.data.points.push_back(seen);
    }
  set.measured = {measured};
  placeMeasured(set);
  const auto measuredSeries = [&] {
    std::vector<DiagramSeries> found;
    const DiagramSheet sheet = curveSheet(set);
    for (const DiagramSeries& series : sheet.diagrams.front().series)
      if (series.id == kMeasuredCurves) found.push_back(series);
    return found;
  };
  const std::vector<DiagramSeries> before = measuredSeries();
  ASSERT_EQ(before.size(), 3U);
  EXPECT_THAT(before[0].name.english(), testing::HasSubstr("5.0 \u00B0C"));
  EXPECT_NE(before[0].mark, before[1].mark);
  EXPECT_NE(before[1].mark, before[2].mark);
  std::vector<int> rows;
  for (const DiagramSeries& series : before)
    for (const DiagramPoint& point : series.points) rows.push_back(point.row);
  EXPECT_EQ(rows, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  set.pinned = {curveOf(shiftedScene(293.15), "another")};
  const std::vector<DiagramSeries> after = measuredSeries();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].colour, before[0].colour);
    EXPECT_EQ(after[i].mark, before[i].mark);
    EXPECT_NE(after[i].colour, pinColour(0));
  }
}

/// Points under another load than that of the scene do not lie on its curve: each load of a table
/// has a colour and its name, each temperature a mark that is the same under all loads.
TEST(CurveDiagram, AMeasuredTableTellsItsLoadsApart) {
  CurveSet set;
  set.present = curveOf(shiftedScene(293.15));
  MeasuredCurve measured;
  measured.data.name = "friction";
  for (const double pressure : {3.5e5, 1e5})
    for (const double temperature : {278.15, 293.15})
      measured.data.points.push_back(
          {.velocity = 0.1, .mu = 0.5, .nominalPressure = pressure, .temperature = temperature});
  set.measured = {measured};
  placeMeasured(set);
  std::vector<DiagramSeries> found;
  const DiagramSheet sheet = curveSheet(set);
  for (const DiagramSeries& series : sheet.diagrams.front().series)
    if (series.id == kMeasuredCurves) found.push_back(series);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].name.english(), "friction, 100 kPa, 5.0 \u00B0C");
  EXPECT_EQ(found[3].name.english(), "friction, 350 kPa, 20.0 \u00B0C");
  EXPECT_EQ(found[0].colour, found[1].colour);
  EXPECT_NE(found[0].colour, found[2].colour);
  EXPECT_EQ(found[0].mark, found[2].mark);
  EXPECT_NE(found[0].mark, found[1].mark);
  ASSERT_EQ(found[0].points.size(), 1U);
  EXPECT_EQ(found[0].points[0].row, 2);
}

/// Measured friction is of deformation and interface together: so is a curve beside it.
TEST(CurveDiagram, BesideMeasuredFrictionLocalFrictionIsShown) {
  Scene scene = drawnScene();
  scene.interface.frictionCoefficient = 0.3;
  CurveSet set;
  set.present = curveOf(scene);
  const auto isTotal = [](const DiagramSeries& series) { return series.id == kTotalCurve; };
  EXPECT_TRUE(std::ranges::none_of(curveSheet(set).diagrams.front().series, isTotal));
  FrictionData table{"a table", {{0.1, 0.4}, {1, 0.5}}};
  addComparisons(set, {table});
  const DiagramSheet sheet = curveSheet(set);
  const Diagram& diagram = sheet.diagrams.front();
  const auto total = std::ranges::find_if(diagram.series, isTotal);
  ASSERT_NE(total, diagram.series.end());
  for (std::size_t i = 0; i < total->points.size(); ++i)
    EXPECT_NEAR(total->points[i].y - set.present.points[i].mu, 0.3, 1e-12);
  EXPECT_THAT(sheet.note.english(), testing::Not(testing::HasSubstr("mu_total")));
  set.pinned = {curveOf(scene, "another")};
  EXPECT_THAT(curveSheet(set).note.english(), testing::HasSubstr("mu_total"));
  set.y = CurveQuantity::MuTotal;
  const DiagramSheet together = curveSheet(set);
  EXPECT_THAT(together.note.english(), testing::Not(testing::HasSubstr("mu_total")));
  for (const DiagramSeries& series : together.diagrams.front().series)
    if (series.id == kPresentCurve) {
      EXPECT_EQ(series.points[0].y, total->points[0].y);
    }
}

/// No mark is cut, and the ratio of 1 is within the axis.
TEST(CurveDiagram, RatiosAreWithinTheirAxis) {
  for (const double ratio : {0.5, 2.75, 40.0}) {
    CurveSet set;
    set.present = curveOf(drawnScene());
    MeasuredCurve measured;
    for (const double velocity : {0.1, 1.0}) {
      MeasuredPoint seen;
      seen.velocity = velocity;
      CurvePoint computed;
      computed.mu = 0.01;
      seen.mu = velocity < 1 ? computed.mu : ratio * computed.mu;
      measured.data.points.push_back(seen);
      measured.computed.push_back(computed);
    }
    set.measured = {measured};
    placeMeasured(set);
    const DiagramAxis axis = curveSheet(set).diagrams.back().y;
    EXPECT_LT(axis.from, std::min(1.0, ratio));
    EXPECT_GT(axis.to, std::max(1.0, ratio));
    if (axis.scale == AxisScale::Logarithmic) {
      EXPECT_NEAR(std::log10(axis.from), std::round(std::log10(axis.from)), 1e-12);
      EXPECT_NEAR(std::log10(axis.to), std::round(std::log10(axis.to)), 1e-12);
    }
  }
}

/// The name of a scene, such as "friction over velocity", may be wrong of another axis.
TEST(CurveDiagram, OverAnotherKeyTheTitleSaysWhatIsShown) {
  Scene scene = drawnScene();
  scene.title = "My tyre";
  CurveSet set;
  set.present = {{}, scene, {}};
  EXPECT_EQ(curveSheet(set).title.english(), "My tyre");
  scene.sweep.key = "load.normal_force";
  set.present = {{}, scene, {}};
  EXPECT_EQ(curveSheet(set).title.english(), "Friction over normal force");
  EXPECT_THAT(curveSheet(set).subtitle.english(), testing::StartsWith("My tyre; L = "));
}

TEST(CurveDiagram, AFamilyHasNamesOrARamp) {
  const Scene scene = drawnScene();
  CurveSet set;
  set.present = curveOf(scene);
  set.familyKey = "load.normal_force";
  for (int i = 0; i < 5; ++i) {
    set.pinned.push_back(curveOf(scene, "F = " + std::to_string(i), i));
    set.pinned.back().familyValue = i;
  }
  const Diagram few = curveSheet(set).diagrams.front();
  EXPECT_FALSE(few.ramp);
  // No curve has the value of the scene, but a theory would have it.
  EXPECT_THAT(curveSheet(set).subtitle.english(), testing::Not(testing::HasSubstr("F\u2099")));
  CurveSet withTheory = set;
  withTheory.theories.emplace_back();
  EXPECT_THAT(curveSheet(withTheory).subtitle.english(), testing::HasSubstr("F\u2099"));
  // The own curve is not one of them, and no region is its alone.
  EXPECT_EQ(few.series.size(), 5U);
  EXPECT_TRUE(few.spans.empty());
  EXPECT_THAT(curveSetCsv(set), testing::StartsWith("series,normal_force,velocity,mu,"));
  set.pinned.push_back(curveOf(scene, "F = 5", 5));
  set.pinned.back().familyValue = 5;
  const Diagram many = curveSheet(set).diagrams.front();
  ASSERT_TRUE(many.ramp);
  EXPECT_EQ(many.ramp->to.english(), "5 N");
  EXPECT_EQ(many.series[0].ramp, 0);
  EXPECT_EQ(many.series[5].ramp, 1);
}

}  // namespace
}  // namespace asperity
