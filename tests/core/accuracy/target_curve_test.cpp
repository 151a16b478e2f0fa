// Curves to a target accuracy: that they reach it, say so honestly, and do not depend on a clock.
#include "core/accuracy/target_curve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

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

Scene sineScene(double target) {
  Scene scene = targetScene(target);
  scene.surface.kind = SurfaceKind::Sine;
  scene.surface.elements = 64;
  return scene;
}

TEST(TargetCurve, ReachesTheTarget) {
  for (const double target : {0.1, 0.03, 0.01}) {
    const TargetCurve result = targetCurve(targetScene(target));
    EXPECT_TRUE(result.curve.isTargetMet) << target;
    EXPECT_TRUE(result.curve.isComplete);
    ASSERT_EQ(result.achieved.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      const AchievedAccuracy& achieved = result.achieved[i];
      const CurvePoint& point = result.curve.points[i];
      EXPECT_LE(std::hypot(achieved.standardError, achieved.resolutionError), target * point.mu);
      EXPECT_GT(achieved.resolutionError, 0);
      const double half = (achieved.high - achieved.low) / 2;
      EXPECT_GE(half, std::hypot(1.96 * achieved.standardError, achieved.resolutionError));
      EXPECT_LE(half, std::hypot(2.2 * achieved.standardError, achieved.resolutionError));
      EXPECT_NEAR(point.mu, achieved.low + half, 1e-12 * point.mu);
      EXPECT_EQ(point.realizations, achieved.lines);
      EXPECT_DOUBLE_EQ(point.muStandardError, achieved.standardError);
    }
  }
}

/// In complete contact all lines have the same friction: what is left is the resolution.
TEST(TargetCurve, TheIntervalHoldsTheResolution) {
  Scene scene = targetScene(0.01);
  scene.load.normalForce = 1e4;
  const TargetCurve result = targetCurve(scene);
  EXPECT_TRUE(result.curve.isTargetMet);
  for (const AchievedAccuracy& achieved : result.achieved) {
    EXPECT_LT(achieved.standardError, 0.1 * achieved.resolutionError);
    EXPECT_GE(achieved.high - achieved.low, 1.99 * achieved.resolutionError);
  }
}

/// Four times the lines for half the error, apart from the pilot.
TEST(TargetCurve, WorkGrowsAsTheInverseSquare) {
  const double coarse = targetCurve(targetScene(0.02)).operations;
  const double fine = targetCurve(targetScene(0.005)).operations;
  EXPECT_GT(fine / coarse, 8);
  EXPECT_LT(fine / coarse, 40);
}

/// A loose target is met by the fewest lines, whose error is below it: the plan states that error.
TEST(TargetCurve, APlanStatesTheErrorOfTheFewestLines) {
  const TargetCurve run = targetCurve(targetScene(0.5));
  double squares = 0;
  for (std::size_t i = 0; i < run.achieved.size(); ++i)
    squares += std::pow(run.achieved[i].standardError / run.curve.points[i].mu, 2);
  const double achieved = std::sqrt(squares / static_cast<double>(run.achieved.size()));
  EXPECT_LT(achieved, 0.2);
  EXPECT_NEAR(planTarget(targetScene(0.5)).standardError / achieved, 1, 1e-9);
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
  Scene scene = sineScene(1e-4);
  const TargetCurve result = targetCurve(scene);
  EXPECT_TRUE(result.curve.isTargetMet);
  Scene fine = scene;
  fine.accuracy = {Scheme::Cubic, 64, 0};
  const Curve converged = frictionCurve(fine);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(result.curve.points[i].mu / converged.points[i].mu, 1, 1e-4);
    EXPECT_TRUE(std::isnan(result.curve.points[i].muStandardError));
    EXPECT_EQ(result.curve.points[i].realizations, 1);
    EXPECT_GE(result.achieved[i].high - result.achieved[i].low,
              2 * result.achieved[i].resolutionError * (1 - 1e-9));
  }
}

/// Few points put the crests of three equal waves at three heights, so that one of them carries a
/// light load alone. The friction of one wave under a third of the load is that of all three.
TEST(TargetCurve, LetsAllWavesOfASineCarryTheLoad) {
  Scene one = sineScene(0.05);
  one.surface.elements = 16;
  one.surface.waves = 1;
  one.sweep = {10, 1000, 3};
  for (const double force : {1e-7, 2e-6, 1e-3}) {
    one.load.normalForce = force;
    Scene three = one;
    three.surface.length *= 3;
    three.surface.waves = 3;
    three.load.normalForce *= 3;
    const TargetCurve expected = targetCurve(one), found = targetCurve(three);
    for (std::size_t i = 0; i < 3; ++i) {
      const double within = 0.06 * expected.curve.points[i].mu;
      if (found.curve.isTargetMet)
        EXPECT_NEAR(found.curve.points[i].mu, expected.curve.points[i].mu, within) << force;
    }
  }
}

