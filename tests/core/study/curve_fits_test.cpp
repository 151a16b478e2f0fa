// Fits of whole curves against curves of a known form.
#include "core/study/curve_fits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/scene/range.h"

namespace asperity {
namespace {

using Function = std::function<double(double)>;

double valueOf(const CurveFitValues& fits, std::string_view name) {
  const auto entry = std::ranges::find_if(
      kCurveFits, [&](const CurveFitEntry& one) { return std::string_view(one.name) == name; });
  EXPECT_NE(entry, kCurveFits.end()) << name;
  return fits[static_cast<std::size_t>(entry - kCurveFits.begin())];
}

std::vector<CurvePoint> pointsOf(const std::vector<double>& x, const Function& mu) {
  std::vector<CurvePoint> points;
  for (const double value : x) {
    CurvePoint point{.velocity = value, .mu = mu(value), .realizations = 1};
    points.push_back(point);
  }
  return points;
}

CurveFitValues fitsOf(const std::vector<double>& x, const Function& mu, const Scene& scene = {}) {
  return curveFits(scene, x, pointsOf(x, mu));
}

TEST(CurveFits, APowerLawHasItsExponentAndNoPeak) {
  const CurveFitValues fits =
      fitsOf(logSpaced(1e-3, 1e2, 21), [](double v) { return 0.02 * std::pow(v, 0.37); });
  EXPECT_NEAR(valueOf(fits, "fit.exponent"), 0.37, 1e-12);
  EXPECT_NEAR(valueOf(fits, "fit.exponent_residual"), 0, 1e-12);
  EXPECT_DOUBLE_EQ(valueOf(fits, "fit.maximum"), 0.02 * std::pow(1e2, 0.37));
  EXPECT_TRUE(std::isnan(valueOf(fits, "fit.place_of_maximum")));
  EXPECT_TRUE(std::isnan(valueOf(fits, "fit.half_width")));
}

/// mu = m exp(-ln^2(v/v_0) / (2 s^2)) is half its maximum sqrt(2 ln 2) s away from it to each side.
TEST(CurveFits, APeakHasItsPlaceHeightAndWidth) {
  constexpr double kHeight = 0.7, kPlace = 0.3, kSpread = 1.9;
  const Function peak = [&](double v) {
    const double away = std::log(v / kPlace) / kSpread;
    return kHeight * std::exp(-0.5 * away * away);
  };
  double before = 1;
  for (const std::int64_t points : {41, 81, 161}) {
    const CurveFitValues fits = fitsOf(logSpaced(1e-5, 1e3, points), peak);
    EXPECT_NEAR(valueOf(fits, "fit.maximum"), kHeight, 1e-3 * kHeight);
    EXPECT_NEAR(valueOf(fits, "fit.place_of_maximum"), kPlace, 1e-2 * kPlace);
    const double width = 2 * std::sqrt(2 * std::numbers::ln2) * kSpread / std::numbers::ln10;
    const double error = std::abs(valueOf(fits, "fit.half_width") - width);
    EXPECT_LT(error, 0.02 * width) << points;
    EXPECT_LT(error, 0.6 * before) << points;  // of second order, up to its phase
    before = error;
    EXPECT_GT(valueOf(fits, "fit.exponent_residual"), 0.1);
  }
}

TEST(CurveFits, TheDirectionOfTheSweepChangesNothing) {
  const Function bent = [](double v) { return v / (1 + v) / (1 + v / 3e2); };
  std::vector<double> up = logSpaced(1e-4, 1e4, 33), down(up.rbegin(), up.rend());
  const CurveFitValues rising = fitsOf(up, bent), falling = fitsOf(down, bent);
  int known = 0;
  for (std::size_t i = 0; i < rising.size(); ++i) {
    ASSERT_EQ(std::isnan(rising[i]), std::isnan(falling[i])) << kCurveFits[i].name.text();
    if (std::isnan(rising[i])) continue;
    EXPECT_EQ(rising[i], falling[i]) << kCurveFits[i].name.text();
    ++known;
  }
  EXPECT_EQ(known, 13);
}

/// On an axis of whole numbers or a linear one a parabola in ln x has no equal steps.
TEST(CurveFits, AnUnevenAxisHasItsHighestPoint) {
  const CurveFitValues fits =
      fitsOf({1, 2, 3, 5, 8, 13}, [](double x) { return 1 / (1 + (x - 4.5) * (x - 4.5)); });
  EXPECT_EQ(valueOf(fits, "fit.place_of_maximum"), 5);
  EXPECT_DOUBLE_EQ(valueOf(fits, "fit.maximum"), 1 / 1.25);
}

/// mu = v/(1 + v): 20 % below its line at v = 1/4, at 95 % of its largest value at v = 19.
TEST(CurveFits, RegionsBeginWhereTheyAreDefined) {
  const std::vector<double> velocities = logSpaced(1e-5, 1e5, 401);
  CurveFitValues fits = fitsOf(velocities, [](double v) { return v / (1 + v); });
  EXPECT_NEAR(valueOf(fits, "fit.begin_of_region_2"), 0.25, 1e-3);
  EXPECT_NEAR(valueOf(fits, "fit.begin_of_region_3"), 19, 0.1);
  EXPECT_TRUE(std::isnan(valueOf(fits, "fit.begin_of_region_4")));
  EXPECT_NEAR(valueOf(fits, "fit.exponent_region_1"), 1, 0.03);
  EXPECT_GT(valueOf(fits, "fit.exponent_region_1"), valueOf(fits, "fit.exponent_region_2"));
  EXPECT_GT(valueOf(fits, "fit.exponent_region_2"), valueOf(fits, "fit.exponent_region_3"));
  EXPECT_GT(valueOf(fits, "fit.exponent_region_3"), 0);
  EXPECT_TRUE(std::isnan(valueOf(fits, "fit.exponent_region_4")));
  EXPECT_GT(valueOf(fits, "fit.plateau"), 0.95);
  EXPECT_LT(valueOf(fits, "fit.plateau"), 1);
  // v/(1 + v)/(1 + v/w) has its maximum at v = sqrt(w); where it is a again, a quadratic equation.
  constexpr double kFall = 1e4;
  fits = fitsOf(velocities, [](double v) { return v / (1 + v) / (1 + v / kFall); });
  const double a = 0.95 / std::pow(1 + 1 / std::sqrt(kFall), 2);
  const double half = (1 - a - a / kFall) / 2;
  const double root = std::sqrt(half * half - a * a / kFall);
  EXPECT_NEAR(valueOf(fits, "fit.place_of_maximum"), std::sqrt(kFall), 1);
  EXPECT_NEAR(valueOf(fits, "fit.begin_of_region_4") / ((half + root) * kFall / a), 1, 2e-3);
  EXPECT_NEAR(valueOf(fits, "fit.begin_of_region_3") / ((half - root) * kFall / a), 1, 2e-3);
  // d ln mu / d ln v = 1/(1 + v) - v/(w + v), which falls along the region.
  const double begin = valueOf(fits, "fit.begin_of_region_4"), end = velocities.back();
  EXPECT_LT(valueOf(fits, "fit.exponent_region_4"), 1 / (1 + begin) - begin / (kFall + begin));
  EXPECT_GT(valueOf(fits, "fit.exponent_region_4"), 1 / (1 + end) - end / (kFall + end));
}

TEST(CurveFits, OnlyVelocitiesOfOneRelaxationTimeHaveRegions) {
  const std::vector<double> x = logSpaced(1e-5, 1e5, 41);
  const Function saturating = [](double v) { return v / (1 + v); };
  Scene scene;
  ASSERT_TRUE(std::isfinite(valueOf(fitsOf(x, saturating, scene), "fit.plateau")));
  scene.elastomer.rheology = Rheology::StandardSolid;
  EXPECT_TRUE(std::isnan(valueOf(fitsOf(x, saturating, scene), "fit.plateau")));
  EXPECT_TRUE(std::isfinite(valueOf(fitsOf(x, saturating, scene), "fit.exponent")));
  scene.elastomer.rheology = Rheology::Kelvin;
  scene.sweep.key = "load.normal_force";
  EXPECT_TRUE(std::isnan(valueOf(fitsOf(x, saturating, scene), "fit.plateau")));
  EXPECT_TRUE(std::isfinite(valueOf(fitsOf(x, saturating, scene), "fit.exponent")));
}

TEST(CurveFits, WhatHasNoLogarithmIsLeftOut) {
  const std::vector<double> x = logSpaced(1e-2, 1e2, 9);
  const CurveFitValues fits = fitsOf(x, [&](double v) {
    if (v == x[2]) return kNotApplicable;
    return v == x[5] ? 0.0 : v * v;
  });
  EXPECT_NEAR(valueOf(fits, "fit.exponent"), 2, 1e-12);
  const CurveFitValues few = fitsOf(x, [&](double v) { return v < x[2] ? v : kNotApplicable; });
  for (const double value : few) EXPECT_TRUE(std::isnan(value));
  Scene elastic;
  elastic.elastomer.rheology = Rheology::Elastic;
  for (const double value : fitsOf(
           x, [](double v) { return v; }, elastic))
    EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace asperity
