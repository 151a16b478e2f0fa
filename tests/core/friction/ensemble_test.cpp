#include "core/friction/ensemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/friction/curve_file.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene smallScene() {
  return sceneOfSize(300, 9, 21);
}

TEST(Ensemble, VelocitiesAreEvenInTheirLogarithmAndEndExactly) {
  const auto v = sweepVelocities({1e-5, 1e3, 41});
  ASSERT_EQ(v.size(), 41U);
  EXPECT_EQ(v.front(), 1e-5);
  EXPECT_EQ(v.back(), 1e3);
  for (std::size_t i = 1; i < v.size(); ++i) EXPECT_NEAR(v[i] / v[i - 1], std::pow(10, 0.2), 1e-12);
  EXPECT_EQ(sweepVelocities({0.5, 2, 1}), std::vector<double>{0.5});
}

TEST(Ensemble, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Cubic}) {
    Scene scene = smallScene();
    scene.accuracy.scheme = scheme;
    std::string first;
    for (const int threads : {1, 2, 5}) {
      CurveOptions options;
      options.threads = threads;
      const Curve curve = frictionCurve(scene, options);
      EXPECT_TRUE(curve.isComplete);
      const std::string text = curveCsv(curve.points);
      if (first.empty()) first = text;
      EXPECT_EQ(text, first);
    }
  }
}

std::string curveText(const Scene& scene) {
  CurveOptions options;
  options.threads = 1;
  return curveCsv(frictionCurve(scene, options).points);
}

/// Of every kind of line, scheme and rheology, of two sizes.
std::vector<Scene> scenesOfAllKinds() {
  std::vector<Scene> scenes;
  for (const SurfaceKind kind :
       {SurfaceKind::SelfAffine, SurfaceKind::Wedge, SurfaceKind::Sine, SurfaceKind::Parabola})
    for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
      for (const Rheology rheology :
           {Rheology::Elastic, Rheology::Kelvin, Rheology::StandardSolid}) {
        if (scheme == Scheme::Nodal && rheology == Rheology::StandardSolid) continue;
        Scene scene = sceneOfSize(kind == SurfaceKind::SelfAffine ? 60 : 150, 3, 3);
        scene.surface.kind = kind;
        scene.accuracy.scheme = scheme;
        scene.accuracy.oversampling = scheme == Scheme::Nodal ? 1 : 2;
        scene.elastomer.rheology = rheology;
        scenes.push_back(scene);
      }
  return scenes;
}

/// Threads keep the memory of their last line; results know nothing of it.
TEST(Ensemble, WhatAThreadComputedBeforeChangesNothing) {
  const std::vector<Scene> scenes = scenesOfAllKinds();
  std::vector<std::string> alone(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i)
    std::jthread([&, i] { alone[i] = curveText(scenes[i]); });  // a thread without a past
  for (std::size_t step : {std::size_t{1}, std::size_t{7}, scenes.size() - 1})
    for (std::size_t n = 0, i = 0; n < scenes.size(); ++n, i = (i + step) % scenes.size())
      EXPECT_EQ(curveText(scenes[i]), alone[i]) << i << " in steps of " << step;
}

TEST(Ensemble, MeanAndStandardErrorAreThoseOfTheRealizations) {
  Scene scene = smallScene();
  scene.sweep = {0.1, 0.1, 1};
  const CurvePoint point = frictionCurve(scene).points.front();
  const LineSource source(scene, curvePointsPerElement(scene));
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(scene.ensemble.realizations);
  for (int r = 0; r < scene.ensemble.realizations; ++r) {
    const PreparedProfile line = prepareProfile(source.make(r), scene.accuracy.scheme);
    const double mu = slideAtForce(line, slidingConditions(scene, 0.1), scene.load.normalForce).mu;
    sum += mu;
    squares += mu * mu;
  }
  const double mean = sum / n;
  EXPECT_NEAR(point.mu / mean, 1, 1e-10);
  EXPECT_NEAR(point.muStandardError, std::sqrt((squares / n - mean * mean) / (n - 1)), 1e-7 * mean);
  EXPECT_EQ(point.realizations, scene.ensemble.realizations);
}

/// Warm starts along the sweep change the cost, not the answer.
TEST(Ensemble, TheSweepGivesWhatEachVelocityGivesAlone) {
  Scene scene = smallScene();
  scene.ensemble.realizations = 1;
  const Curve curve = frictionCurve(scene);
  const LineSource source(scene, curvePointsPerElement(scene));
  const PreparedProfile line = prepareProfile(source.make(0), scene.accuracy.scheme);
  for (const CurvePoint& point : curve.points) {
    const SteadyResult alone =
        slideAtForce(line, slidingConditions(scene, point.velocity), scene.load.normalForce);
    EXPECT_NEAR(point.mu / alone.mu, 1, 1e-10);
    EXPECT_NEAR(point.indentation / alone.indentation, 1, 1e-11);
  }
}

