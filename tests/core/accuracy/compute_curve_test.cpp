// Curves over any key: each point is that of the state's own curve over velocity, and what the
// model says of scaling holds along the axis.
#include "core/accuracy/compute_curve.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/friction/curve_file.h"
#include "core/material/temperature_shift.h"
#include "core/scene/sweep.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

constexpr double kRounding = 1e-12;

Scene smallScene() {
  return sceneOfSize(300, 5, 6, 0.02);
}

Scene over(Scene scene, const char* key, double from, double to, std::int64_t points,
           SweepScale scale = SweepScale::Logarithmic) {
  scene.sweep = {};
  scene.sweep.key = key;
  scene.sweep.from = from;
  scene.sweep.to = to;
  scene.sweep.points = points;
  scene.sweep.scale = scale;
  checkSweep(scene);
  return scene;
}

void expectSame(const CurvePoint& a, const CurvePoint& b, const std::string& where) {
  EXPECT_NEAR(a.mu, b.mu, kRounding * b.mu) << where;
  EXPECT_NEAR(a.muStandardError, b.muStandardError, kRounding * b.mu) << where;
  EXPECT_NEAR(a.contactFraction, b.contactFraction, kRounding) << where;
  EXPECT_NEAR(a.indentation, b.indentation, kRounding * b.indentation) << where;
  EXPECT_NEAR(a.normalizedMu, b.normalizedMu, kRounding * b.normalizedMu) << where;
  EXPECT_EQ(a.realizations, b.realizations) << where;
  EXPECT_EQ(a.velocity, b.velocity) << where;
}

/// Each point of a curve over any key is the point of that value's own curve over velocity.
void expectOwnCurves(const Scene& scene) {
  const Curve curve = computeCurve(scene);
  const std::vector<double> values = sweepValues(scene);
  EXPECT_TRUE(curve.isComplete);
  ASSERT_EQ(curve.points.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string where = scene.sweep.key + "=" + std::to_string(values[i]);
    EXPECT_EQ(curve.points[i].swept, values[i]) << where;
    expectSame(curve.points[i],
               computeCurveAt(sceneAt(scene, values[i]), scene.sliding.velocity).points.front(),
               where);
  }
}

TEST(CurveOverAnyKey, EachPointIsThatOfItsOwnCurveOverVelocity) {
  const Scene scene = smallScene();
  expectOwnCurves(over(scene, "load.normal_force", 1e-4, 1, 5));
  expectOwnCurves(over(scene, "load.normal_force", 1, 1e-4, 5));  // downwards
  expectOwnCurves(over(scene, "elastomer.shear_modulus", 1e6, 1e8, 3));
  expectOwnCurves(over(scene, "elastomer.temperature", 290, 320, 3, SweepScale::Linear));
  expectOwnCurves(over(scene, "surface.rms_height", 1e-7, 1e-5, 3));
  expectOwnCurves(over(scene, "surface.hurst", 0, 1, 3, SweepScale::Linear));
  expectOwnCurves(over(scene, "load.normal_force", 0.01, 1, 1));  // one point is `from`
}

TEST(CurveOverAnyKey, KeysThatMakeOtherLinesMakeThemForEachValue) {
  const Scene scene = smallScene();
  expectOwnCurves(over(scene, "surface.elements", 100, 400, 3));
  expectOwnCurves(over(scene, "surface.seed", 1, 3, 9, SweepScale::Linear));
  expectOwnCurves(over(scene, "surface.roll_off_wavelength", 1e-3, 1e-2, 2));
  expectOwnCurves(over(scene, "accuracy.oversampling", 1, 4, 3));
}

/// Temperature is a velocity: mu(v, T) = mu(v a_T, T_r).
TEST(CurveOverAnyKey, OverTemperatureFrictionIsThatOfTheShiftedVelocity) {
  const Scene scene = over(smallScene(), "elastomer.temperature", 290, 330, 5, SweepScale::Linear);
  Scene reference = scene;
  reference.sweep = {};
  reference.elastomer.temperature = reference.elastomer.shift.referenceTemperature;
  for (const CurvePoint& point : computeCurve(scene).points) {
    const double shift = shiftFactor(scene.elastomer.shift, point.swept);
    const CurvePoint shifted =
        computeCurveAt(reference, scene.sliding.velocity * shift).points.front();
    EXPECT_NEAR(point.mu, shifted.mu, kRounding * shifted.mu) << point.swept;
  }
}

/// Friction depends on F_N / G alone at a given v tau.
TEST(CurveOverAnyKey, ModulusUpwardsIsForceDownwards) {
  Scene scene = smallScene();
  scene.elastomer.shearModulus = 1e7;
  const Curve forces = computeCurve(over(scene, "load.normal_force", 1e-3, 0.1, 5));
  scene.load.normalForce = 0.01;
  const Curve moduli = computeCurve(over(scene, "elastomer.shear_modulus", 1e8, 1e6, 5));
  for (std::size_t i = 0; i < forces.points.size(); ++i)
    EXPECT_NEAR(moduli.points[i].mu, forces.points[i].mu, 1e-10 * forces.points[i].mu) << i;
}

