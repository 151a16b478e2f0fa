// The predicted cost of a map against what the map then costs.
#include "core/accuracy/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/input_error.h"
#include "core/base/jobs.h"
#include "core/friction/parameter_map.h"

namespace asperity {
namespace {

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
      MapOptions options;
      options.threads = 1;
      const double begin = threadSeconds();
      parameterMap(scene, along, across, options);
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
