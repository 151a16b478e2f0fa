// The difference of two settings on common lines, against what independent sums say.
#include "core/friction/curve_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "core/base/input_error.h"
#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene comparedScene() {
  return sceneOfSize(500, 7, 12);
}

/// mu of each line of the scene at each velocity.
std::vector<std::vector<double>> frictionOfLines(const Scene& scene) {
  const LineSource source(scene, scene.accuracy.oversampling);
  const LoadCase sweep{scene.load, sweepVelocities(scene.sweep)};
  std::vector<std::vector<double>> rows;
  const RealizationPart part{scene, {&sweep, 1}};
  slideRealizations({source, {&part, 1}}, scene.ensemble.realizations, 0, {},
                    [&](std::span<const SteadyResult> results) {
                      for (rows.emplace_back(); const SteadyResult& result : results)
                        rows.back().push_back(result.mu);
                    });
  return rows;
}

TEST(CurveDifference, OfASettingFromItselfIsNothing) {
  const Scene scene = comparedScene();
  const CurveDifference difference = curveDifference(scene, {Scheme::Cubic, 2, 12});
  ASSERT_EQ(difference.points.size(), 7U);
  for (const DifferencePoint& point : difference.points) {
    EXPECT_EQ(point.relative, 0);
    EXPECT_NEAR(point.standardError, 0, 1e-12);
  }
}

TEST(CurveDifference, IsThatOfTheTwoCurves) {
  const Scene scene = comparedScene();
  for (const CurveSetting& setting :
       {CurveSetting{Scheme::Linear, 4, 12}, {Scheme::Nodal, 1, 5}, {Scheme::Cubic, 1, 40}}) {
    const auto own = frictionCurve(scene).points;
    const auto other = frictionCurve(withSetting(scene, setting)).points;
    const CurveDifference difference = curveDifference(scene, setting);
    EXPECT_EQ(difference.done, difference.total);
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_NEAR(difference.points[i].relative, other[i].mu / own[i].mu - 1, 1e-9);
      EXPECT_NEAR(difference.points[i].mu / other[i].mu, 1, 1e-12);
      EXPECT_NEAR(difference.points[i].muStandardError / other[i].muStandardError, 1, 1e-9);
    }
  }
}

/// The stated error of the difference, from the lines themselves.
TEST(CurveDifference, ItsErrorIsThatOfPairs) {
  Scene scene = comparedScene();
  scene.accuracy.oversampling = 2;
  const CurveSetting setting{Scheme::Linear, 2, 12};
  const CurveDifference difference = curveDifference(scene, setting);
  const Scene other = withSetting(scene, setting);
  const std::vector<std::vector<double>> a = frictionOfLines(scene), b = frictionOfLines(other);
  for (std::size_t i = 0; i < difference.points.size(); ++i) {
    RunningMean meanA, rest;
    for (const auto& row : a) meanA.add(row[i]);
    const double ratio = 1 + difference.points[i].relative;
    for (std::size_t r = 0; r < a.size(); ++r) rest.add(b[r][i] - ratio * a[r][i]);
    EXPECT_NEAR(rest.mean() / meanA.mean(), 0, 1e-9);
    EXPECT_NEAR(difference.points[i].standardError, rest.standardError() / meanA.mean(), 1e-9);
    EXPECT_GT(difference.points[i].standardError, 1e-5);
  }
}

TEST(CurveDifference, CommonLinesCancelMostOfTheNoise) {
  const Scene scene = comparedScene();
  const auto own = frictionCurve(scene).points;
  const CurveDifference difference = curveDifference(scene, {Scheme::Cubic, 4, 12});
  for (std::size_t i = 0; i < own.size(); ++i)
    EXPECT_LT(difference.points[i].standardError, 0.2 * own[i].muStandardError / own[i].mu);
}

TEST(CurveDifference, RefinesWhileItRunsAndEndsWhenAsked) {
  const Scene scene = comparedScene();
  DifferenceOptions options;
  std::stop_source stop;
  options.stop = stop.get_token();
  std::vector<std::int64_t> done;
  options.progress = [&](const CurveDifference& part) {
    done.push_back(part.done);
    if (done.size() == 2) stop.request_stop();
  };
  const CurveDifference cut = curveDifference(scene, {Scheme::Cubic, 4, 12}, options);
  EXPECT_EQ(done, (std::vector<std::int64_t>{2, 6}));
  EXPECT_EQ(cut.done, 6);
  EXPECT_EQ(cut.points.size(), 7U);
}

TEST(CurveDifference, HasTheSameBitsForAnyNumberOfThreads) {
  const Scene scene = comparedScene();
  DifferenceOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const auto a = curveDifference(scene, {Scheme::Linear, 2, 20}, one).points;
  const auto b = curveDifference(scene, {Scheme::Linear, 2, 20}, two).points;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].relative, b[i].relative);
    EXPECT_EQ(a[i].standardError, b[i].standardError);
  }
}

TEST(CurveDifference, NeedsNoTargetAndSteadySliding) {
  Scene scene = comparedScene();
  scene.accuracy.targetRelativeError = 0.05;
  EXPECT_THROW(curveDifference(scene, {}), InputError);
  scene = comparedScene();
  scene.sliding.kind = SlidingKind::Step;
  EXPECT_THROW(curveDifference(scene, {}), InputError);
}

TEST(CurveDifference, SettingsHaveNames) {
  EXPECT_EQ(settingName(CurveSetting{Scheme::Cubic, 8, 20}).english(), "cubic x8, 20 lines");
  EXPECT_EQ(settingName(CurveSetting{Scheme::Nodal, 8, 1}).english(), "nodal, 1 line");
}

/// The stated error against the spread over many repetitions, for every way lines can be shared.
TEST(PairedMeans, TheErrorIsTheSpreadOfTheRatio) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const auto& [pairs, onlyA, onlyB] :
       {std::array{30, 0, 0}, {20, 0, 60}, {20, 40, 0}, {30, 10, 0}}) {
    double sum = 0, squares = 0, stated = 0;
    constexpr int kRepetitions = 2000;
    for (int k = 0; k < kRepetitions; ++k) {
      PairedMeans means;
      const auto line = [&] { return 1 + 0.1 * normal(random); };
      const auto other = [&](double a) { return 1.2 * a + 0.02 * normal(random); };
      for (int i = 0; i < pairs; ++i) {
        const double a = line();
        means.addPair(a, other(a));
      }
      for (int i = 0; i < onlyA; ++i) means.addOnlyA(line());
      for (int i = 0; i < onlyB; ++i) means.addOnlyB(other(line()));
      const Estimate ratio = means.ratio();
      sum += ratio.value;
      squares += ratio.value * ratio.value;
      stated += ratio.standardError;
    }
    const double mean = sum / kRepetitions;
    const double spread = std::sqrt(squares / kRepetitions - mean * mean);
    EXPECT_NEAR(mean, 1.2, 0.005);
    EXPECT_NEAR(stated / kRepetitions / spread, 1, 0.08) << pairs << " " << onlyA << " " << onlyB;
  }
}

}  // namespace
}  // namespace asperity
