// What the means of a curve are means of: resolution against standard error, complete contact,
// lines that differ in their slope, lines that carry different forces.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/chart/curve_set.h"
#include "core/contact/force_balance.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/friction/jackknife.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

using testing::HasSubstr;

Curve curveAt(Scene scene, std::int64_t points) {
  scene.accuracy.oversampling = points;
  return frictionCurve(scene);
}

/// Root mean square over the curve.
template <class Value>
double rmsOf(const Curve& curve, const Value& value) {
  double squares = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) squares += value(i) * value(i);
  return std::sqrt(squares / static_cast<double>(curve.points.size()));
}

/// On lines that the rule was not made from.
TEST(ChosenOversampling, LeavesAnErrorBelowHalfOfTheStandardError) {
  for (const double hurst : {0.0, 0.3, 0.6, 0.9})
    for (const double force : {3e-4, 0.02, 0.4, 20.0}) {
      Scene scene = sceneOfSize(2000, 9, 40);
      scene.surface.hurst = hurst;
      scene.surface.seed = 77;
      scene.load.normalForce = force;
      const Curve chosen = frictionCurve(scene), fine = curveAt(scene, 32);
      const double error =
          rmsOf(chosen, [&](std::size_t i) { return chosen.points[i].mu / fine.points[i].mu - 1; });
      const double standard = rmsOf(chosen, [&](std::size_t i) {
        return chosen.points[i].muStandardError / chosen.points[i].mu;
      });
      EXPECT_LT(error, 0.5 * standard)
          << "H " << hurst << ", " << force << " N, x" << curvePointsPerElement(scene);
    }
}

/// One line has no standard error to hide behind: at contact of more than 5e-4 it is right to 0.1
/// %.
TEST(ChosenOversampling, OfOneLineLeavesAThousandth) {
  for (const double hurst : {0.0, 0.3, 0.6, 0.9})
    for (const std::int64_t seed : {5, 6, 7}) {
      Scene scene = sceneOfSize(5000, 9, 1);
      scene.surface.hurst = hurst;
      scene.surface.seed = seed;
      scene.load.normalForce = 0.05;
      const Curve chosen = frictionCurve(scene), fine = curveAt(scene, 32);
      for (std::size_t i = 0; i < chosen.points.size(); ++i)
        if (chosen.points[i].contactFraction >= 5e-4) {
          EXPECT_NEAR(chosen.points[i].mu / fine.points[i].mu, 1, 1e-3) << "H " << hurst;
        }
    }
}

/// Eq. (8) with the slope of the spectrum: mu F_N = 4 eta v L slope^2.
TEST(CompleteContact, HasTheFrictionOfTheSpectrumAtTheChosenOversampling) {
  for (const double hurst : {0.0, 0.3, 0.7, 1.0})
    for (const std::int64_t lines : {1, 20}) {
      Scene scene = sceneOfSize(1000, 1, lines);
      scene.surface.hurst = hurst;
      scene.load.normalForce = 100;
      scene.sweep = {1e-3, 1e-3, 1};
      const CurvePoint point = frictionCurve(scene).points.front();
      ASSERT_EQ(point.contactFraction, 1);
      const double slope = LineSource(scene, 1).statistics().rmsSlope;
      const double exact = 4 * 1e7 * 1e-3 * 1e-3 * scene.surface.length * slope * slope / 100;
      EXPECT_NEAR(point.mu / exact, 1, 5e-4) << "H " << hurst << ", " << lines << " lines";
    }
}

/// Why complete contact keeps the slope of the line as it is resolved: with that of the spectrum
/// mu would jump where the last gap closes, by far more than it changes there.
TEST(CompleteContact, IsReachedWithoutAJump) {
  for (const double hurst : {0.0, 0.7}) {
    Scene scene = sceneOfSize(1000, 1, 1);
    scene.surface.hurst = hurst;
    const Line line = LineSource(scene, 2).make(0);
    const PreparedProfile profile = prepareProfile(line, Scheme::Cubic);
    const double above = completeAbove(profile, 1e-6);
    const SlidingConditions conditions{1e7, 1e-3, 1e-3};
    const double open = slideAtDepth(profile, conditions, above * (1 - 1e-7)).tangentialForce;
    const double closed = slideAtDepth(profile, conditions, above * (1 + 1e-7)).tangentialForce;
    const double spectral = 4 * 1e7 * 1e-3 * 1e-3 * line.length * line.rmsSlope * line.rmsSlope;
    EXPECT_NEAR(closed / open, 1, 1e-6);
    EXPECT_GT(std::abs(spectral / open - 1), 1e-3);
  }
}

