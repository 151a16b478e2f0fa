// The predicted error of a curve against that of the curve, and the predicted cost of a map against
// what the map then costs.
#include "core/accuracy/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/jobs.h"
#include "core/base/statistics.h"
#include "core/friction/ensemble.h"
#include "core/friction/parameter_map.h"

namespace asperity {
namespace {

/// Returns sqrt(sum s^2 / N / mu^2 / V): the relative standard error of the run, root mean square
/// over its velocities.
double standardErrorOfRun(const Scene& scene) {
  std::vector<double> errors;
  for (const CurvePoint& point : frictionCurve(scene).points)
    errors.push_back(point.muStandardError / point.mu);
  return rms(errors);
}

Scene shortPronyScene() {
  Scene scene;
  scene.surface.elements = 500;
  scene.surface.hurst = 0.62;
  scene.surface.rmsHeight = 3.68e-7;
  scene.load.normalForce = 0.44;
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.shearModulus = 1e7;
  scene.elastomer.arms = {{2.84e7, 5.1e-6}};
  scene.ensemble.realizations = 20;
  scene.sweep.velocityFrom = 1e-4;
  scene.sweep.velocityTo = 0.5;
  scene.sweep.points = 9;
  return scene;
}

/// The spread of two lines says next to nothing about that of twenty.
TEST(Prediction, StandardErrorOfAShortRunIsThatOfTheRun) {
  for (const double hurst : {0.4, 0.62, 0.9})
    for (const double force : {0.003, 0.03, 0.1, 0.3, 0.44})
      for (const double time : {5.1e-6, 1e-3}) {
        Scene scene = shortPronyScene();
        scene.surface.hurst = hurst;
        scene.load.normalForce = force;
        scene.elastomer.arms.front().relaxationTime = time;
        const ErrorBudget predicted = predictCurve(scene, 1).error;
        if (predicted.isStandardErrorUnknown) continue;
        const double actual = standardErrorOfRun(scene);
        EXPECT_LT(std::abs(std::log(predicted.standardError / actual)), std::log(4.0))
            << "H " << hurst << ", " << force << " N, " << time << " s: " << predicted.standardError
            << " for " << actual;
      }
}

/// In complete contact mu = 8 L integral C q G'' dq / F_N for every line: lines that are just in
/// complete contact do not show the spread of others that are not.
TEST(Prediction, LinesInCompleteContactDoNotTellTheSpreadOfOthers) {
  int unknown = 0;
  for (double force = 0.5; force < 1.5; force *= 1.1) {
    Scene scene = shortPronyScene();
    scene.load.normalForce = force;
    const Prediction prediction = predictCurve(scene, 1);
    const double actual = standardErrorOfRun(scene);
    if (prediction.error.isStandardErrorUnknown) {
      ++unknown;
      EXPECT_TRUE(std::isnan(prediction.error.total()));
      EXPECT_TRUE(std::isnan(prediction.error.standardError));
      EXPECT_TRUE(warningOf(scene, prediction));
    } else {
      EXPECT_GT(prediction.error.standardError, 0.2 * actual) << force;
      EXPECT_FALSE(warningOf(scene, prediction));
    }
  }
  EXPECT_GT(unknown, 0);
  for (const Scheme scheme : {Scheme::Cubic, Scheme::Nodal}) {
    Scene pressed = shortPronyScene();
    pressed.accuracy.scheme = scheme;
    if (scheme == Scheme::Nodal) {
      pressed.accuracy.oversampling = 1;
      pressed.elastomer.rheology = Rheology::Kelvin;
      pressed.sweep.velocityTo = 1e-3;
    }
    pressed.load.normalForce = 10;
    const Prediction clear = predictCurve(pressed, 1);
    EXPECT_FALSE(clear.error.isStandardErrorUnknown);
    EXPECT_LT(clear.error.standardError, 1e-9);
  }
}

MapAxis axisOf(const Scene& scene, const std::string& range) {
  return mapAxis(scene, parseRangeOption("--x", range));
}

/// A trial of one line, whole, and the map on all lines; both in time of the processor. The least
/// of some, because what else the machine does can only add to them.
TEST(MapCost, IsThatOfTheMap) {
  Scene scene;
  scene.surface.elements = 1000;
  scene.ensemble.realizations = 12;
  for (const char* y : {"load.normal_force=1mN:1:12", "surface.hurst=0.3:0.9:7"}) {
    const MapAxis along = axisOf(scene, "sliding.velocity=1e-3:10:17"), across = axisOf(scene, y);
    double predicted = HUGE_VAL, spent = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
      predicted = std::min(predicted, predictMap(scene, along, across, 1).seconds);
      const double begin = threadSeconds();
      parameterMap(scene, along, across, {.threads = 1});
      spent = std::min(spent, threadSeconds() - begin);
    }
    EXPECT_LT(std::abs(std::log(predicted / spent)), std::log(2.0)) << predicted << ' ' << spent;
  }
}

/// Forces and moduli in equal steps are one scaling: of 9 x 9 states 17 are different.
TEST(MapCost, CountsStatesThatAreEqualOnce) {
  Scene scene;
  scene.surface.elements = 200;
  scene.ensemble.realizations = 3;
  const MapAxis x = axisOf(scene, "load.normal_force=1mN:1:9"),
                y = axisOf(scene, "elastomer.shear_modulus=1e6:1e9:9");
  const MapCost cost = predictMap(scene, x, y, 2);
  EXPECT_EQ(cost.columns, 9U);
  EXPECT_EQ(cost.rows, 9U);
  EXPECT_EQ(cost.different, parameterMap(scene, x, y).computed);
  EXPECT_EQ(cost.different, 17U);
  EXPECT_EQ(cost.lines, 3);
  EXPECT_EQ(cost.threads, 2);
  EXPECT_GT(cost.seconds, 0);
}

/// A map that takes long is tried in part, and then nobody knows which of its states are equal.
TEST(MapCost, OfALongMapIsFoundFromAPart) {
  Scene scene;
  scene.surface.elements = 5000;
  const MapCost cost = predictMap(scene, axisOf(scene, "sliding.velocity=1e-3:10:1000"),
                                  axisOf(scene, "load.normal_force=1mN:1:100"), 1);
  EXPECT_EQ(cost.different, 0U);
  EXPECT_GT(cost.seconds, 0.5 * cost.lines);
}

TEST(MapCost, NeedsAMap) {
  Scene scene;
  scene.surface.elements = 200;
  const MapAxis x = axisOf(scene, "sliding.velocity=1e-3:10:5");
  EXPECT_THROW(predictMap(scene, x, x), InputError);
  scene.accuracy.targetRelativeError = 0.1;
  EXPECT_THROW(predictMap(scene, x, axisOf(scene, "load.normal_force=1mN:1:5")), InputError);
}

}  // namespace
}  // namespace asperity
