// Where few summits carry the load: the border by hand, and where it says nothing.
#include "core/chart/curve_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/chart/curve_diagram.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

/// F_N / (4 eta v) = 0.0034 N / (4 * 1e4 Pa s * 1.7 m/s) = 50 nm = 0.1 h.
TEST(FewSummits, BorderOfFigure2) {
  EXPECT_NEAR(fewSummitsVelocity({}, 5e-7), 1.7, 1e-12);
  Scene scene;
  scene.load.normalForce *= 10;
  EXPECT_NEAR(fewSummitsVelocity(scene, 5e-7), 17, 1e-11);
  scene.elastomer.temperature += 30;  // softer: less viscous
  EXPECT_GT(fewSummitsVelocity(scene, 5e-7), 20);
}

TEST(FewSummits, NowhereOnBodiesAndLoadsOfOtherKinds) {
  const auto borderOf = [](const auto& change) {
    Scene scene;
    change(scene);
    return fewSummitsVelocity(scene, 5e-7);
  };
  EXPECT_TRUE(
      std::isnan(borderOf([](Scene& s) { s.elastomer.rheology = Rheology::StandardSolid; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.elastomer.rheology = Rheology::Elastic; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.load.kind = LoadKind::Indentation; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.surface.kind = SurfaceKind::Sine; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.surface.kind = SurfaceKind::Parabola; })));
  EXPECT_TRUE(std::isnan(fewSummitsVelocity({}, 0)));
  // A prony series without arms is a Kelvin body.
  Scene prony;
  prony.elastomer.rheology = Rheology::Prony;
  prony.elastomer.arms.clear();
  prony.elastomer.equilibriumModulus = 1e7;
  prony.elastomer.viscosity = 1e4;
  EXPECT_NEAR(fewSummitsVelocity(prony, 5e-7), 1.7, 1e-12);
}

TEST(FewSummits, CurvesKnowTheHeightOfTheirLines) {
  const Scene scene = sceneOfSize(300, 9, 2);
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  EXPECT_NEAR(fewSummitsVelocity(scene, points), 1.7, 1e-9);
  EXPECT_FALSE(fewSummitsRange(scene, {}));
  const auto range = fewSummitsRange(scene, points);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, 1.7, 1e-9);
  EXPECT_EQ(range->to, points.back().velocity);
}

TEST(FewSummits, AreTintedInCurvesOfEitherAxes) {
  Scene scene = sceneOfSize(300, 9, 2);
  const auto shadesOf = [](const Scene& shown, CurveAxes axes = CurveAxes::Physical) {
    CurveSet set;
    set.present = {{}, shown, frictionCurve(shown).points, 0};
    set.axes = axes;
    return curveSheet(set);
  };
  const DiagramSheet sheet = shadesOf(scene);
  ASSERT_EQ(sheet.diagrams.front().shades.size(), 1U);
  EXPECT_EQ(sheet.diagrams.front().shades.front().label.english(), "few summits carry the load");
  EXPECT_NEAR(sheet.diagrams.front().shades.front().from, 1.7, 1e-9);
  EXPECT_THAT(sheet.note.english(), testing::HasSubstr("Tinted"));
  const CurvePoint last = frictionCurve(scene).points.back();
  const Diagram bars = shadesOf(scene, CurveAxes::Dimensionless).diagrams.front();
  ASSERT_EQ(bars.shades.size(), 1U);
  EXPECT_NEAR(bars.shades.front().from / (1.7 * last.dimensionlessVelocity / last.velocity), 1,
              1e-9);
  EXPECT_NEAR(bars.shades.front().to / last.dimensionlessVelocity, 1, 1e-12);
  // All of a curve beyond the border, and none of one below it.
  scene.sweep.velocityFrom = 10;
  EXPECT_EQ(shadesOf(scene).diagrams.front().shades.front().from, 10);
  scene.sweep = {1e-5, 1, 9};
  EXPECT_TRUE(shadesOf(scene).diagrams.front().shades.empty());
  EXPECT_THAT(shadesOf(scene).note.english(), testing::Not(testing::HasSubstr("Tinted")));
  Scene solid = sceneOfSize(300, 9, 2);
  solid.elastomer.rheology = Rheology::StandardSolid;
  EXPECT_TRUE(shadesOf(solid).diagrams.front().shades.empty());
}

}  // namespace
}  // namespace asperity
