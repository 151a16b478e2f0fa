// Order of friction in the spacing, on the public profile, for v <= 0.1 m/s.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

/// Least-squares slope of y over x, sign changed.
double order(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    sxx += x[i] * x[i];
    sxy += x[i] * y[i];
  }
  return -(n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double measuredOrder(const std::map<int, PreparedProfile>& lines, const PreparedProfile& finest,
                     double force, double velocity) {
  const SlidingConditions conditions{kModulus, kTau, velocity};
  const double exact = slideAtForce(finest, conditions, force).mu;
  std::vector<double> x, y;
  for (const auto& [oversampling, line] : lines) {
    x.push_back(std::log(oversampling));
    y.push_back(std::log(std::abs(slideAtForce(line, conditions, force).mu / exact - 1)));
  }
  return order(x, y);
}

void expectOrder(Scheme scheme, int highest, double least) {
  std::map<int, PreparedProfile> lines;
  for (int oversampling = 2; oversampling <= highest; oversampling *= 2)
    lines[oversampling] = prepareProfile(referenceProfile(oversampling), scheme);
  const PreparedProfile finest = prepareProfile(referenceProfile(64), Scheme::Cubic);
  for (const double force : {0.001, 0.1, 10.0})
    for (const double velocity : {1e-4, 1e-3, 1e-2, 1e-1})
      EXPECT_GE(measuredOrder(lines, finest, force, velocity), least)
          << force << " N, " << velocity << " m/s";
}

TEST(Convergence, LinearIsSecondOrder) {
  expectOrder(Scheme::Linear, 32, 1.8);
}

TEST(Convergence, CubicIsFourthOrder) {
  expectOrder(Scheme::Cubic, 16, 3.5);
}

}  // namespace
}  // namespace asperity