/// In complete contact friction over the slope of its own line is the same for all lines but for
/// that slope: the mean of the ratios is the mean slope, whatever realization 0 is like.
TEST(SummitCorrelation, FrictionIsNormalizedByEachLinesOwnSlope) {
  for (const double kappa : {-2.0, 2.0}) {
    Scene scene = sceneOfSize(500, 1, 12);
    scene.surface.summitCorrelation = kappa;
    scene.load.normalForce = 300;
    scene.sweep = {1e-3, 1e-3, 1};
    const LineSource source(scene, 4);
    double slope = 0, least = 1, most = 0;
    for (std::int64_t r = 0; r < 12; ++r) {
      const double own = source.make(r).rmsSlope;
      slope += own / 12;
      least = std::min(least, own);
      most = std::max(most, own);
    }
    ASSERT_GT(most / least, 1.02);
    const double exact = 4 * 1e7 * 1e-3 * 1e-3 * scene.surface.length * slope / 300;
    const CurvePoint point = frictionCurve(scene).points.front();
    ASSERT_EQ(point.contactFraction, 1);
    EXPECT_NEAR(point.normalizedMu / exact, 1, 3e-4) << kappa;
    EXPECT_NEAR(point.dimensionlessVelocity, 1e-6 * slope / (std::sqrt(2.0) * 5e-7), 1e-9);
    const GroupedMeans means(scene, {300}, {1e-3}, {});
    EXPECT_NEAR(means.normalizedMu(0, 0) / point.normalizedMu, 1, 1e-12);

    CurveSet set;
    set.present = {{}, scene, frictionCurve(scene).points, 0};
    EXPECT_THAT(curveSetCsv(set), HasSubstr("," + csvNumber(point.normalizedMu).substr(0, 10)));
  }
}

TEST(SummitCorrelation, WithoutItNothingIsNormalizedOtherwise) {
  Scene scene = sceneOfSize(500, 3, 5);
  const double slope = LineSource(scene, 1).statistics().rmsSlope;
  for (const CurvePoint& point : frictionCurve(scene).points)
    EXPECT_EQ(point.normalizedMu, point.mu / slope);
}

/// At a constant indentation lines carry different forces: both means stand in the table.
TEST(ConstantIndentation, MeanOfRatiosAndRatioOfMeansAreTwoColumns) {
  Scene scene = sceneOfSize(2000, 1, 30);
  scene.load = {LoadKind::Indentation, 0, 2e-7};
  scene.sweep = {0.01, 0.01, 1};
  const LineSource source(scene, curvePointsPerElement(scene));
  double ratios = 0, tangential = 0, normal = 0;
  for (std::int64_t r = 0; r < 30; ++r) {
    const SteadyResult result = slideAtDepth(prepareProfile(source.make(r), Scheme::Cubic),
                                             slidingConditions(scene, 0.01), 2e-7);
    ratios += result.mu / 30;
    tangential += result.tangentialForce;
    normal += result.normalForce;
  }
  const Curve curve = frictionCurve(scene);
  const CurvePoint& point = curve.points.front();
  EXPECT_NEAR(point.mu / ratios, 1, 1e-10);
  EXPECT_NEAR(point.muRatioOfMeans / (tangential / normal), 1, 1e-10);
  EXPECT_GT(std::abs(point.muRatioOfMeans / point.mu - 1), 0.005);  // they are not the same
  const std::string csv = curveCsv(curve.points), json = curveJson(curve.points, scene);
  EXPECT_THAT(csv, HasSubstr(",mu_mean_of_ratios,mu_ratio_of_means\n"));
  EXPECT_THAT(csv, HasSubstr("," + csvNumber(point.mu) + "," + csvNumber(point.muRatioOfMeans)));
  EXPECT_THAT(json, HasSubstr("\"mu_ratio_of_means\": "));

  scene.load = {};
  EXPECT_EQ(curveCsv(frictionCurve(scene).points).find("ratio"), std::string::npos);
}

}  // namespace
}  // namespace asperity
