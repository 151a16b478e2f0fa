// Friction without the short waves of a line.
#include "core/friction/short_wave_cutoff.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

TEST(ShortWaveCutoff, EndsWithTheWholeLine) {
  Scene scene = sceneOfSize(401, 1, 5);
  scene.sliding.velocity = scene.sweep.velocityFrom = scene.sweep.velocityTo = 0.05;
  const auto points = frictionOverCutoff(scene);
  ASSERT_GE(points.size(), 6U);
  const CurvePoint whole = frictionCurve(scene, {}).points.front();
  EXPECT_NEAR(points.back().state.mu / whole.mu, 1, 1e-12);
  EXPECT_NEAR(points.back().wavelength, scene.surface.length / 200, 1e-15);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points[i].wavelength, points[i - 1].wavelength);
    EXPECT_TRUE(std::isfinite(points[i].shareOfDecade.standardError));
  }
}

/// Shares times decades, and what the longest waves make, are all of the friction.
TEST(ShortWaveCutoff, TheSharesAddUp) {
  Scene scene = sceneOfSize(401, 1, 5);
  scene.sliding.velocity = 0.05;
  const auto points = frictionOverCutoff(scene);
  double sum = points.front().state.mu / points.back().state.mu;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum +=
        points[i].shareOfDecade.value * std::log10(points[i - 1].wavelength / points[i].wavelength);
  EXPECT_NEAR(sum, 1, 1e-12);
}

/// In complete contact mu F_N = 2 L sum over waves of q C1 4 G'' is a sum over waves, so that the
/// friction of a cut line is that of the waves that are left: mu ~ sum of a_k^2 q_k^2, with
/// G'' = eta q v.
TEST(ShortWaveCutoff, InCompleteContactItIsTheSumOfTheWaves) {
  Scene scene = sceneOfSize(201, 1, 3);
  scene.load.normalForce = 1e4;
  scene.sliding.velocity = 1e-4;
  scene.accuracy.oversampling = 8;
  const auto points = frictionOverCutoff(scene);
  const auto power = [&](double wavelength) {
    double sum = 0;
    for (int k = 1; k <= std::lround(scene.surface.length / wavelength); ++k)
      sum += std::pow(k, 1 - 2 * scene.surface.hurst);
    return sum;
  };
  for (const CutoffPoint& point : points) {
    ASSERT_EQ(point.state.contactFraction, 1);
    EXPECT_NEAR(point.state.mu / points.back().state.mu,
                power(point.wavelength) / power(points.back().wavelength), 2e-3);
  }
}

TEST(ShortWaveCutoff, RefusesLinesWithoutWaves) {
  Scene scene = sceneOfSize(201, 1, 3);
  scene.surface.kind = SurfaceKind::Wedge;
  EXPECT_THROW(frictionOverCutoff(scene), InputError);
}

}  // namespace
}  // namespace asperity
