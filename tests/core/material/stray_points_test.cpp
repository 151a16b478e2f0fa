// Points that their neighbours along the frequency contradict.
#include "core/material/stray_points.h"

#include <gtest/gtest.h>

#include "tests/core/material/synthetic_rubber.h"

namespace asperity {
namespace {

TEST(StrayPoints, NoiseHasNone) {
  for (const double noise : {0.0, 0.01, 0.05})
    for (const int points : {5, 7, 12, 40})
      for (unsigned seed = 1; seed <= 10; ++seed)
        EXPECT_TRUE(strayPoints(SyntheticRubber().sweeps(points, noise, seed)).empty())
            << noise << " " << points << " " << seed;
}

/// Each point of a sweep in turn, its ends as well.
TEST(StrayPoints, OneSlipIsNamedAndNothingElse) {
  const std::vector<Isotherm> good = SyntheticRubber().sweeps(12, 0.01);
  for (std::size_t at = 0; at < 12; ++at)
    for (const double factor : {0.1, 0.5, 3.0, 10.0}) {
      std::vector<Isotherm> isotherms = good;
      isotherms[3].points[at].storage *= factor;
      const std::vector<StrayPoint> strays = strayPoints(isotherms);
      ASSERT_EQ(strays.size(), 1U) << at << " " << factor;
      EXPECT_EQ(strays.front().isotherm, 3U);
      EXPECT_EQ(strays.front().point, at);
      EXPECT_FALSE(strays.front().isLoss);
      EXPECT_NEAR(strays.front().suggested / good[3].points[at].storage, 1, 0.3) << at;
    }
}

/// One stray in each of two short sweeps spoils up to all other predictions, and neither was found.
TEST(StrayPoints, AreFoundWhereTheySpoilMostPredictions) {
  const SyntheticRubber rubber;
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (std::size_t at = 2; at < 11; ++at) {
      std::vector<Isotherm> pair{rubber.sweep(288.15, 0.1, 50, 13, 0.02, seed),
                                 rubber.sweep(298.15, 0.1, 50, 13, 0.02, seed)};
      pair[0].points[at].storage *= 10;
      pair[1].points[12 - at].storage *= 10;
      EXPECT_EQ(strayPoints(pair).size(), 2U) << seed << " " << at;
    }
}

TEST(StrayPoints, TheWorstComesFirst) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(12, 0.01);
  isotherms[0].points[2].storage *= 3;
  isotherms[5].points[9].loss *= 20;
  const std::vector<StrayPoint> strays = strayPoints(isotherms);
  ASSERT_EQ(strays.size(), 2U);
  EXPECT_TRUE(strays[0].isLoss);
  EXPECT_EQ(describe(strays[1], isotherms).english().find("G\u2032 at \u22125.0 \u00B0C and"), 0U);
  EXPECT_EQ(withoutStrays(isotherms[5], 5, strays).points.size(), 11U);
  EXPECT_EQ(withoutStrays(isotherms[4], 4, strays).points.size(), 12U);
}

}  // namespace
}  // namespace asperity
