#include "ui/draw/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string labels(const AxisTicks& axis) {
  std::string text;
  for (const Tick& tick : axis.ticks) text += (text.empty() ? "" : " ") + tick.label;
  return text + " " + axis.unit;
}

TEST(Ticks, RoundPlacesInThePrefixedUnit) {
  EXPECT_EQ(labels(linearTicks(0, 0.02, 5, "m")), "0 5 10 15 20 mm");
  EXPECT_EQ(labels(linearTicks(-1.2e-6, 0.9e-6, 5, "m")), "\u22121.0 \u22120.5 0.0 0.5 \u00B5m");
  EXPECT_EQ(labels(linearTicks(0, 4.5e-7, 5, "m")), "0 100 200 300 400 nm");
  EXPECT_EQ(labels(linearTicks(0.0195, 0.0205, 3, "m")), "19.5 20.0 20.5 mm");
  EXPECT_EQ(labels(linearTicks(0, 3900, 4, "N/m")), "0 1 2 3 kN/m");
  EXPECT_EQ(labels(linearTicks(-50.6e-6, -49.4e-6, 3, "m")),
            "\u221250.5 \u221250.0 \u221249.5 \u00B5m");
}

/// Beyond the smallest and the largest prefix.
TEST(Ticks, WithoutAPrefixAUnitCountsInPowersOfTen) {
  EXPECT_EQ(labels(linearTicks(0, 5e-29, 6, "N/m")), "0 1 2 3 4 5 10\u207B\u00B2\u2079 N/m");
  EXPECT_EQ(labels(linearTicks(0, 4e20, 5, "N/m")), "0 1 2 3 4 10\u00B2\u2070 N/m");
  EXPECT_EQ(labels(linearTicks(0, 4e-15, 5, "m")), "0 1 2 3 4 fm");
  EXPECT_EQ(labels(linearTicks(0, 400e15, 5, "Pa")), "0 100 200 300 400 PPa");
}

TEST(Ticks, StepsAreOneTwoOrFiveAndNeverTooMany) {
  for (double from : {-3.3e-7, 0.0, 0.012, -5e3}) {
    for (double size = 1e-9; size < 1e6; size *= 3.7) {
      for (int most = 1; most < 13; ++most) {
        const AxisTicks axis = linearTicks(from, from + size, most, "m");
        ASSERT_LE(static_cast<int>(axis.ticks.size()), std::max(most, 1)) << from << " " << size;
        if (axis.ticks.size() < 2) continue;
        const double step = axis.ticks[1].value - axis.ticks[0].value;
        const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-4));
        const double nearest = std::round(mantissa);
        EXPECT_TRUE(nearest == 1 || nearest == 2 || nearest == 5) << step;
        EXPECT_GE(axis.ticks.front().value, from - 1e-6 * size);
        EXPECT_LE(axis.ticks.back().value, from + size * (1 + 1e-6));
        for (std::size_t i = 1; i < axis.ticks.size(); ++i)
          EXPECT_NE(axis.ticks[i].label, axis.ticks[i - 1].label);
      }
    }
  }
}

TEST(Ticks, NoneWhereThereIsNoAxis) {
  EXPECT_TRUE(linearTicks(1, 1, 5, "m").ticks.empty());
  EXPECT_TRUE(linearTicks(2, 1, 5, "m").ticks.empty());
  EXPECT_TRUE(linearTicks(0, 1, 0, "m").ticks.empty());
  EXPECT_TRUE(linearTicks(0, kInfinite, 5, "m").ticks.empty());
  EXPECT_TRUE(linearTicks(0, std::nan(""), 5, "m").ticks.empty());
  EXPECT_TRUE(linearTicks(1e9, 1e9 + 1e-6, 5, "m").ticks.empty());
}

TEST(Ticks, RoundUpFindsTheNextRoundNumber) {
  EXPECT_DOUBLE_EQ(roundUp125(0.011), 0.02);
  EXPECT_DOUBLE_EQ(roundUp125(0.01), 0.01);
  EXPECT_DOUBLE_EQ(roundUp125(51), 100);
  EXPECT_DOUBLE_EQ(roundUp(21), 25);
  EXPECT_DOUBLE_EQ(roundUp(8.1e-4), 1e-3);
}

TEST(ShortNumber, KeepsThreeDigits) {
  EXPECT_EQ(shortNumber(0), "0");
  EXPECT_EQ(shortNumber(0.0123456), "0.0123");
  EXPECT_EQ(shortNumber(0.012), "0.012");
  EXPECT_EQ(shortNumber(0.012, 3, Zeros::Keep), "0.0120");
  EXPECT_EQ(shortNumber(-1.5), "\u22121.5");
  EXPECT_EQ(shortNumber(1), "1");
  EXPECT_EQ(shortNumber(100), "100");
  EXPECT_EQ(shortNumber(0.9999), "1");
  EXPECT_EQ(shortNumber(2944, 2), "2,900");
  EXPECT_EQ(shortNumber(2.3e-5), "2.3\u00D710\u207B\u2075");
  EXPECT_EQ(shortNumber(-4e12), "\u22124\u00D710\u00B9\u00B2");
  EXPECT_EQ(shortNumber(kInfinite), "\u2013");
  EXPECT_EQ(shortNumber(std::nan("")), "\u2013");
}

