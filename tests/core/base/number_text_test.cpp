#include "core/base/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PrintedNumber, IsPlainWhereItIsShortAndElseAPowerOfTen) {
  EXPECT_EQ(printedNumber(0.0001), "0.0001");
  EXPECT_EQ(printedNumber(123456), "123000");
  EXPECT_EQ(printedNumber(1e-5), "10\u207B\u2075");
  EXPECT_EQ(printedNumber(-1e6), "\u221210\u2076");
  EXPECT_EQ(printedNumber(1.5e-5), "1.5\u00D710\u207B\u2075");
  EXPECT_EQ(printedNumber(1e-5, 3, Zeros::Keep), "1.00\u00D710\u207B\u2075");
  EXPECT_EQ(printedNumber(-std::numeric_limits<double>::infinity()), "\u2013");
}

TEST(RoundedToDigits, IsADecimalNumber) {
  EXPECT_EQ(roundedToDigits(0.0033999, 3), 0.0034);
  EXPECT_EQ(roundedToDigits(98765, 3), 98800);
  EXPECT_EQ(roundedToDigits(0, 3), 0);
}

TEST(PrintedQuantity, LengthsTimesAndVelocitiesHaveNoPrefixAboveOne) {
  EXPECT_EQ(printedQuantity(1500, "m"), "1500 m");
  EXPECT_EQ(printedQuantity(1e12, "s"), "10\u00B9\u00B2 s");
  EXPECT_EQ(printedQuantity(1000, "m/s"), "1000 m/s");
  EXPECT_EQ(printedQuantity(0.02, "m"), "20 mm");
  EXPECT_EQ(printedQuantity(2000, "N"), "2 kN");
  EXPECT_EQ(printedQuantity(2000, "K"), "2000 K");
  EXPECT_EQ(printedQuantity(0.001, "K"), "0.001 K");
}

TEST(PrintedQuantity, BeyondThePrefixesIsAPowerOfTenOfThePlainUnit) {
  EXPECT_EQ(printedQuantity(1e15, "Pa"), "1 PPa");
  EXPECT_EQ(printedQuantity(1e-30, "N"), "10\u207B\u00B3\u2070 N");
  EXPECT_EQ(printedQuantity(1e27, "Pa s"), "10\u00B2\u2077 Pa s");
  EXPECT_EQ(printedQuantity(0, "Pa"), "0 Pa");
  EXPECT_EQ(printedQuantity(1e-6, ""), "10\u207B\u2076");
}

TEST(PlainNumber, NumbersAreAsTypedAndReadBack) {
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

}  // namespace
}  // namespace asperity
