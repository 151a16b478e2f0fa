// Which frequencies a line excites, and what is marked as extrapolated.
#include "core/friction/excitation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/chart/material_sheets.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/material/temperature_shift.h"
#include "core/surface/line_source.h"
#include "tests/core/elastomers.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// A sine of 8 waves on 20 mm slides at v: everything is at f = v q / 2 pi = v 8 / L.
TEST(Excitation, ASineExcitesItsOneFrequency) {
  Scene scene = sceneOfSize(512, 3, 1);
  scene.surface.kind = SurfaceKind::Sine;
  scene.elastomer = prony(1e6, {{1e6, 1e-3}});
  const Excitation excitation = computeExcitation(scene);
  for (const double velocity : {1e-3, 1.0, 50.0}) {
    const auto band = excitation.band(velocity);
    ASSERT_TRUE(band.has_value());
    for (const double frequency : {band->from, band->median, band->to})
      EXPECT_NEAR(frequency, velocity * 8 / 0.02, 1e-9 * frequency);
  }
  EXPECT_FALSE(excitation.band(0).has_value());
}

/// Shares of q C(q) G''(q v) dq against the sum over all modes.
TEST(Excitation, SharesAreThoseOfTheModes) {
  Scene scene = sceneOfSize(2000, 3, 1);
  scene.elastomer = prony(1e6, {{3e6, 1e-2}, {2e6, 1e-5}});
  const double velocity = 0.3;
  scene.elastomer.measured = {50, 2000, 0, 0, 0};
  const LineSource source(scene, 1);
  const Excitation excitation(scene, source);
  const FourierLine modes = source.spectrum(0);
  double total = 0, outside = 0, below = 0, upTo = 0;
  const auto band = *excitation.band(velocity);
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    const double q = 2 * std::numbers::pi / modes.length * static_cast<double>(j + 1);
    const double w = q * velocity;
    double loss = 0;
    for (const Arm& arm : scene.elastomer.arms)
      loss += arm.modulus * w * arm.relaxationTime / (1 + std::pow(w * arm.relaxationTime, 2));
    const double weight = q * std::norm(modes.coefficients[j]) * loss;
    const double frequency = w / (2 * std::numbers::pi);
    total += weight;
    if (frequency < 50 || frequency > 2000) outside += weight;
    // Neighbouring modes are taken together, 1/32 of a decade wide.
    if (frequency < 0.93 * band.median) below += weight;
    if (frequency < 1.08 * band.median) upTo += weight;
  }
  EXPECT_NEAR(excitation.shareNotMeasured(velocity), outside / total, 0.02);
  EXPECT_LE(below / total, 0.5);
  EXPECT_GE(upTo / total, 0.5);
}

/// f a_T: colder by a decade of a_T, what was measured moves down by a decade.
TEST(Excitation, WhatWasMeasuredMovesWithTheTemperature) {
  Elastomer elastomer = prony(1e6, {{3e6, 1e-2}});
  elastomer.measured = {1, 1000, 0, 0, 0};
  elastomer.shift.kind = ShiftKind::Table;
  elastomer.shift.table = {{290, 1}, {300, 0}};
  elastomer.temperature = 290;
  EXPECT_NEAR(measuredFrequencies(elastomer)->from, 0.1, 1e-12);
  EXPECT_NEAR(measuredFrequencies(elastomer)->to, 100, 1e-9);
  EXPECT_FALSE(measuredFrequencies(prony(1e6, {{3e6, 1e-2}})).has_value());
}

Scene measuredScene() {
  Scene scene = sceneOfSize(200, 7, 2);
  scene.sweep = {1e-5, 10, 7};
  scene.load.normalForce = 0.02;
  scene.elastomer = prony(1e6, {{1e6, 1}, {4e6, 1e-2}, {2e7, 1e-5}});
  scene.elastomer.measured = {1, 1e4, 280, 310, 1e-6};
  return scene;
}

TEST(Excitation, CurvesMarkWhatWasNotMeasured) {
  const Scene scene = measuredScene();
  const Curve curve = frictionCurve(scene);
  const std::string csv = curveCsv(curve.points);
  EXPECT_THAT(csv.substr(0, csv.find('\n')), HasSubstr(",extrapolated,"));
  const Excitation excitation = computeExcitation(scene);
  int inside = 0, outside = 0;
  for (const CurvePoint& point : curve.points) {
    const bool expected = excitation.shareNotMeasured(point.velocity) > kMaxNotMeasured;
    EXPECT_EQ(point.extrapolated, expected ? 1 : 0) << point.velocity;
    EXPECT_EQ(pointNoteSet(point).has(Note::ExtrapolatedMaterial), expected);
    EXPECT_TRUE(pointNoteSet(point).has(Note::StrainBeyondMeasured));
    (expected ? outside : inside) += 1;
  }
  EXPECT_GT(inside, 0);
  EXPECT_GT(outside, 0);
  const DiagramSheet sheet = excitationSheet(scene);
  EXPECT_EQ(sheet.diagrams.size(), 3U);
  EXPECT_EQ(sheet.diagrams.front().spans.size(), 1U);
}

TEST(Excitation, WithoutAMeasuredRangeNothingIsMarked) {
  Scene scene = measuredScene();
  scene.elastomer.measured = {};
  const std::string csv = curveCsv(frictionCurve(scene).points);
  EXPECT_THAT(csv, testing::Not(HasSubstr("extrapolated")));
}

TEST(Excitation, AForeignTemperatureIsNoted) {
  Scene scene = measuredScene();
  scene.elastomer.temperature = 320;
  for (const CurvePoint& point : frictionCurve(scene).points)
    EXPECT_TRUE(pointNoteSet(point).has(Note::ExtrapolatedTemperature));
}

/// mu(v, T) = mu(v a_T, T_r), with a_T from a table or by Arrhenius.
TEST(Excitation, FrictionMovesAlongTheVelocityWithTheShift) {
  for (const ShiftKind kind : {ShiftKind::Table, ShiftKind::Arrhenius}) {
    Scene warm = measuredScene();
    warm.ensemble.realizations = 1;
    warm.elastomer.shift.kind = kind;
    warm.elastomer.shift.activationEnergy = 9e4;
    warm.elastomer.shift.table = {{285, 1.3}, {298.15, 0}, {310, -0.7}};
    Scene cold = warm;
    cold.elastomer.temperature = 291;
    const double factor = shiftFactor(cold.elastomer.shift, 291);
    EXPECT_GT(factor, 2);
    const Curve one = frictionCurve(cold);
    warm.sweep = {cold.sweep.velocityFrom * factor, cold.sweep.velocityTo * factor, 7};
    const Curve other = frictionCurve(warm);
    for (std::size_t i = 0; i < one.points.size(); ++i)
      EXPECT_NEAR(one.points[i].mu / other.points[i].mu, 1, 1e-12) << i;
  }
}

}  // namespace
}  // namespace asperity
