// Regions I to IV on curves whose regions are known: the law of Eq. (11), whole and cut.
#include "core/chart/curve_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/chart/curve_diagram.h"
#include "core/friction/ensemble.h"
#include "core/friction/law.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

using testing::ElementsAre;

/// mu = [1 + 1/v^2]^(-1/2), Eq. (12) in units of its meeting point, times a fall beyond `fall`.
std::vector<CurvePoint> lawBetween(double from, double to, double fall = INFINITY) {
  std::vector<CurvePoint> points;
  for (const double velocity : logSpaced(from, to, 61)) {
    CurvePoint point{.velocity = velocity,
                     .mu = 1 / std::hypot(1.0, 1 / velocity) / std::hypot(1.0, velocity / fall),
                     .realizations = 1};
    points.push_back(point);
  }
  return points;
}

std::vector<std::string> namesOf(const std::vector<CurveRegion>& regions) {
  std::vector<std::string> names;
  for (const CurveRegion& region : regions) names.push_back(region.name);
  return names;
}

TEST(CurveRegions, AreWhereTheLawOfEq12HasItsBorders) {
  const auto regions = findRegions({}, lawBetween(1e-4, 1e6, 1e4));
  ASSERT_THAT(namesOf(regions), ElementsAre("I", "II", "III", "IV"));
  EXPECT_EQ(regions.front().from, 1e-4);
  // 1 / sqrt(1 + v^2) = 0.8 at v = 0.75; v / sqrt(1 + v^2) = 0.95 at 3.04.
  EXPECT_NEAR(regions[0].to, 0.75, 0.02);
  EXPECT_NEAR(regions[1].to, 0.95 / std::sqrt(1 - 0.95 * 0.95), 0.1);
  // 1 / sqrt(1 + x^2) = 0.95 at x = 0.329
  EXPECT_NEAR(regions[2].to, 0.329e4, 0.1e4);
  EXPECT_EQ(regions[3].to, 1e6);
  for (std::size_t i = 1; i < regions.size(); ++i) EXPECT_EQ(regions[i].from, regions[i - 1].to);
}

TEST(CurveRegions, ACurveThatIsCutHasOnlyThoseItShows) {
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(1e-6, 1e-2))), ElementsAre("I"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(1e-4, 1.2))), ElementsAre("I", "II"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(1e-4, 1e3))), ElementsAre("I", "II", "III"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(0.9, 1e3))), ElementsAre("II", "III"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(30, 1e3))), ElementsAre("III"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(30, 1e6, 1e4))), ElementsAre("III", "IV"));
  EXPECT_THAT(namesOf(findRegions({}, lawBetween(1e5, 1e6, 1e4))), ElementsAre("IV"));
}

// The maximum is between the two highest points, and neither has 95 % of it.
TEST(CurveRegions, APlateauBetweenTwoPointsEndsBeforeTheSecond) {
  std::vector<CurvePoint> points;
  for (const auto& [velocity, mu] : std::vector<std::pair<double, double>>{
           {1e-3, 5e-5}, {1e-2, 5e-4}, {1e-1, 2.9e-3}, {1, 2.7e-3}, {10, 1.1e-3}, {100, 3.6e-4}}) {
    CurvePoint point{.velocity = velocity, .mu = mu, .realizations = 1};
    points.push_back(point);
  }
  const auto regions = findRegions({}, points);
  ASSERT_THAT(namesOf(regions), ElementsAre("I", "II", "III", "IV"));
  // Parabola in steps of a decade: maximum 3.133e-3 at 0.423, 0.347 to both sides.
  EXPECT_NEAR(std::log10(regions[2].from), -0.924, 0.01);
  EXPECT_NEAR(std::log10(regions[2].to), -0.230, 0.01);
  EXPECT_EQ(regions[3].to, 100);
}

TEST(CurveRegions, NeedAKelvinBodyAndFriction) {
  const auto points = lawBetween(1e-4, 1e6, 1e4);
  Scene solid;
  solid.elastomer.rheology = Rheology::StandardSolid;
  EXPECT_TRUE(findRegions(solid, points).empty());
  auto unknown = points;
  for (CurvePoint& point : unknown) point.realizations = 0;
  EXPECT_TRUE(findRegions({}, unknown).empty());
  auto frictionless = points;
  for (CurvePoint& point : frictionless) point.mu = 0;
  EXPECT_TRUE(findRegions({}, frictionless).empty());
}

