// What runs is what the plan says; curves of every rheology; effects of no strength.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/material/temperature_shift.h"
#include "core/scene/plan.h"
#include "tests/core/elastomers.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene shortScene() {
  Scene scene = sceneOfSize(200, 6, 4);
  scene.sweep = {1e-4, 10, 6};
  scene.load.normalForce = 0.02;
  return scene;
}

/// Stages that ran while a curve was made, against the plan.
void expectPlanned(const Scene& scene) {
  const StageCounts before = stageCounts();
  frictionCurve(scene);
  const StageCounts after = stageCounts();
  for (const PlanStage& stage : planStages(scene, Purpose::Curve)) {
    const auto i = static_cast<std::size_t>(stage.stage);
    EXPECT_EQ(after[i] > before[i], stage.runs) << stage.name << ": " << stage.reason;
  }
}

TEST(Effects, WhatRunsIsWhatThePlanSays) {
  for (const auto& [name, elastomer] : allElastomers()) {
    Scene scene = shortScene();
    scene.elastomer = elastomer;
    expectPlanned(scene);
    scene.elastomer.temperature = 305;
    scene.surface.rollOffWavelength = 0.004;
    scene.surface.summitCorrelation = 0.5;
    scene.interface.frictionCoefficient = 0.2;
    expectPlanned(scene);
    scene.load = {LoadKind::Indentation, 0, 4e-7};
    scene.sweep.points = 1;
    scene.ensemble.realizations = 1;
    expectPlanned(scene);
  }
}

/// Whether contact is complete is known on the line alone: at all velocities, at some, at none.
TEST(Effects, InCompleteContactThereIsNoSearch) {
  for (const auto& [name, elastomer] : allElastomers())
    for (const double force : {1e-3, 2.0, 1e5}) {
      SCOPED_TRACE(testing::Message() << name << ", " << force << " N");
      Scene scene = shortScene();
      scene.elastomer = elastomer;
      scene.load.normalForce = force;
      scene.ensemble.realizations = 1;
      const PlanStage planned =
          planOnLine(scene, Purpose::Curve)[static_cast<std::size_t>(Stage::ContactSearch)];
      const auto searches = [] {
        return stageCounts()[static_cast<std::size_t>(Stage::ContactSearch)];
      };
      const std::uint64_t before = searches();
      const Curve curve = frictionCurve(scene);
      EXPECT_EQ(searches() > before, planned.runs) << planned.reason;
      EXPECT_EQ(planned.runs, curve.points.back().contactFraction < 1);
      EXPECT_NE(planned.reason.english().find("contact is complete"), std::string::npos)
          << planned.reason;
      if (force == 1e5) {
        EXPECT_FALSE(planned.runs);
      } else if (force == 1e-3) {
        EXPECT_TRUE(planned.runs);
      }
    }
}

TEST(Effects, EveryRheologyHasACurve) {
  for (const auto& [name, elastomer] : allElastomers()) {
    Scene scene = shortScene();
    scene.elastomer = elastomer;
    CurveOptions one, many;
    one.threads = 1;
    many.threads = 3;
    const Curve curve = frictionCurve(scene, one);
    EXPECT_TRUE(curve.isComplete);
    EXPECT_LT(curve.largestResidual, 1e-10) << name;
    for (const CurvePoint& point : curve.points) {
      EXPECT_TRUE(std::isfinite(point.mu)) << name;
      EXPECT_GE(point.mu, name == "elastic" ? -1e-12 : 0) << name;
    }
    EXPECT_EQ(curveCsv(curve.points), curveCsv(frictionCurve(scene, many).points));
  }
}

TEST(Effects, OfNoStrengthLeaveEveryBit) {
  const auto bytesOf = [](const Scene& scene) { return curveCsv(frictionCurve(scene).points); };
  const Scene plain = shortScene();
  Scene empty = plain;
  empty.interface = {0, 0};
  empty.surface.rollOffWavelength = plain.surface.length;
  empty.elastomer.temperature = empty.elastomer.shift.referenceTemperature = 320;
  EXPECT_EQ(bytesOf(empty), bytesOf(plain));
  // A Prony series of nothing but its equilibrium is elastic.
  Scene elastic = plain, nothing = plain;
  elastic.elastomer.rheology = Rheology::Elastic;
  nothing.elastomer = prony(1e7, {{0, 1}, {1e6, 0}});
  EXPECT_EQ(bytesOf(elastic), bytesOf(nothing));
}

/// Not a stage more runs for an effect of no strength: it costs nothing.
TEST(Effects, OfNoStrengthRunNoStage) {
  const auto stagesOf = [](const Scene& scene) {
    const StageCounts before = stageCounts();
    frictionCurve(scene);
    StageCounts ran = stageCounts();
    for (std::size_t i = 0; i < kStages; ++i) ran[i] -= before[i];
    return ran;
  };
  for (const auto& [name, elastomer] : allElastomers()) {
    Scene plain = shortScene();
    plain.elastomer = elastomer;
    Scene with = plain;
    with.interface = {0, 0};
    with.surface.rollOffWavelength = plain.surface.length;
    with.surface.summitCorrelation = 0;
    with.elastomer.temperature = with.elastomer.shift.referenceTemperature = 320;
    if (with.elastomer.rheology == Rheology::Prony)
      with.elastomer.arms.insert(with.elastomer.arms.end(), {{0, 1}, {1e6, 0}});
    EXPECT_EQ(stagesOf(with), stagesOf(plain)) << name;
  }
}

