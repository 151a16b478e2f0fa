// Curves to a target accuracy: that they reach it, say so honestly, and do not depend on a clock.
#include "core/accuracy/target_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

Scene targetScene(double target) {
  Scene scene;
  scene.surface.elements = 300;
  scene.load.normalForce = 0.05;
  scene.sweep = {1e-3, 10, 3};
  scene.accuracy.targetRelativeError = target;
  return scene;
}

TEST(TargetCurve, ReachesTheTarget) {
  for (const double target : {0.1, 0.03, 0.01}) {
    const TargetCurve result = targetCurve(targetScene(target));
    EXPECT_TRUE(result.isReached) << target;
    EXPECT_TRUE(result.curve.isComplete);
    ASSERT_EQ(result.achieved.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      const AchievedAccuracy& achieved = result.achieved[i];
      const CurvePoint& point = result.curve.points[i];
      EXPECT_LE(std::hypot(achieved.standardError, achieved.resolutionError),
                1.05 * target * point.mu);
      EXPECT_LT(achieved.low, point.mu);
      EXPECT_GT(achieved.high, point.mu);
      EXPECT_EQ(point.realizations, achieved.lines);
      EXPECT_DOUBLE_EQ(point.muStandardError, achieved.standardError);
    }
  }
}

/// Four times the lines for half the error, apart from the pilot.
TEST(TargetCurve, WorkGrowsAsTheInverseSquare) {
  const double coarse = targetCurve(targetScene(0.02)).operations;
  const double fine = targetCurve(targetScene(0.005)).operations;
  EXPECT_GT(fine / coarse, 8);
  EXPECT_LT(fine / coarse, 40);
}

TEST(TargetCurve, IsTheSameForAnyThreads) {
  CurveOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const TargetCurve a = targetCurve(targetScene(0.03), one);
  const TargetCurve b = targetCurve(targetScene(0.03), three);
  for (std::size_t i = 0; i < a.curve.points.size(); ++i) {
    EXPECT_EQ(a.curve.points[i].mu, b.curve.points[i].mu);
    EXPECT_EQ(a.achieved[i].lines, b.achieved[i].lines);
  }
}

/// A line that is given has no spread: it is refined until it is resolved.
TEST(TargetCurve, RefinesAGivenLine) {
  Scene scene = targetScene(1e-4);
  scene.surface.kind = SurfaceKind::Sine;
  scene.surface.elements = 64;
  const TargetCurve result = targetCurve(scene);
  EXPECT_TRUE(result.isReached);
  Scene fine = scene;
  fine.accuracy = {Scheme::Cubic, 64, 0};
  const Curve converged = frictionCurve(fine);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(result.curve.points[i].mu / converged.points[i].mu, 1, 1e-4);
    EXPECT_TRUE(std::isnan(result.curve.points[i].muStandardError));
    EXPECT_EQ(result.curve.points[i].realizations, 1);
  }
}

/// Reduced form of the bench: over studies with other seeds the converged mean lies inside the
/// stated 95 % interval about as often as that says.
TEST(TargetCurve, IntervalsAreHonest) {
  constexpr int kStudies = 40;
  Scene reference = targetScene(0);
  reference.surface.seed = 1000;
  reference.ensemble.realizations = 20000;
  reference.accuracy = {Scheme::Cubic, 4, 0};
  const Curve truth = frictionCurve(reference);
  int inside = 0;
  for (int study = 0; study < kStudies; ++study) {
    Scene scene = targetScene(0.05);
    scene.surface.seed = study;
    const TargetCurve result = targetCurve(scene);
    for (std::size_t i = 0; i < 3; ++i)
      inside += truth.points[i].mu > result.achieved[i].low &&
                        truth.points[i].mu < result.achieved[i].high
                    ? 1
                    : 0;
  }
  // Of 120, correlated in threes: 95 % less or more three standard deviations.
  EXPECT_GE(inside, 104);
  EXPECT_LT(inside, 120);
}

TEST(TargetCurve, StopsOnRequest) {
  std::stop_source source;
  CurveOptions options;
  options.stop = source.get_token();
  options.progress = [&](const CurveProgress&) { source.request_stop(); };
  const TargetCurve result = targetCurve(targetScene(1e-3), options);
  EXPECT_FALSE(result.curve.isComplete);
  EXPECT_FALSE(result.isReached);
}

}  // namespace
}  // namespace asperity