TEST(Quantity, ChoosesThePrefix) {
  EXPECT_EQ(quantity(0.0034, "N"), "3.4 mN");
  EXPECT_EQ(quantity(0, "N"), "0 N");
  EXPECT_EQ(quantity(1.05e-6, "m"), "1.05 \u00B5m");
  EXPECT_EQ(quantity(0.001, "s"), "1 ms");
  EXPECT_EQ(quantity(1e-6, "m"), "1 \u00B5m");
  EXPECT_EQ(quantity(1e7, "Pa"), "10 MPa");
  EXPECT_EQ(quantity(0.9999, "m"), "1 m");
  EXPECT_EQ(quantity(-0.1, "m/s"), "\u2212100 mm/s");
  EXPECT_EQ(quantity(std::nan(""), "m"), "\u2013");
  EXPECT_EQ(quantity(3e-20, "N"), "3\u00D710\u207B\u00B2\u2070 N");
}

TEST(Ticks, UnitsThatTakeNoPrefixCountInPowersOfTen) {
  EXPECT_EQ(labels(linearTicks(0, 0.8, 5, "")), "0.0 0.2 0.4 0.6 0.8 ");
  EXPECT_EQ(labels(linearTicks(0, 0.02, 3, "")), "0.00 0.01 0.02 ");
  EXPECT_EQ(labels(linearTicks(0, 3e-6, 4, "")), "0 1 2 3 10\u207B\u2076");
  EXPECT_EQ(labels(linearTicks(0, 4e6, 3, "1/m")), "0 2 4 10\u2076 1/m");
  EXPECT_EQ(labels(linearTicks(0, 9e-4, 5, "")), "0 2 4 6 8 10\u207B\u2074");
  EXPECT_EQ(labels(linearTicks(4e-4, 1.1e-3, 4, "")), "0.4 0.6 0.8 1.0 10\u207B\u00B3");
  EXPECT_EQ(labels(linearTicks(-6e-5, 2e-5, 5, "")), "\u22126 \u22124 \u22122 0 2 10\u207B\u2075");
  EXPECT_EQ(labels(linearTicks(0, 6e7, 4, "1/m")), "0 2 4 6 10\u2077 1/m");
  EXPECT_EQ(labels(linearTicks(0, 60, 4, "%")), "0 20 40 60 %");
  EXPECT_EQ(labels(linearTicks(0, 0.04, 3, "m\u00B2")), "0.00 0.02 0.04 m\u00B2");
  EXPECT_EQ(labels(linearTicks(0, 4000, 3, "m/s\u00B2")), "0 2 4 km/s\u00B2");
}

TEST(Ticks, MinorOnesSplitTheStepsIntoRoundParts) {
  const auto minor = [](double from, double to, int most) {
    return minorTicks(linearTicks(from, to, most, "m"), from, to);
  };
  const std::vector<double> fifths = minor(0, 4, 5);  // step 1
  ASSERT_EQ(fifths.size(), 16U);
  EXPECT_NEAR(fifths[0], 0.2, 1e-12);
  EXPECT_NEAR(fifths[4], 1.2, 1e-12);
  const std::vector<double> quarters = minor(-0.6, 4.4, 3);  // step 2, and both ends
  ASSERT_EQ(quarters.size(), 7U);
  EXPECT_NEAR(quarters.front(), -0.5, 1e-12);
  EXPECT_NEAR(quarters.back(), 3.5, 1e-12);
  EXPECT_TRUE(minor(1, 1, 5).empty());
  // The outermost two ticks of a low axis may be three steps apart.
  AxisTicks outermost = linearTicks(0, 6, 4, "m");
  keepOutermost(outermost.ticks);
  ASSERT_EQ(labels(outermost), "0 6 m");
  EXPECT_TRUE(minorTicks(outermost, 0, 6).empty());
}