TEST(Ensemble, ProgressCountsUpToTheWhole) {
  CurveOptions options;
  std::int64_t last = 0;
  options.progress = [&](const CurveProgress& progress) {
    EXPECT_GT(progress.realizationsDone, last);
    EXPECT_EQ(progress.points.front().realizations, progress.realizationsDone);
    last = progress.realizationsDone;
  };
  frictionCurve(smallScene(), options);
  EXPECT_EQ(last, 21);
}

TEST(Ensemble, CancellingStopsWithWhatIsDone) {
  std::stop_source source;
  CurveOptions options{.stop = source.get_token(),
                       .progress = [&](const CurveProgress&) { source.request_stop(); }};
  const Curve curve = frictionCurve(smallScene(), options);
  EXPECT_FALSE(curve.isComplete);
  EXPECT_LT(curve.points.front().realizations, 21);
  EXPECT_GE(curve.points.front().realizations, 1);
}

TEST(Ensemble, ALineThatIsNotRandomIsComputedOnce) {
  Scene scene = smallScene();
  scene.surface.kind = SurfaceKind::Sine;
  const CurvePoint point = frictionCurve(scene).points.front();
  EXPECT_EQ(point.realizations, 1);
  EXPECT_TRUE(std::isnan(point.muStandardError));
  EXPECT_TRUE(std::isnan(point.muLaw));
}

TEST(Ensemble, AtConstantIndentationTheForceFollows) {
  Scene scene = smallScene();
  scene.load.kind = LoadKind::Indentation;
  scene.load.depth = 1e-6;
  for (const CurvePoint& point : frictionCurve(scene).points) {
    EXPECT_EQ(point.indentation, 1e-6);
    EXPECT_GT(point.dimensionlessForce, 0);
  }
}

/// mu ~ v in region I, the plateau near sqrt(2) grad, the law within its stated 22 %.
TEST(Ensemble, TheCurveHasThePapersShape) {
  Scene scene;
  scene.surface.elements = 2000;
  scene.load.normalForce = 0.1;
  scene.ensemble.realizations = 20;
  scene.sweep = {1e-5, 10, 31};
  const auto points = frictionCurve(scene).points;
  EXPECT_NEAR(points[5].mu / points[0].mu, 10, 0.05);
  double plateau = 0;
  for (const CurvePoint& point : points) plateau = std::max(plateau, point.normalizedMu);
  EXPECT_NEAR(plateau, std::sqrt(2), 0.08);
  for (const CurvePoint& point : points) EXPECT_NEAR(point.muLaw / point.mu, 1, 0.25);
}

TEST(Ensemble, AFlatLineHasNoLaw) {
  Scene scene = smallScene();
  scene.surface.rmsHeight = 0;
  for (const CurvePoint& point : frictionCurve(scene).points) {
    EXPECT_EQ(point.mu, 0);
    EXPECT_TRUE(std::isnan(point.muLaw));
    EXPECT_TRUE(std::isnan(point.dimensionlessForce));
  }
}

/// What the window reads at a velocity does not depend on the spacing of the axis.
TEST(Ensemble, ACurveOverEvenlySpacedVelocitiesHasThePointsOfALogarithmicOneBeside) {
  Scene scene = smallScene();
  scene.sweep = {1e-4, 1e3, 13};
  const auto logarithmic = frictionCurve(scene).points;
  scene.sweep.scale = SweepScale::Linear;
  EXPECT_EQ(frictionCurve(scene).points.size(), 13U);
  CurveOptions options;
  options.addsLogVelocities = true;
  const auto both = frictionCurve(scene, options).points;
  EXPECT_EQ(both.size(), 13U + 13U - 2U);  // the ends are the same
  EXPECT_TRUE(std::ranges::is_sorted(both, {}, &CurvePoint::velocity));
  for (const CurvePoint& point : logarithmic) {
    const auto same = std::ranges::find(both, point.velocity, &CurvePoint::velocity);
    ASSERT_NE(same, both.end()) << point.velocity;
    // The search for the balance begins elsewhere.
    EXPECT_NEAR(same->mu / point.mu, 1, 1e-8) << point.velocity;
  }
}

}  // namespace
}  // namespace asperity
