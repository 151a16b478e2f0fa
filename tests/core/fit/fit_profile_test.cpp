// Profiles: one deviation is one standard error where friction is linear in the parameter.
#include "core/fit/fit_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/fit/fit.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

/// Measured friction with relative errors of `noise`, on other lines than those of the fit.
FrictionData measuredFriction(Scene scene, double noise, std::uint32_t seed) {
  scene.surface.seed = 4711;
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, noise);
  FrictionData data;
  for (const CurvePoint& point : frictionCurve(scene, {}).points) {
    MeasuredPoint measured;
    measured.velocity = point.velocity;
    measured.mu = totalMu(point) * (1 + normal(generator));
    measured.muError = noise * totalMu(point);
    measured.row = static_cast<int>(data.points.size()) + 2;
    data.points.push_back(measured);
  }
  return data;
}

/// Friction is a sum of that of the interface and that of the deformation: the range has a closed
/// form, in which the spread of few lines is a large part.
TEST(FitProfile, OneDeviationIsOneStandardErrorOfALinearParameter) {
  Scene scene = sceneOfSize(250, 9, 200);
  scene.interface.frictionCoefficient = 0.001;
  const FrictionData data = measuredFriction(scene, 0.02, 3);
  scene.ensemble.realizations = 6;
  scene.surface.seed = 12;
  const std::vector<VariedParameter> varied{{"interface.friction_coefficient", scene}};
  const FitOptions options;
  const Fit fit = fitFriction(scene, {&data, 1}, varied, options);
  const double error = fit.parameters.front().standardError;
  const Objective objective(scene, {&data, 1}, varied, options);
  Minimum best{Eigen::VectorXd::Constant(1, varied.front().coordinate(fit.parameters[0].value)), 0,
               true};
  best.chiSquared = objective.chiSquared(objective.evaluate(best.coordinates, {}));
  const ProfileWalk walk(objective, best, fit.errorScale);
  const std::vector<ProfilePoint> profile = walk.profile(0, Eigen::VectorXd::Constant(1, error), 3);
  ASSERT_EQ(profile.size(), 7U);
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(profile[static_cast<std::size_t>(i)].deviations, std::abs(i - 3),
                0.02 * std::abs(i - 3));
  const ProfileRange range = rangeOfProfile(objective, 0, profile);
  ASSERT_TRUE(range.low && range.high);
  EXPECT_NEAR(((*range.high)[0] - (*range.low)[0]) / (2 * error), 1, 0.02);
}

/// A limit within the first step is the last point of a profile, and the end of its range.
TEST(FitProfile, EndsAtTheLimits) {
  Scene scene = sceneOfSize(250, 9, 20);
  scene.interface.frictionCoefficient = 0.001;
  const FrictionData data = measuredFriction(scene, 0.02, 3);
  const double low = 0.000999, high = 0.001001;
  const std::vector<VariedParameter> varied{{"interface.friction_coefficient", scene, low, high}};
  const FitOptions options;
  const Objective objective(scene, {&data, 1}, varied, options);
  Minimum best{Eigen::VectorXd::Constant(1, varied.front().coordinate(0.001)), 0, true};
  best.chiSquared = objective.chiSquared(objective.evaluate(best.coordinates, {}));
  const double far = varied.front().highest() - varied.front().lowest();
  const std::vector<ProfilePoint> profile =
      ProfileWalk(objective, best, 1e6).profile(0, Eigen::VectorXd::Constant(1, far), 3);
  ASSERT_EQ(profile.size(), 3U);
  EXPECT_EQ(profile.front().minimum.coordinates[0], varied.front().lowest());
  EXPECT_EQ(profile.back().minimum.coordinates[0], varied.front().highest());
}

/// Hurst exponent, height and time can replace one another: whatever the start, no point of a
/// profile lies below the fit, values of one fit lie in the ranges of the other, and the fit says
/// what it leaves open.
TEST(FitProfile, FollowsAValleyToItsLowestPoint) {
  Scene scene = sceneOfSize(250, 10, 100);
  scene.load.normalForce = 0.02;
  scene.sweep.velocityFrom = 1e-3;
  scene.sweep.velocityTo = 3;
  const FrictionData data = measuredFriction(scene, 0.05, 8);
  scene.ensemble.realizations = 12;
  scene.surface.seed = 21;
  const auto fitFrom = [&](double hurst, double time, double height) {
    scene.surface.hurst = hurst;
    scene.elastomer.relaxationTime = time;
    scene.surface.rmsHeight = height;
    return fitFriction(scene, {&data, 1},
                       {{{"surface.hurst", scene},
                         {"elastomer.relaxation_time", scene},
                         {"surface.rms_height", scene}}});
  };
  const double truth[] = {0.7, 1e-3, 5e-7};
  const Fit fits[] = {fitFrom(0.7, 3e-4, 7e-7), fitFrom(0.3, 4e-4, 1e-7)};
  for (const Fit& fit : fits) {
    EXPECT_TRUE(fit.hasConverged);
    for (const ObjectiveProfile& profile : fit.profiles)
      EXPECT_GE(std::ranges::min(profile.chiSquared), fit.chiSquared - 0.01) << profile.key;
    for (std::size_t k = 0; k < 3; ++k) {
      const FittedParameter& parameter = fit.parameters[k];
      EXPECT_LE(parameter.low, parameter.value);
      EXPECT_GE(parameter.high, parameter.value);
      for (const Fit& other : fits) {
        EXPECT_LE(parameter.low, other.parameters[k].value) << parameter.key;
        EXPECT_GE(parameter.high, other.parameters[k].value) << parameter.key;
      }
      const VariedParameter varied(parameter.key, scene);
      EXPECT_LT(std::abs(varied.coordinate(truth[k]) - varied.coordinate(parameter.value)),
                2 * parameter.standardError)
          << parameter.key;
    }
    EXPECT_FALSE(std::ranges::all_of(fit.parameters, &FittedParameter::isDetermined));
  }
}

}  // namespace
}  // namespace asperity
