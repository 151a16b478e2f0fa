// Lines that are given, to a target accuracy: the converged friction lies inside the stated
// interval, whatever the roughness, the load and the velocity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/accuracy/prediction.h"
#include "core/accuracy/target_curve.h"
#include "core/contact/steady_solver.h"
#include "core/surface/line_source.h"
#include "tests/core/contact/lines.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

/// A realization of the scene's line as a profile: heights of one period.
std::string profileOf(const Scene& scene) {
  std::string text;
  for (const double height : LineSource(scene, 1).make(0).height) {
    char row[40];
    std::snprintf(row, sizeof row, "%.17g\n", height);
    text += row;
  }
  return text;
}

/// Friction on the scene's line at a resolution that is finer than any that is chosen.
std::vector<SteadyResult> converged(const Scene& scene) {
  const std::vector<double> velocities = sweepVelocities(scene.sweep);
  std::vector<SteadyResult> results(velocities.size());
  const PreparedProfile line = prepareProfile(LineSource(scene, 128).make(0), Scheme::Cubic);
  SteadySolver(scene).sweep(line, scene.load, velocities, results);
  return results;
}

/// Random profiles of H = 0 to 1 under loads from a contact of 3e-5 of the line to all of it.
class GivenLines {
 public:
  Scene next() {
    Scene rough;
    rough.surface.elements = 2 * std::lround(50 * std::pow(4, uniform_(random_)));
    rough.surface.hurst = uniform_(random_);
    rough.surface.seed = ++seed_;
    Scene scene = rough;
    scene.surface = {};
    scene.surface.kind = SurfaceKind::Profile;
    scene.surface.length = rough.surface.length;
    scene.surface.elements = 0;
    scene.surface.file = std::to_string(seed_) + ".csv";
    scene.folder = folder_.path();
    folder_.write(scene.surface.file, profileOf(rough));
    scene.load.normalForce = std::pow(10, -5 + 6.5 * uniform_(random_));
    scene.sweep = {1e-4, 1e3, 8};
    return scene;
  }

 private:
  TemporaryFolder folder_;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_;
  int seed_ = 0;
};

TEST(GivenLine, TheTruthLiesInTheInterval) {
  GivenLines lines;
  int all = 0, outside = 0, met = 0;
  double smallest = 1, largest = 0;
  for (int k = 0; k < 60; ++k) {
    Scene scene = lines.next();
    const std::vector<SteadyResult> truth = converged(scene);
    for (const double target : {1e-1, 1e-2, 1e-3}) {
      scene.accuracy.targetRelativeError = target;
      const TargetCurve result = targetCurve(scene);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        if (truth[i].contactFraction < 3e-5) continue;
        const AchievedAccuracy& achieved = result.achieved[i];
        EXPECT_GE(achieved.oversampling, 4);
        smallest = std::min(smallest, truth[i].contactFraction);
        largest = std::max(largest, truth[i].contactFraction);
        ++all;
        met += achieved.resolutionError <= target * result.curve.points[i].mu ? 1 : 0;
        outside += truth[i].mu < achieved.low || truth[i].mu > achieved.high ? 1 : 0;
      }
    }
  }
  EXPECT_GT(all, 1200);
  EXPECT_LT(smallest, 1e-4);
  EXPECT_GT(largest, 0.999);
  EXPECT_LE(outside, 0.02 * all);
  EXPECT_EQ(met, all);
}

/// The public profile against an independent solver, whose table has digits enough for these
/// targets.
TEST(GivenLine, TheReferenceLiesInTheInterval) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.surface.file = "profile_public.csv";
  scene.folder = std::string(ASPERITY_TESTS_DIR) + "/reference";
  int outside = 0, all = 0;
  for (const ConvergedRow& row : convergedRows())
    for (const double target : {1e-2, 1e-3}) {
      scene.load.normalForce = row.normalForce;
      scene.sweep = {row.velocity, row.velocity, 1};
      scene.accuracy.targetRelativeError = target;
      const TargetCurve result = targetCurve(scene);
      EXPECT_TRUE(result.curve.isTargetMet);
      EXPECT_NEAR(result.curve.points[0].mu / row.mu, 1, target);
      const double digits = 1e-6 * row.mu;
      ++all;
      outside +=
          row.mu < result.achieved[0].low - digits || row.mu > result.achieved[0].high + digits ? 1
                                                                                                : 0;
    }
  EXPECT_GE(all, 60);
  EXPECT_LE(outside, 0.02 * all);
}

/// What is measured after a run is a difference to a finer line and not the estimate again.
TEST(GivenLine, TheErrorIsMeasuredAgainstAFinerLine) {
  GivenLines lines;
  for (int k = 0; k < 4; ++k) {
    Scene scene = lines.next();
    scene.load.normalForce = 0.01;
    scene.accuracy.targetRelativeError = 1e-2;
    const TargetCurve result = targetCurve(scene);
    const std::vector<SteadyResult> truth = converged(scene);
    double squares = 0, stated = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      squares += std::pow(result.curve.points[i].mu / truth[i].mu - 1, 2);
      stated += std::pow(result.achieved[i].resolutionError / truth[i].mu, 2);
    }
    const auto count = static_cast<double>(truth.size());
    const double error = std::sqrt(squares / count);
    const double measured = measureError(scene, 1).resolution;
    EXPECT_NEAR(measured / error, 1, 0.1);
    EXPECT_LT(measured, 0.5 * std::sqrt(stated / count));
  }
}

/// Of lines that are drawn it is the mean's: the standard error is the run's own.
TEST(GivenLine, SoItIsOfMeans) {
  Scene scene;
  scene.surface.elements = 200;
  scene.load.normalForce = 0.01;
  scene.sweep = {1e-2, 10, 2};
  scene.accuracy.targetRelativeError = 0.05;
  const TargetCurve result = targetCurve(scene);
  const ErrorBudget measured = measureError(scene, 16);
  double squares = 0, stated = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    squares += std::pow(result.achieved[i].standardError / result.curve.points[i].mu, 2) / 2;
    stated += std::pow(result.achieved[i].resolutionError / result.curve.points[i].mu, 2) / 2;
  }
  EXPECT_NEAR(measured.standardError / std::sqrt(squares), 1, 1e-9);
  EXPECT_GT(measured.resolution, 0);
  EXPECT_LT(measured.resolution, std::sqrt(stated));
}

}  // namespace
}  // namespace asperity
