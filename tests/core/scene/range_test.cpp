#include "core/scene/range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/error_from.h"

namespace asperity {
namespace {

std::string rangeError(const std::string& text) {
  return errorFrom([&] {
    const ParameterRange range = parseRangeOption("--over", text);
    checkRange(range, Scene{});
  });
}

TEST(Range, IsLogarithmicWhereTheSliderIs) {
  const ParameterRange force = parseRange("load.normal_force", "1e-3:10:5");
  EXPECT_TRUE(force.isLogarithmic);
  const std::vector<double> values = rangeValues(force);
  ASSERT_EQ(values.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(values[i], std::pow(10.0, static_cast<double>(i) - 3), 1e-15 * values[i] * 10);
  EXPECT_EQ(values.back(), 10);
  EXPECT_FALSE(parseRange("surface.hurst", "0.3:0.9:7").isLogarithmic);
  EXPECT_FALSE(parseRange("load.normal_force", "1:2:3:linear").isLogarithmic);
  EXPECT_TRUE(parseRange("surface.hurst", "0.3:0.9:7:log").isLogarithmic);
}

TEST(Range, TakesUnitsAndReadsBack) {
  const ParameterRange range = parseRange("load.normal_force", "1mN:10N:41");
  EXPECT_EQ(range.from, 1e-3);
  EXPECT_EQ(range.to, 10);
  EXPECT_EQ(range.points, 41);
  EXPECT_EQ(parseRange("load.normal_force", formatRange(range)), range);
  EXPECT_EQ(parseRange("elastomer.temperature", "0\u00B0C:40\u00B0C:3").from, 273.15);
}

TEST(Range, RunsDownwardsAndThroughOnePoint) {
  EXPECT_EQ(rangeValues(parseRange("load.normal_force", "10:1:2")), (std::vector<double>{10, 1}));
  EXPECT_EQ(rangeValues(parseRange("load.normal_force", "3:7:1")), (std::vector<double>{3}));
}

TEST(Range, WholeNumbersAreRoundedWithoutRepeats) {
  const std::vector<double> values = rangeValues(parseRange("surface.waves", "1:4:20"));
  EXPECT_EQ(values, (std::vector<double>{1, 2, 3, 4}));
}

TEST(Range, ALinearKeyMayTouchZeroAndALogarithmicOneSaysSo) {
  EXPECT_EQ(rangeError("interface.friction_coefficient=0:1:3"), "no error");
  EXPECT_EQ(rangeError("interface.friction_coefficient=0:1:3:log"),
            "interface.friction_coefficient: a logarithmic range needs ends above 0; 0 is not");
}

TEST(Range, BadTextIsOneLineWithItsKey) {
  EXPECT_EQ(rangeError("load.normal_force"),
            "--over: 'load.normal_force' is not KEY=FROM:TO:N, such as "
            "load.normal_force=0.001:10:41");
  EXPECT_EQ(rangeError("load.normal_forc=1:2:3"),
            "load.normal_forc: unknown key; the nearest known one is load.normal_force");
  EXPECT_EQ(rangeError("surface.kind=1:2:3"), "surface.kind: is not a number, so it has no range");
  EXPECT_EQ(rangeError("load.depth=1e-6:1e-5:3"),
            "load.depth: has no meaning in this scene, so nothing depends on it");
  EXPECT_EQ(rangeError("surface.hurst=0.5:1.4:3"), "surface.hurst: 1.4 is outside 0 to 1");
  EXPECT_EQ(rangeError("load.normal_force=1:2mm:3"),
            "load.normal_force: 2mm is a length; expected a force, such as 3.4 mN");
  for (const char* text : {"1:2", "1:2:3:4", "1:2:x", "1:2:3:lin", "1:2:3:log:log", "1:2:2.5"})
    EXPECT_NE(rangeError(std::string("load.normal_force=") + text), "no error") << text;
  EXPECT_EQ(rangeError("load.normal_force=1:2:0"),
            "load.normal_force: 0 points are outside 1 to 100000");
}

}  // namespace
}  // namespace asperity