/// Two numbers wherever two fit: the outermost ones, if not all.
TEST(Ticks, BelowANarrowAxisThereAreTwo) {
  constexpr float kSize = 12;
  for (const float letters : {4.0F, 5.0F, 7.0F, 10.0F})
    for (double from = -3.1; from < 0; from += 0.07)
      for (const double size : {0.2, 0.37, 0.6, 1.0, 1.3, 1.9, 2.6, 4.0}) {
        const float pixels = letters * kSize;
        const auto isSparse = [&](const AxisTicks& axis) {
          const double apart = (axis.ticks[1].value - axis.ticks[0].value) / size * pixels;
          return apart > widestLabel(axis.ticks, kSize) + kSize;
        };
        bool fits = false;
        for (const int most : {2, 3, 4, 5, 6, 8, 10, 12}) {
          AxisTicks two = linearTicks(from, from + size, most, "m");
          keepOutermost(two.ticks);
          fits = fits || (two.ticks.size() == 2 && isSparse(two));
        }
        const AxisTicks axis = sparseTicks(from, from + size, pixels, kSize, "m");
        EXPECT_GE(axis.ticks.size(), fits ? 2U : 1U) << letters << ' ' << from << ' ' << size;
        EXPECT_TRUE(axis.ticks.size() < 2 || isSparse(axis));
      }
}

/// Two numbers say less of a scale than three; a low axis has two, though, that do not touch.
TEST(Ticks, BesideALowAxisThereAreThreeWhereTheyFit) {
  constexpr float kSize = 10, kEach = 48;
  for (const float pixels : {110.0F, 80.0F, 60.0F})
    EXPECT_GE(yTicks(-0.9e-6, 2.4e-6, pixels, kEach, kSize, "m").ticks.size(), 3U) << pixels;
  EXPECT_EQ(yTicks(-0.9e-6, 2.4e-6, 30, kEach, kSize, "m").ticks.size(), 2U);
  EXPECT_EQ(yTicks(0, 1, 100, kEach, kSize, "").ticks.size(), 3U);
}

TEST(FactorText, GroupsThousands) {
  EXPECT_EQ(factorText(0.5), "0.5");
  EXPECT_EQ(factorText(600), "600");
  EXPECT_EQ(factorText(1000), "1,000");
  EXPECT_EQ(factorText(1.4142e6), "1,410,000");
  EXPECT_EQ(factorText(999.9), "1,000");
}

TEST(ReadingInLanguage, HasItsGroupsOfThousands) {
  EXPECT_EQ(readingInLanguage("999.5 s"), "999.5 s");
  EXPECT_EQ(readingInLanguage("1000"), "1,000");
  EXPECT_EQ(readingInLanguage("−12300.25 m/s"), "−12,300.25 m/s");
  EXPECT_EQ(readingInLanguage("2.3×10⁵"), "2.3×10⁵");
  EXPECT_EQ(readingInLanguage("–"), "–");
  EXPECT_EQ(readingInLanguage(""), "");
  useLanguage("de");
  EXPECT_EQ(readingInLanguage("12300.25 s"), "12.300,25 s");
  useLanguage("en");
}

/// Numbers on axes, beside them and in readings are written alike.
TEST(ReadingInLanguage, IsThatOfAxesAndReadings) {
  EXPECT_EQ(labels(linearTicks(0, 20000, 3, "1/m")), "0 10,000 20,000 1/m");
  EXPECT_EQ(shortNumber(12300), "12,300");
  EXPECT_EQ(quantity(1000, "m/s"), "1,000 m/s");
  EXPECT_EQ(readingLabel(12300), QStringLiteral("12,300"));
}

TEST(NumberWithError, EndsAtTheSecondDigitOfTheError) {
  EXPECT_EQ(numberWithError(0.36, 1e-5), "0.360000 ± 0.000010");
  EXPECT_EQ(numberWithError(-0.951, 0.042), "−0.951 ± 0.042");
  EXPECT_EQ(numberWithError(2.6374e-7, 1.2e-9), "(2.637 ± 0.012)×10⁻⁷");
  EXPECT_EQ(numberWithError(0.3, std::nan("")), "0.3");
  EXPECT_EQ(numberWithError(0.3, 0, Zeros::Keep), "0.300");
}

/// As friction does in a motion that turns round.
TEST(NumberWithError, PassesThroughZero) {
  EXPECT_EQ(numberWithError(1.2e-7, 0.002), "0.00000 ± 0.00200");
  EXPECT_EQ(numberWithError(-1.2e-7, 0.002), "0.00000 ± 0.00200");
  EXPECT_EQ(numberWithError(0, 0.002), "0.00000 ± 0.00200");
}

TEST(ReadingLabel, ReadsLikePrint) {
  EXPECT_EQ(readingLabel(0.125), QStringLiteral("0.125"));
  EXPECT_EQ(readingLabel(2.5e-5), QStringLiteral("2.5×10⁻⁵"));
  EXPECT_EQ(readingLabel(1e-6), QStringLiteral("10⁻⁶"));
  EXPECT_EQ(readingLabel(0.01234, 2), QStringLiteral("0.012"));
  EXPECT_EQ(readingLabel(std::nan("")), QStringLiteral("–"));
  EXPECT_EQ(readingLabel(-0.41), QStringLiteral("−0.41"));
  EXPECT_EQ(readingLabel(-2.5e-5), QStringLiteral("−2.5×10⁻⁵"));
}

}  // namespace
}  // namespace asperity
