// Rows of measured moduli: one strain amplitude, and sweeps at constant temperatures.
#include "core/material/isotherms.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/base/input_error.h"
#include "core/material/dma_columns.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(Isotherms, RowsOfAnyOrderBecomeSweeps) {
  std::vector<MeasuredModulus> rows;
  for (const double kelvin : {300.0, 280.0, 290.0})
    for (const double frequency : {10.0, 1.0, 3.0})
      rows.push_back({kelvin + 0.05 * frequency / 10, {frequency, 1e6, 1e5}});
  const auto isotherms = groupIsotherms(rows);
  ASSERT_EQ(isotherms.size(), 3U);
  EXPECT_NEAR(isotherms[0].temperature, 280.0233, 1e-3);
  EXPECT_EQ(isotherms[2].lowestFrequency(), 1);
  EXPECT_EQ(isotherms[2].highestFrequency(), 10);
}

TEST(Isotherms, EqualFrequenciesAreAveraged) {
  const auto isotherms =
      groupIsotherms({{300, {1, 1e6, 1e5}}, {300, {1, 4e6, 1e5}}, {300, {2, 3e6, 2e5}}});
  ASSERT_EQ(isotherms.front().points.size(), 2U);
  EXPECT_NEAR(isotherms.front().points.front().storage, 2e6, 1e-3);
  EXPECT_EQ(isotherms.front().repeats, 1U);
  EXPECT_NEAR(isotherms.front().repeatRatio, 4, 1e-12);
}

TEST(Isotherms, BadRowsAreSaidInOneLine) {
  EXPECT_THAT(errorFrom([] {
                groupIsotherms({{300, {1, 1e6, 1e5}}, {310, {1, 1e6, 1e5}}});
              }),
              HasSubstr("one frequency alone at"));
  EXPECT_THAT(errorFrom([] {
                groupIsotherms({{300, {1, 1e6, -1}}, {300, {2, 1e6, 1}}});
              }),
              HasSubstr("modulus: \u22121 Pa is outside"));
  std::vector<MeasuredModulus> ramp;
  for (int i = 0; i < 40; ++i) ramp.push_back({280 + 0.25 * i, {1.0 + i, 1e6, 1e5}});
  EXPECT_THAT(errorFrom([&] { groupIsotherms(ramp); }), HasSubstr("without a gap"));
}

/// A sweep at 25 degrees is at 298.15 K, not at a mean that rounding moved.
TEST(Isotherms, HaveTheTemperatureOfTheirRowsExactly) {
  for (int points = 2; points < 40; ++points) {
    std::vector<MeasuredModulus> rows;
    for (int i = 0; i < points; ++i) rows.push_back({298.15, {1.0 + i, 1e6, 1e5}});
    EXPECT_EQ(groupIsotherms(rows).front().temperature, 298.15) << points;
  }
}

/// Rubber with filler is softer the more it is strained (Payne effect).
TEST(Isotherms, OneStrainAmplitudeIsChosen) {
  const auto rows = [] {
    std::vector<MeasuredModulus> all;
    for (const double strain : {0.001, 0.0101, 0.1})
      for (const double frequency : {1.0, 3.0, 10.0})
        all.push_back({293.15, {frequency, 1e6 / strain, 1e5}, strain});
    return all;
  };
  auto all = rows();
  EXPECT_THAT(errorFrom([&] { chooseStrain(all, {}, 0.6, "dma.csv"); }),
              HasSubstr("choose one amplitude with --strain: 0.1 %, 1.01 %, 10 %"));
  EXPECT_NEAR(chooseStrain(all, 0.01, 0.6, "dma.csv"), 0.0101, 1e-12);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0].modulus.storage, 1e6 / 0.0101, 1e-3);
  all = rows();
  EXPECT_THAT(errorFrom([&] { chooseStrain(all, 0.03, 0.6, "dma.csv"); }),
              HasSubstr("--strain: 3 % was not measured; there is 0.1 %, 1.01 %, 10 %"));
  // A smaller amplitude at low temperatures is usual.
  all = rows();
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].temperature += static_cast<double>(10 * (i / 3));
  EXPECT_NEAR(chooseStrain(all, {}, 0.6, "dma.csv"), 0.0101, 1e-12);
  EXPECT_EQ(all.size(), 9U);
  all.front().strainAmplitude = std::numeric_limits<double>::quiet_NaN();
  all.resize(1);
  EXPECT_TRUE(std::isnan(chooseStrain(all, {}, 0.6, "dma.csv")));
  EXPECT_EQ(parseStrain("1%"), 0.01);
  EXPECT_EQ(parseStrain("0.01"), 0.01);
  EXPECT_FALSE(parseStrain("1 mm"));
}

}  // namespace
}  // namespace asperity
