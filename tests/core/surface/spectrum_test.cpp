#include "core/surface/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

TEST(Spectrum, TheNyquistModeIsDropped) {
  EXPECT_EQ(modeCount(3), 1U);
  EXPECT_EQ(modeCount(4), 1U);
  EXPECT_EQ(modeCount(5), 2U);
  EXPECT_EQ(modeCount(5000), 2499U);
}

TEST(Spectrum, AmplitudesFollowThePowerLawAndGiveTheHeight) {
  for (const double hurst : {0.0, 0.3, 0.7, 1.0}) {
    const auto a = selfAffineAmplitudes(1000, hurst, 5e-7);
    double sum = 0;
    for (const double amplitude : a) sum += amplitude * amplitude / 2;
    EXPECT_NEAR(std::sqrt(sum), 5e-7, 1e-19);
    // C ~ a^2 ~ q^(-2H-1)
    EXPECT_NEAR(std::pow(a[9] / a[99], 2), std::pow(10.0, 2 * hurst + 1), 1e-9 * std::pow(10, 3));
  }
}

/// grad L / h of N = 5000 elements: the known table, which keeps mode 2500.
TEST(Spectrum, SlopeOfThePapersLine) {
  const std::pair<double, double> table[] = {{0.2, 1500.6}, {0.3, 842.7}, {0.5, 245.0},
                                             {0.7, 71.9},   {0.8, 40.9},  {1.0, 16.6}};
  for (const auto& [hurst, expected] : table) {
    const auto a = selfAffineAmplitudes(5001, hurst, 1);
    double sum = 0;
    for (std::size_t j = 0; j < a.size(); ++j)
      sum += std::pow(a[j] * 2 * std::numbers::pi * static_cast<double>(j + 1), 2) / 2;
    EXPECT_NEAR(std::sqrt(sum), expected, 0.05) << hurst;
  }
}

TEST(Spectrum, HeightAndSlopeOfOneMode) {
  FourierLine line{0.02, {0, {3e-7, 4e-7}}};  // amplitude 2 |c| = 1e-6 at mode 2
  EXPECT_NEAR(rmsHeight(line), 1e-6 / std::sqrt(2), 1e-20);
  EXPECT_NEAR(rmsSlope(line), 1e-6 * 200 * std::numbers::pi / std::sqrt(2), 1e-16);
}

}  // namespace
}  // namespace asperity