/// "Met" is what the stated error says, with no allowance: what can be had at best is found with a
/// target that cannot be met, and asked for with a little more and a little less.
TEST(TargetCurve, TheTargetIsMetWhereTheErrorIsWithin) {
  const TargetCurve best = targetCurve(sineScene(1e-16));
  EXPECT_FALSE(best.curve.isTargetMet);
  EXPECT_GT(best.curve.achievedError, 1e-16);
  EXPECT_FALSE(targetCurve(sineScene(0.9 * best.curve.achievedError)).curve.isTargetMet);
  EXPECT_TRUE(targetCurve(sineScene(1.1 * best.curve.achievedError)).curve.isTargetMet);
}

/// Elastic elements dissipate nothing: few lines, an interval about 0, nothing missed.
TEST(TargetCurve, WithoutFrictionNothingIsToBeReached) {
  for (Scene scene : {targetScene(0.01), sineScene(0.01)}) {
    scene.elastomer.rheology = Rheology::Elastic;
    const TargetCurve result = targetCurve(scene);
    EXPECT_TRUE(result.curve.isTargetMet);
    EXPECT_EQ(result.curve.achievedError, 0);
    for (const AchievedAccuracy& achieved : result.achieved) {
      EXPECT_LE(achieved.low, 0);
      EXPECT_GE(achieved.high, 0);
      EXPECT_LT(achieved.high - achieved.low, 1e-12);
      EXPECT_LE(achieved.lines, 32);
    }
    const TargetPlan plan = planTarget(scene);
    EXPECT_EQ(plan.operations, 0);
    EXPECT_LE(plan.mostLines, 32);
    EXPECT_TRUE(std::isnan(plan.standardError));
    EXPECT_TRUE(std::isnan(plan.resolutionError));
  }
}

TEST(TargetCurve, TheLastReportIsComplete) {
  Scene elastic = targetScene(0.01);
  elastic.elastomer.rheology = Rheology::Elastic;
  for (const Scene& scene : {targetScene(0.1), targetScene(0.013), sineScene(1e-5), elastic}) {
    std::vector<std::pair<std::int64_t, std::int64_t>> reports;
    std::vector<CurvePoint> last;
    CurveOptions options;
    options.progress = [&](const CurveProgress& progress) {
      reports.emplace_back(progress.realizationsDone, progress.realizationsTotal);
      last = progress.points;
    };
    const TargetCurve result = targetCurve(scene, options);
    ASSERT_FALSE(reports.empty());
    EXPECT_EQ(reports.back().first, reports.back().second);
    for (std::size_t k = 0; k + 1 < reports.size(); ++k) {
      EXPECT_LT(reports[k].first, reports[k].second);
      EXPECT_LE(reports[k].first, reports[k + 1].first);
    }
    ASSERT_EQ(last.size(), result.curve.points.size());
    for (std::size_t i = 0; i < last.size(); ++i) EXPECT_EQ(last[i].mu, result.curve.points[i].mu);
  }
}

/// Reduced form of the bench: over studies with other seeds the converged mean lies inside the
/// stated 95 % interval about as often as that says, and the estimates have no bias.
TEST(TargetCurve, IntervalsAreHonest) {
  constexpr int kStudies = 60;
  int inside = 0, all = 0;
  double bias = 0;
  for (const auto& [hurst, force, target] :
       {std::array{0.7, 0.05, 0.1}, {0.3, 0.002, 0.1}, {1.0, 0.0005, 0.05}}) {
    Scene scene = targetScene(0);
    scene.surface.hurst = hurst;
    scene.surface.elements = 200;
    scene.load.normalForce = force;
    scene.surface.seed = 1000000;
    scene.ensemble.realizations = 20000;
    scene.accuracy = {Scheme::Cubic, 4, 0};
    const Curve truth = frictionCurve(scene);
    for (int study = 0; study < kStudies; ++study) {
      ++scene.surface.seed;
      scene.accuracy = {Scheme::Cubic, 4, target};
      const TargetCurve result = targetCurve(scene);
      for (std::size_t i = 0; i < 3; ++i, ++all) {
        const AchievedAccuracy& achieved = result.achieved[i];
        const double mu = truth.points[i].mu, half = (achieved.high - achieved.low) / 2;
        inside += mu > achieved.low && mu < achieved.high ? 1 : 0;
        bias += (achieved.low + half - mu) / half;
      }
    }
  }
  // 540 points, of which those of one study share lines: 95 % less or more three standard
  // deviations, as of 360.
  EXPECT_GE(inside, 0.915 * all);
  EXPECT_LE(inside, 0.985 * all);
  EXPECT_LT(std::abs(bias / all), 0.08);
}

TEST(TargetCurve, StopsOnRequest) {
  std::stop_source source;
  CurveOptions options{.stop = source.get_token(),
                       .progress = [&](const CurveProgress&) { source.request_stop(); }};
  const TargetCurve result = targetCurve(targetScene(1e-3), options);
  EXPECT_FALSE(result.curve.isComplete);
  EXPECT_FALSE(result.curve.isTargetMet);
}

}  // namespace
}  // namespace asperity