TEST(Effects, LocalFrictionStandsInItsOwnColumns) {
  Scene scene = shortScene();
  const Curve without = frictionCurve(scene);
  scene.interface.frictionCoefficient = 0.25;
  const Curve with = frictionCurve(scene);
  scene.interface = {0, 40};
  const Curve shear = frictionCurve(scene);
  for (std::size_t i = 0; i < with.points.size(); ++i) {
    EXPECT_EQ(with.points[i].mu, without.points[i].mu);
    EXPECT_DOUBLE_EQ(with.points[i].muInterface, 0.25);
    EXPECT_TRUE(std::isnan(without.points[i].muInterface));
    EXPECT_NEAR(shear.points[i].muInterface,
                40 * shear.points[i].contactFraction * scene.surface.length / 0.02,
                1e-12 * shear.points[i].muInterface);
  }
  EXPECT_EQ(curveCsv(without.points).find("mu_interface"), std::string::npos);
  EXPECT_NE(curveCsv(with.points).find("realizations,mu_interface,mu_total\n"), std::string::npos);
  EXPECT_NE(curveJson(with.points, scene).find("\"mu_total\""), std::string::npos);
}

/// Where F_N(d) jumps past the force, the element on the edge bears a part of its load.
TEST(Effects, TheShareOfTheMarginalElementStandsInItsOwnColumn) {
  Scene scene = shortScene();
  scene.ensemble.realizations = 1;
  scene.sweep.velocityFrom = 1e-2;
  scene.sweep.velocityTo = 10;
  const Curve resolved = frictionCurve(scene);
  scene.accuracy.scheme = Scheme::Nodal;
  scene.accuracy.oversampling = 1;
  const Curve one = frictionCurve(scene);
  double partly = 0;
  for (const CurvePoint& point : one.points) {
    EXPECT_GT(point.marginalShare, 0);
    EXPECT_LE(point.marginalShare, 1);
    partly += point.marginalShare < 1 ? 1 : 0;
  }
  EXPECT_GT(partly, 0);
  EXPECT_DOUBLE_EQ(partly, one.marginalFraction * static_cast<double>(one.points.size()));
  EXPECT_NE(curveCsv(one.points).find("realizations,marginal_share\n"), std::string::npos);
  EXPECT_NE(curveJson(one.points, scene).find("\"marginal_share\""), std::string::npos);
  EXPECT_EQ(curveCsv(resolved.points).find("marginal_share"), std::string::npos);
  // Of several lines it is their mean.
  scene.ensemble.realizations = 4;
  const Curve several = frictionCurve(scene);
  scene.ensemble.realizations = 3;
  const Curve three = frictionCurve(scene);
  for (std::size_t i = 0; i < several.points.size(); ++i) {
    const double last = 4 * several.points[i].marginalShare - 3 * three.points[i].marginalShare;
    EXPECT_GT(last, 0);
    EXPECT_LE(last, 1 + 1e-9);
  }
}

TEST(Effects, WithoutAnEquilibriumThereIsNoSteadySliding) {
  Scene scene = shortScene();
  scene.elastomer = prony(0, {{1e7, 1e-3}});
  EXPECT_THROW(frictionCurve(scene), InputError);
}

/// tau = tau_0 exp(-c log10^2(a_T v / v_0)): largest at v_0, exp(-c) of it a decade away, shifted
/// with temperature, none at rest.
TEST(Effects, LocalShearMayDependOnTheVelocity) {
  Scene scene;
  scene.interface.shearStress = 50;
  EXPECT_EQ(interfaceAt(scene, 3).shearStress, 50);
  EXPECT_EQ(interfaceAt(scene, 0).shearStress, 50);
  scene.interface.shearVelocity = 0.01;
  scene.interface.shearWidth = 0.2;
  EXPECT_EQ(interfaceAt(scene, 0.01).shearStress, 50);
  EXPECT_DOUBLE_EQ(interfaceAt(scene, -0.1).shearStress, 50 * std::exp(-0.2));
  EXPECT_DOUBLE_EQ(interfaceAt(scene, 1e-4).shearStress, 50 * std::exp(-0.8));
  EXPECT_EQ(interfaceAt(scene, 0).shearStress, 0);
  scene.elastomer.temperature += 10;
  const double shift = temperatureShift(scene.elastomer);
  EXPECT_LT(shift, 1);
  EXPECT_NEAR(interfaceAt(scene, 0.01 / shift).shearStress, 50, 1e-12);
}

/// The curve has it: mu_interface = tau(v) L_c / F_N.
TEST(Effects, TheCurveHasTheShearOfEachVelocity) {
  Scene scene = sceneOfSize(200, 5, 3);
  scene.interface.shearStress = 50;
  scene.interface.shearVelocity = 0.1;
  for (const CurvePoint& point : frictionCurve(scene, {}).points)
    EXPECT_NEAR(
        point.muInterface / (interfaceAt(scene, point.velocity).shearStress *
                             point.contactFraction * scene.surface.length / scene.load.normalForce),
        1, 1e-9);
}

}  // namespace
}  // namespace asperity
