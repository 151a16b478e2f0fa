// Units as files write them: words that are one, lengths, and powers of a length.
#include "core/base/text_units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

TEST(TextUnits, LengthsHaveManySpellings) {
  const std::vector<std::pair<std::string, double>> units{{"m", 1},
                                                          {"mm", 1e-3},
                                                          {"\u00B5m", 1e-6},
                                                          {"\u03BCm", 1e-6},
                                                          {"um", 1e-6},
                                                          {"microns", 1e-6},
                                                          {"Micrometer", 1e-6},
                                                          {"[nm]", 1e-9},
                                                          {"(mm)", 1e-3},
                                                          {"\u00C5", 1e-10},
                                                          {"Angstrom", 1e-10},
                                                          {"in", 0.0254},
                                                          {"inches", 0.0254},
                                                          {"mil", 2.54e-5},
                                                          {"cm", 1e-2},
                                                          {"1e-6 m", 1e-6},
                                                          {"10^-9 m", 1e-9},
                                                          {"\u00D710\u207B\u2076 m", 1e-6},
                                                          {"100 nm", 1e-7},
                                                          {"10e-6 m", 1e-5},
                                                          {"[1000 um]", 1e-3},
                                                          {"kilometres", 1e3},
                                                          {"pm", 1e-12},
                                                          {"metres", 1},
                                                          {"\u339B", 1e-6}};
  for (const auto& [text, metres] : units) {
    ASSERT_TRUE(metresPer(text).has_value()) << text;
    EXPECT_NEAR(*metresPer(text), metres, 1e-12 * metres) << text;
  }
  for (const char* other : {"", "s", "V", "Hz", "m/s", "px", "10^-999 m", "-1 m", "NaN m",
                            "59.00 um", "2 m", "106 m", "10z m"})
    EXPECT_FALSE(metresPer(other).has_value()) << other;
}

/// "59.00 um" is a length, "1e-6 m" a unit.
TEST(TextUnits, AreToldFromLengths) {
  EXPECT_TRUE(isKnownUnit("1e-6 m"));
  EXPECT_TRUE(isKnownUnit("10^-9 m"));
  EXPECT_TRUE(isKnownUnit("\u00D710\u207B\u2076 m"));
  EXPECT_TRUE(isKnownUnit("10e-6 m"));
  EXPECT_TRUE(isKnownUnit("(10^6 Pa)"));
  EXPECT_TRUE(isKnownUnit("x 10^3 Pa s"));
  EXPECT_FALSE(isKnownUnit("59.00 um"));
  EXPECT_FALSE(isKnownUnit("10z Pa"));
  EXPECT_FALSE(isKnownUnit("60 mm"));
}

/// A short name such as "A2" or "HM" is no unit; a word of any length is read in time.
TEST(TextUnits, AreToldFromNames) {
  for (const char* unit : {"m", "MM", "um", "kHz", "KHZ", "\u00B0C", "mPa", "N/m", "%", "-", "1",
                           "1/nm", "um^3", "\u00B5m\u00B3", "rad/s"})
    EXPECT_TRUE(isUnitWord(unit)) << unit;
  for (const char* name : {"", "A2", "HM", "x", "z", "time", "height", "furlong", "channel metre"})
    EXPECT_FALSE(isUnitWord(name)) << name;
  EXPECT_FALSE(isUnitWord(std::string(100'000, 'm')));
}

TEST(TextUnits, PowersOfLengthsAreRead) {
  struct Power {
    std::string text;
    double metres;
    int power;
  };
  const std::vector<Power> powers{{"mm", 1e-3, 1},         {"1/um", 1e-6, -1},
                                  {"rad/m", 1, -1},        {"cycles/mm", 1e-3, -1},
                                  {"nm^-1", 1e-9, -1},     {"nm\u207B\u00B9", 1e-9, -1},
                                  {"(um^{-1})", 1e-6, -1}, {"m^3", 1, 3},
                                  {"um\u00B3", 1e-6, 3},   {"nm4", 1e-9, 4}};
  for (const Power& expected : powers) {
    const auto read = parseLengthPower(expected.text);
    ASSERT_TRUE(read.has_value()) << expected.text;
    EXPECT_EQ(read->power, expected.power) << expected.text;
    EXPECT_NEAR(read->metres, expected.metres, 1e-12 * expected.metres) << expected.text;
  }
  for (const char* other : {"", "1/s", "um^5", "V^2", "1/um^2 mm", "um mm", "um^2/(1/s)"})
    EXPECT_FALSE(parseLengthPower(other).has_value()) << other;
}

/// um^2 mm, um^2/(1/mm) and 1e-15 m^3 are one size.
TEST(TextUnits, ProductsOfLengthsHaveTheSizeOfTheirFactors) {
  for (const char* text : {"um^2 mm", "um^2*mm", "\u00B5m\u00B2\u00B7mm", "um^2/(1/mm)"}) {
    const auto read = parseLengthPower(text);
    ASSERT_TRUE(read.has_value()) << text;
    EXPECT_EQ(read->power, 3) << text;
    EXPECT_NEAR(std::pow(read->metres, 3), 1e-15, 1e-27) << text;
  }
}

}  // namespace
}  // namespace asperity