TEST(CurveRegions, TheSceneOfFigure2ShowsAllFour) {
  Scene scene;
  scene.ensemble.realizations = 4;
  scene.surface.elements = 1000;
  EXPECT_THAT(namesOf(findRegions(scene, frictionCurve(scene).points)),
              ElementsAre("I", "II", "III", "IV"));
}

TEST(CurveRegions, EachHasItsWordAndSentence) {
  EXPECT_EQ(regionWord("III"), "plateau");
  for (const char* name : {"I", "II", "III", "IV"}) EXPECT_FALSE(regionSentence(name).empty());
  EXPECT_TRUE(regionWord("V").empty());
}

/// Evenly spaced velocities tell nothing of the decades below the second one.
TEST(CurveRegions, DoNotDependOnTheSpacingOfTheAxis) {
  Scene scene;
  scene.ensemble.realizations = 4;
  scene.surface.elements = 1000;
  scene.sweep = {1e-4, 1e3, 31};
  const auto logarithmic = findRegions(scene, frictionCurve(scene).points);
  ASSERT_GE(logarithmic.size(), 3U);
  scene.sweep.scale = SweepScale::Linear;
  EXPECT_TRUE(findRegions(scene, frictionCurve(scene).points).empty());
  CurveOptions options;
  options.addsLogVelocities = true;
  const auto linear = findRegions(scene, frictionCurve(scene, options).points);
  ASSERT_EQ(namesOf(linear), namesOf(logarithmic));
  for (std::size_t i = 0; i < linear.size(); ++i)
    EXPECT_NEAR(linear[i].to / logarithmic[i].to, 1, 1e-6);
}

}  // namespace

namespace {

/// F_N / (4 eta v) = 0.0034 N / (4 * 1e4 Pa s * 1.7 m/s) = 50 nm = 0.1 h.
TEST(FewContacts, BorderOfFigure2) {
  EXPECT_NEAR(fewContactsVelocity({}, 5e-7), 1.7, 1e-12);
  Scene scene;
  scene.load.normalForce *= 10;
  EXPECT_NEAR(fewContactsVelocity(scene, 5e-7), 17, 1e-11);
  scene.elastomer.temperature += 30;  // softer: less viscous
  EXPECT_GT(fewContactsVelocity(scene, 5e-7), 20);
}

TEST(FewContacts, NowhereOnBodiesAndLoadsOfOtherKinds) {
  const auto borderOf = [](const auto& change) {
    Scene scene;
    change(scene);
    return fewContactsVelocity(scene, 5e-7);
  };
  EXPECT_TRUE(
      std::isnan(borderOf([](Scene& s) { s.elastomer.rheology = Rheology::StandardSolid; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.elastomer.rheology = Rheology::Elastic; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.load.kind = LoadKind::Indentation; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.surface.kind = SurfaceKind::Sine; })));
  EXPECT_TRUE(std::isnan(borderOf([](Scene& s) { s.surface.kind = SurfaceKind::Parabola; })));
  EXPECT_TRUE(std::isnan(fewContactsVelocity({}, 0)));
  // A prony series without arms is a Kelvin body.
  Scene prony;
  prony.elastomer.rheology = Rheology::Prony;
  prony.elastomer.arms.clear();
  prony.elastomer.equilibriumModulus = 1e7;
  prony.elastomer.viscosity = 1e4;
  EXPECT_NEAR(fewContactsVelocity(prony, 5e-7), 1.7, 1e-12);
}

TEST(FewContacts, CurvesKnowTheHeightOfTheirLines) {
  const Scene scene = sceneOfSize(300, 9, 2);
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  EXPECT_NEAR(fewContactsVelocity(scene, points), 1.7, 1e-9);
  EXPECT_FALSE(fewContactsRange(scene, {}));
  const auto range = fewContactsRange(scene, points);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, 1.7, 1e-9);
  EXPECT_EQ(range->to, points.back().velocity);
}

TEST(FewContacts, AreTintedInCurvesOfEitherAxes) {
  Scene scene = sceneOfSize(300, 9, 2);
  const auto shadesOf = [](const Scene& shown, CurveAxes axes = CurveAxes::Physical) {
    CurveSet set;
    set.present = {{}, shown, frictionCurve(shown).points, 0};
    set.axes = axes;
    return curveSheet(set);
  };
  const DiagramSheet sheet = shadesOf(scene);
  ASSERT_EQ(sheet.diagrams.front().shades.size(), 1U);
  EXPECT_EQ(sheet.diagrams.front().shades.front().label.english(), "few contacts carry the load");
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
