// What is read from the curves, against the table of converged figures (N = 5000, 200 lines):
// alpha, beta and the plateau for each Hurst exponent, each within 3 % or three standard errors.
#include "core/paper/figure_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/friction/law.h"

namespace asperity {
namespace {

constexpr int kLines = 40;  // of these tests
constexpr double kLinesOfTable = 200;

/// Half the distance that counts as agreement: 3 %, or three standard errors of the difference.
double allowed(const Estimate& measured, double expected) {
  const double ofTable = measured.standardError * std::sqrt(kLines / kLinesOfTable);
  return std::max(0.03 * expected, 3 * std::hypot(measured.standardError, ofTable));
}

struct Row {
  double hurst, slope, alpha, beta;
  double plateau[3];  // at F_N / G h L = 0.034, 1, 100
};
constexpr Row kRows[] = {
    {0.2, 1500.6, 0.202, 1.92, {1.278, 1.310, 1.325}},
    {0.3, 842.7, 0.244, 1.80, {1.315, 1.346, 1.349}},
    {0.5, 245.0, 0.332, 1.72, {1.378, 1.409, 1.413}},
    {0.7, 71.9, 0.401, 1.66, {1.381, 1.444, 1.454}},
    {0.8, 40.9, 0.423, 1.60, {1.351, 1.432, 1.458}},
    {1.0, 16.6, 0.429, 1.28, {1.130, 1.321, 1.382}},
};

class ConvergedTable : public testing::TestWithParam<Row> {
 protected:
  void SetUp() override {
    scene_.surface.hurst = GetParam().hurst;
    scene_.ensemble.realizations = kLines;
    slope_ = LineSource(scene_, 1).statistics().rmsSlope;
  }

  Scene scene_;
  double slope_ = 0;
};

TEST_P(ConvergedTable, RmsSlope) {
  const double dimensionless = slope_ * scene_.surface.length / scene_.surface.rmsHeight;
  EXPECT_NEAR(dimensionless / GetParam().slope, 1, 3e-3);
}

/// Eqs. (5) and (7) in zone 1.
TEST_P(ConvergedTable, AlphaAndBeta) {
  const GroupedMeans means(scene_, zone1Cases(scene_, slope_), {});
  const Estimate alpha = jackknife(means.groups(), [&](int out) { return fitAlpha(means, out); });
  const Estimate beta = jackknife(means.groups(), [&](int out) { return fitBeta(means, out); });
  EXPECT_NEAR(alpha.value, GetParam().alpha, allowed(alpha, GetParam().alpha));
  EXPECT_NEAR(beta.value, GetParam().beta, allowed(beta, GetParam().beta));
  // The table that Eq. (11) uses.
  EXPECT_NEAR(beta.value, lawPrefactor(GetParam().hurst),
              allowed(beta, lawPrefactor(GetParam().hurst)));
  EXPECT_NEAR(lawPrefactor(GetParam().hurst) / GetParam().beta, 1, 0.01);
}

/// Region III.
TEST_P(ConvergedTable, Plateau) {
  const GroupedMeans means(
      scene_,
      plateauCases(scene_, slope_,
                   {forceAt(scene_, 0.034), forceAt(scene_, 1), forceAt(scene_, 100)}),
      {});
  for (std::size_t j = 0; j < 3; ++j) {
    const Estimate plateau =
        jackknife(means.groups(), [&](int out) { return findPlateau(means, j, out).value; });
    const double expected = GetParam().plateau[j];
    EXPECT_NEAR(plateau.value, expected, allowed(plateau, expected)) << j;
    // The maximum lies inside the velocities that are looked at.
    EXPECT_GT(findPlateau(means, j).x, means.velocities(j).front());
    EXPECT_LT(findPlateau(means, j).x, means.velocities(j).back());
  }
}

INSTANTIATE_TEST_SUITE_P(Hurst, ConvergedTable, testing::ValuesIn(kRows),
                         [](const testing::TestParamInfo<Row>& row) {
                           return "Tenths" +
                                  std::to_string(static_cast<int>(10 * row.param.hurst + 0.5));
                         });

/// Eq. (8) is exact for the line as it is resolved; the spectrum's slope is met at fourth order.
TEST(Readings, FullContactIsEquation8) {
  double last = 1;
  for (const std::int64_t oversampling : {2, 4, 8}) {
    Scene scene;
    scene.surface.elements = 500;
    scene.ensemble.realizations = 3;
    scene.accuracy.oversampling = oversampling;
    const FullContact contact = compareFullContact(GroupedMeans(scene, {100}, {1e-4, 1e-3}, {}));
    EXPECT_EQ(contact.points, 2);
    EXPECT_LT(contact.toResolved, 1e-11);
    EXPECT_LT(contact.toSpectral, 0.15 * last);
    last = contact.toSpectral;
  }
}

/// Regions of a curve that is known: Eq. (11)'s own shape has its borders where they are computed.
TEST(Readings, BordersAreInOrder) {
  Scene scene;
  scene.surface.elements = 1000;
  scene.ensemble.realizations = 5;
  const GroupedMeans means(scene, {0.0034}, {1e-5, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1, 3, 10, 100},
                           {});
  const RegionBorders borders = regionBorders(means, 0);
  EXPECT_GT(borders.endOfLinear, 1e-4);
  EXPECT_GT(borders.toPlateau, borders.endOfLinear);
  EXPECT_GT(borders.offPlateau, borders.toPlateau);
  // At the border the curve is where the rule says.
  const double onLine = means.normalizedMu(0, 0) * borders.endOfLinear / 1e-5;
  EXPECT_NEAR(normalizedMuAt(means, 0, borders.endOfLinear) / onLine, BorderRule{}.ofLine, 1e-9);
}

}  // namespace
}  // namespace asperity
