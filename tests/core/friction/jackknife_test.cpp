// Grouped means, which are the averages of friction curves, and their errors by the jackknife.
#include "core/friction/jackknife.h"
#include "core/base/stop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene groupedScene(std::int64_t realizations = 12) {
  Scene scene = sceneOfSize(400, 5, realizations);
  scene.sweep = {1e-3, 10, 5};
  return scene;
}

GroupedMeans meansOf(const Scene& scene, int threads = 0) {
  StateOptions options;
  options.threads = threads;
  return {scene,
          {scene.load.normalForce, 10 * scene.load.normalForce},
          sweepVelocities(scene.sweep),
          options};
}

TEST(GroupedMeans, HasTheAveragesOfTheCurve) {
  const Scene scene = groupedScene();
  const GroupedMeans means = meansOf(scene);
  const Curve curve = frictionCurve(scene);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint& expected = curve.points[i];
    const CurvePoint point = means.point(0, i);
    EXPECT_NEAR(point.mu / expected.mu, 1, 1e-12);
    EXPECT_NEAR(point.muStandardError / expected.muStandardError, 1, 1e-9);
    EXPECT_DOUBLE_EQ(point.muLaw, expected.muLaw);
    EXPECT_NEAR(point.contactFraction / expected.contactFraction, 1, 1e-12);
    EXPECT_NEAR(point.indentation / expected.indentation, 1, 1e-12);
    EXPECT_NEAR(point.normalizedMu / expected.normalizedMu, 1, 1e-12);
    EXPECT_EQ(point.realizations, expected.realizations);
  }
}

TEST(GroupedMeans, DoesNotDependOnTheThreads) {
  const GroupedMeans one = meansOf(groupedScene(), 1), three = meansOf(groupedScene(), 3);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(one.mu(j, i), three.mu(j, i));
      EXPECT_EQ(one.muStandardError(j, i), three.muStandardError(j, i));
    }
}

/// Of a mean, leaving out single realizations gives the standard error of the mean exactly.
TEST(GroupedMeans, JackknifeOfAMeanIsItsStandardError) {
  const GroupedMeans means = meansOf(groupedScene());
  ASSERT_EQ(means.groups(), 12);
  for (std::size_t i = 0; i < 5; ++i) {
    const Estimate mean = jackknife(means.groups(), [&](int out) { return means.mu(0, i, out); });
    EXPECT_EQ(mean.value, means.mu(0, i));
    EXPECT_NEAR(mean.standardError / means.muStandardError(0, i), 1, 1e-9);
  }
}

TEST(GroupedMeans, OneRealizationHasNoError) {
  const GroupedMeans means = meansOf(groupedScene(1));
  EXPECT_TRUE(std::isnan(means.muStandardError(0, 0)));
  EXPECT_TRUE(std::isnan(
      jackknife(means.groups(), [&](int out) { return means.mu(0, 0, out); }).standardError));
}

/// Eq. (6): mu is that of the pooled contact, exactly, as v -> 0.
TEST(GroupedMeans, PooledSlopeBelongsToEquation6) {
  Scene scene = groupedScene();
  scene.sweep = {1e-7, 1e-6, 2};
  const GroupedMeans means = meansOf(scene);
  const double law =
      contactFriction(means.lawInput(0, 0), means.contactFraction(0, 0) * scene.surface.length,
                      means.rmsSlopeContact(0, 0));
  EXPECT_NEAR(means.mu(0, 0) / law, 1, 1e-4);
}

TEST(GroupedMeans, StopsOnRequest) {
  std::stop_source source;
  source.request_stop();
  StateOptions options;
  options.stop = source.get_token();
  EXPECT_THROW(GroupedMeans(groupedScene(), {0.1}, {1.0}, options), StopRequested);
}

}  // namespace
}  // namespace asperity