TEST(CurveOverAnyKey, ForcesAndPowerFollowFromTheirDefinitions) {
  Scene scene = smallScene();
  for (const CurvePoint& point :
       computeCurve(over(scene, "load.normal_force", 1e-3, 1, 3)).points) {
    EXPECT_DOUBLE_EQ(point.forceOnPeriod, point.swept);
    EXPECT_DOUBLE_EQ(point.tangentialForce, point.mu * point.swept);
    EXPECT_DOUBLE_EQ(point.power, point.tangentialForce * scene.sliding.velocity);
    const double length = scene.surface.length;
    EXPECT_DOUBLE_EQ(point.contactPressure,
                     point.swept / (point.contactFraction * length * length));
  }
}

TEST(CurveOverAnyKey, EachValueMeetsATarget) {
  Scene scene = over(smallScene(), "load.normal_force", 1e-2, 1, 2);
  scene.accuracy = {Scheme::Cubic, 0, 0.05};
  const Curve curve = computeCurve(scene);
  EXPECT_TRUE(curve.isTargetMet);
  EXPECT_LE(curve.achievedError, 0.05);
  for (const CurvePoint& point : curve.points) {
    EXPECT_LT(point.muLow, point.mu);
    EXPECT_GT(point.muHigh, point.mu);
  }
}

TEST(CurveOverAnyKey, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const char* key : {"load.normal_force", "surface.roll_off_wavelength"}) {
    const Scene scene = over(smallScene(), key, 1e-3, 1e-2, 4);
    CurveOptions one, three;
    one.threads = 1;
    three.threads = 3;
    EXPECT_EQ(curveCsv(computeCurve(scene, one).points, columnsFor(scene)),
              curveCsv(computeCurve(scene, three).points, columnsFor(scene)));
  }
}

TEST(CurveOverAnyKey, ProgressGrowsToTheWholeCurve) {
  const Scene scene = over(smallScene(), "surface.roll_off_wavelength", 1e-3, 1e-2, 3);
  std::int64_t before = 0, total = 0;
  std::size_t known = 0;
  CurveOptions options;
  options.progress = [&](const CurveProgress& progress) {
    EXPECT_GE(progress.realizationsDone, before);
    before = progress.realizationsDone;
    total = progress.realizationsTotal;
    known = 0;
    for (const CurvePoint& point : progress.points) known += point.realizations > 0 ? 1 : 0;
    EXPECT_GE(known, 1U);
  };
  computeCurve(scene, options);
  EXPECT_EQ(before, total);
  EXPECT_EQ(total, 3 * scene.ensemble.realizations);
  EXPECT_EQ(known, 3U);
}

/// Cancelling leaves the rest of the work undone: the lines slid after the wish are those under
/// way.
TEST(CurveOverAnyKey, CancellingLeavesTheRestUndone) {
  Scene scene = over(smallScene(), "surface.roll_off_wavelength", 1e-3, 1e-2, 8);
  scene.ensemble.realizations = 200;
  std::stop_source source;
  CurveOptions options;
  options.stop = source.get_token();
  std::int64_t done = 0, total = 0;
  options.progress = [&](const CurveProgress& progress) {
    done = progress.realizationsDone;
    total = progress.realizationsTotal;
    source.request_stop();
  };
  const Curve curve = computeCurve(scene, options);
  EXPECT_FALSE(curve.isComplete);
  EXPECT_EQ(done, 1);  // the first line comes alone
  EXPECT_EQ(total, 1600);
}

TEST(CurveOverAnyKey, TheFirstColumnIsTheLastWordOfTheKey) {
  const Scene scene = over(smallScene(), "load.normal_force", 1e-3, 1, 2);
  const Curve curve = computeCurve(scene);
  const std::string text = curveCsv(curve.points, columnsFor(scene));
  EXPECT_EQ(text.substr(0, text.find(',', text.find(',') + 1)), "normal_force,velocity");
  EXPECT_NE(text.find("tangential_force,power"), std::string::npos);
  // The key is not a column twice.
  const std::string header = text.substr(0, text.find('\n'));
  EXPECT_EQ(header.find("normal_force", 1), std::string::npos);
  EXPECT_EQ(text[text.find('\n') + 1], '0');  // 0.001
  // The table over velocity stays as it was.
  EXPECT_EQ(curveCsv(curve.points).find("tangential_force"), std::string::npos);
}

/// To a target, too, a curve over evenly spaced velocities has those of a logarithmic one beside.
TEST(ComputeCurve, ToATargetHasTheLogarithmicVelocitiesBeside) {
  Scene scene = smallScene();
  scene.sweep = {1e-3, 1e2, 6};
  scene.sweep.scale = SweepScale::Linear;
  scene.accuracy.targetRelativeError = 0.3;
  CurveOptions options;
  options.addsLogVelocities = true;
  EXPECT_EQ(computeCurve(scene).points.size(), 6U);
  EXPECT_EQ(computeCurve(scene, options).points.size(), 6U + 6U - 2U);
}

}  // namespace
}  // namespace asperity
