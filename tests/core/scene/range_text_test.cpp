#include "core/base/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(RangeText, NumbersAreAsTypedAndReadBack) {
  EXPECT_EQ(plainNumber(0.05), "0.05");
  EXPECT_EQ(plainNumber(-1e7), "-10000000");
  for (const double value : {1e-6, -2.5e-300, 1e15, 1e100, 0.1 + 0.2, 0.0, -3.0}) {
    const std::string text = plainNumber(value);
    EXPECT_EQ(std::stod(text), value) << text;
    EXPECT_THAT(text, Not(HasSubstr("e-0")));
    EXPECT_THAT(text, Not(HasSubstr("+")));
  }
  EXPECT_EQ(plainNumber(std::numeric_limits<double>::infinity()), "inf");
}

TEST(RangeText, HasTheUnitOnce) {
  EXPECT_EQ(rangeText(0, 1).english(), "0 to 1");
  EXPECT_EQ(rangeText(1e-6, 1e15, "Pa").english(), "1e-6 to 1e15 Pa");
  EXPECT_EQ(rangeText(-1e12, 1e12, "m/s").english(), "-1e12 to 1e12 m/s");
}

TEST(RangeText, EveryNumberOfTheTableIsRefusedWithItsRangeAndUnit) {
  for (const Parameter& row : parameters()) {
    const auto range = allowedRange(row);
    if (!range) continue;
    Scene scene;
    try {
      setValue(row, scene, 2 * range->maximum + 1);
      FAIL() << row.key;
    } catch (const InputError& error) {
      EXPECT_THAT(error.message().english(), EndsWith(" is outside " + allowedText(row).english()));
      if (!row.unit.empty()) {
        EXPECT_THAT(error.message().english(), EndsWith(" " + std::string(row.unit)));
      }
    }
  }
}

}  // namespace
}  // namespace asperity
