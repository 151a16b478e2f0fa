// Powers of ten in front of units.
#include "core/base/text_number.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(PowerOfTen, IsReadAsPeopleWriteIt) {
  for (const char* text : {"10^-3", "10\u207B\u00B3", "\u00D710\u207B\u00B3", "\u00B710^-3",
                           "x10-3", "* 10^-3", "1e-3", "1E-3", "10^\u22123"}) {
    const auto power = powerOfTenIn(text);
    ASSERT_TRUE(power) << text;
    EXPECT_DOUBLE_EQ(power->value, 1e-3) << text;
    EXPECT_EQ(power->exponent, -3) << text;
    EXPECT_TRUE(isWrittenPower(text)) << text;
  }
}

/// A number may be a load or belong to a range.
TEST(PowerOfTen, IsWrittenOnlyWithAnExponent) {
  for (const char* text : {"0.001", "1/1000", "10-3"}) {
    ASSERT_TRUE(powerOfTenIn(text)) << text;
    EXPECT_DOUBLE_EQ(powerOfTenIn(text)->value, 1e-3) << text;
    EXPECT_EQ(powerOfTenIn(text)->exponent, -3) << text;
    EXPECT_FALSE(isWrittenPower(text)) << text;
  }
  for (const char* text : {"", "m", "59.00", "2e-3", "0", "-10", "10^99", "10^", "x"})
    EXPECT_FALSE(powerOfTenIn(text)) << text;
}

TEST(PowerOfTen, StandsInFrontOfAUnit) {
  const auto scaled = scaledUnit("x 10^3 Pa s");
  ASSERT_TRUE(scaled);
  EXPECT_EQ(scaled->power.exponent, 3);
  EXPECT_EQ(scaled->unit, "Pa s");
  EXPECT_EQ(scaledUnit("10^-9*m")->unit, "m");
  EXPECT_FALSE(scaledUnit("Pa s"));
  EXPECT_FALSE(scaledUnit("10^-9m"));
}

}  // namespace
}  // namespace asperity
