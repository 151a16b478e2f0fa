// Least squares: exact lines and power laws, and plateaus.
#include "core/friction/curve_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

TEST(Fit, FindsAnExactLine) {
  const std::vector<double> x{-1, 0, 2, 5}, y{5, 3, -1, -7};
  const LineFit fit = fitLine(x, y);
  EXPECT_NEAR(fit.intercept, 3, 1e-12);
  EXPECT_NEAR(fit.slope, -2, 1e-12);
  EXPECT_NEAR(fit.rmsResidual, 0, 1e-12);
}

/// Least squares leave some 1e-17 of the values; a slope that moves a value by a part in 1e12 is
/// told from that.
TEST(Fit, APlateauHasNoSlope) {
  std::vector<double> x, flat, rising;
  for (int i = 0; i <= 5; ++i) {
    x.push_back(100 * std::pow(10, 0.2 * i));
    flat.push_back(0.137);
    rising.push_back(0.137 * std::pow(x.back(), 1e-12));
  }
  flat[3] = std::nextafter(flat[3], 1);
  EXPECT_EQ(fitPower(x, flat).slope, 0);
  EXPECT_NEAR(fitPower(x, flat).intercept, std::log(0.137), 1e-15);
  EXPECT_NEAR(fitPower(x, rising).slope, 1e-12, 1e-15);
}

TEST(Fit, PowerLaw) {
  const std::vector<double> x{0.01, 0.3, 4, 100};
  std::vector<double> y;
  for (const double value : x) y.push_back(2.5 * std::pow(value, -0.4));
  const LineFit fit = fitPower(x, y);
  EXPECT_NEAR(fit.slope, -0.4, 1e-12);
  EXPECT_NEAR(std::exp(fit.intercept), 2.5, 1e-12);
}

}  // namespace
}  // namespace asperity
