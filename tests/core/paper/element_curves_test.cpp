// The paper's elements marched in time: a short march from the steady shape is the paper's whole
// one, and a curve in fine steps is resolved or ends.
#include "core/paper/element_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/friction/ensemble.h"
#include "core/paper/literal_march.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

/// One period slid is not enough for that at 100 m/s, where the elastomer remembers five of them.
TEST(ElementCurves, LiteralIsWhatManyPeriodsFromAFlatElastomerEndWith) {
  constexpr std::int64_t kElements = 1000, kLines = 2, kPeriods = 16;
  const Scene scene = sceneOfSize(kElements, 1, kLines);
  const std::vector<double> velocities = logSpaced(1e-3, 1e3, 7);
  const std::vector<ElementPoint> curve = literalCurve(scene, velocities, kLines, {});
  const LineSource source(scene, 1);
  LiteralOptions whole;
  whole.steps = kPeriods * kElements;
  for (const ElementPoint& point : curve)
    for (std::int64_t r = 0; r < kLines; ++r) {
      const double expected = literalMarch(source.make(r), slidingConditions(scene, point.velocity),
                                           scene.load.normalForce, whole)
                                  .mu /
                              source.statistics().rmsSlope;
      EXPECT_NEAR(point.normalizedMu[static_cast<std::size_t>(r)] / expected, 1, 1e-4)
          << point.velocity;
    }
}

/// As many steps at every velocity, whether they are enough or not.
FineSteps fixedSteps(std::int64_t perSpacing) {
  FineSteps steps{.first = perSpacing / 2, .most = perSpacing, .tolerance = 1e9};
  return steps;
}

TEST(ElementCurves, FineStepsAreResolvedOrTheCurveEnds) {
  const Scene scene = sceneOfSize(500, 1, 3);
  const std::vector<double> velocities = logSpaced(0.1, 1e3, 9);
  FineSteps steps;
  steps.most = 64;
  const std::vector<ElementPoint> curve = fineStepCurve(scene, velocities, 3, steps, {});
  ASSERT_GT(curve.size(), 2U);
  ASSERT_LT(curve.size(), velocities.size()) << "contact is far shorter than a spacing there";
  std::int64_t last = 0;
  for (const ElementPoint& point : curve) {
    EXPECT_GE(point.stepsPerSpacing, last) << "faster sliding needs no fewer steps";
    last = point.stepsPerSpacing;
    const double velocity[] = {point.velocity};
    const auto twice = fineStepCurve(scene, velocity, 3, fixedSteps(2 * point.stepsPerSpacing), {});
    EXPECT_NEAR(point.mean() / twice.front().mean(), 1, 2 * steps.tolerance) << point.velocity;
  }
  // At the next velocity the most steps are still too few.
  const double next[] = {velocities[curve.size()]};
  const double most = fineStepCurve(scene, next, 3, fixedSteps(64), {}).front().mean();
  const double more = fineStepCurve(scene, next, 3, fixedSteps(256), {}).front().mean();
  EXPECT_GT(std::abs(most / more - 1), steps.tolerance);
}

/// A fixed number of steps has a floor, which a power law must not be fitted across.
TEST(ElementCurves, NoTwoVelocitiesShareAFloor) {
  const Scene scene = sceneOfSize(500, 1, 2);
  const std::vector<double> velocities = logSpaced(1, 1e3, 7);
  const auto fixed = fineStepCurve(scene, velocities, 2, fixedSteps(16), {});
  ASSERT_EQ(fixed.size(), velocities.size());
  EXPECT_NEAR(fixed[5].mean() / fixed[6].mean(), 1, 1e-6) << "the floor";
  const auto resolved = fineStepCurve(scene, velocities, 2, {}, {});
  for (std::size_t i = 1; i < resolved.size(); ++i)
    EXPECT_LT(resolved[i].mean(), 0.99 * resolved[i - 1].mean()) << velocities[i];
}

TEST(ElementCurves, ExponentsComeWithTheScatterOfTheLines) {
  std::vector<ElementPoint> points;
  for (const double velocity : {1.0, 10.0, 100.0})
    points.push_back({velocity, {3 / velocity, 1 / velocity}});
  const Estimate exact = exponentFrom(points, 1);
  EXPECT_NEAR(exact.value, -1, 1e-12);
  EXPECT_NEAR(exact.standardError, 0, 1e-12);
  points.back().normalizedMu[0] *= 2;
  EXPECT_GT(exponentFrom(points, 10).standardError, 0.01);
  EXPECT_TRUE(std::isnan(exponentFrom(points, 100).value)) << "of one point";
  EXPECT_TRUE(std::isnan(exponentFrom({}, 1).value));
}

}  // namespace
}  // namespace asperity
