// What a prediction may cost, in counted operations, and that a shorter line speaks for a long one.
#include "core/accuracy/pilot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/accuracy/explanation.h"
#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "core/scene/plan.h"
#include "core/surface/line_source.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

double bytesOf(const Line& line, const PreparedProfile& profile) {
  double numbers = 0;
  for (const auto* values : {&line.height, &line.slopeAfter, &line.slopeBefore,
                             &profile.heightAboveMinimum, &profile.slopeIn, &profile.slopeOut})
    numbers += static_cast<double>(values->size());
  for (const BlockLevel& level : profile.blocks)
    for (const auto* values : {&level.lowest, &level.highest, &level.steepest,
                               &level.heightIntegral, &level.slopeSquared})
      numbers += static_cast<double>(values->size());
  return numbers * sizeof(double);
}

std::vector<Scene> costlyScenes() {
  std::vector<Scene> scenes;
  for (const std::int64_t elements :
       {std::int64_t{5000}, std::int64_t{300000}, std::int64_t{1} << 24})
    for (const std::int64_t points : {1, 41, 100000})
      for (const std::int64_t lines : {1, 200, 1000000}) {
        scenes.push_back(sceneOfSize(elements, points, lines));
        scenes.push_back(scenes.back());
        scenes.back().elastomer.rheology = Rheology::Prony;
        scenes.back().elastomer.arms = std::vector<Arm>(64);
        for (std::size_t i = 0; i < 64; ++i)
          scenes.back().elastomer.arms[i].relaxationTime = std::pow(10.0, -0.1 * double(i));
      }
  return scenes;
}

TEST(Pilot, TakesATenthOfTheRunOrVeryLittle) {
  for (const Scene& scene : costlyScenes())
    for (const int threads : {1, 8}) {
      const PilotPlan plan = planPilot(scene, threads);
      const double parallel =
          std::min<double>(threads, static_cast<double>(scene.ensemble.realizations));
      EXPECT_LE(plan.operations, std::max(kLeastPilot, 0.1 * plan.runOperations / parallel) * 1.001)
          << scene.surface.elements << " elements, " << scene.sweep.points << " points, "
          << scene.ensemble.realizations << " lines";
      EXPECT_LE(plan.operations, kMostPilot);
      EXPECT_LE(plan.velocities.size(), 9U);
      EXPECT_EQ(plan.velocities.front(), scene.sweep.velocityFrom);
    }
}

/// What was counted is what was done.
TEST(Pilot, IsWhatThePredictionDoes) {
  for (const std::int64_t elements : {std::int64_t{2000}, std::int64_t{1} << 24}) {
    const Scene scene = sceneOfSize(elements, 41, 20);
    const PilotPlan plan = planPilot(scene, 2);
    const Prediction prediction = predictCurve(scene, 2);
    EXPECT_EQ(prediction.operations, plan.operations);
    EXPECT_EQ(prediction.pilotLines, plan.lines);
    EXPECT_EQ(prediction.simulations, 20 * 41);
    EXPECT_GT(prediction.error.resolution, 0);
    EXPECT_GT(prediction.error.standardError, 0);
    EXPECT_GT(prediction.seconds, 0);
  }
}

TEST(Pilot, AShorterLineHasTheSameWavesAndLoad) {
  for (const double hurst : {0.0, 0.5, 1.0})
    for (const double rollOff : {0.0, 0.001, 0.02 / 3}) {
      Scene scene = sceneOfSize(1 << 16, 5, 3);
      scene.surface.hurst = hurst;
      scene.surface.rollOffWavelength = rollOff;
      const Scene part = shortened(scene, 16);
      EXPECT_EQ(part.surface.elements, 4096);
      EXPECT_DOUBLE_EQ(part.load.normalForce / part.surface.length,
                       scene.load.normalForce / scene.surface.length);
      const LineSource whole(scene, 1), piece(part, 1);
      // The last mode has the same density.
      const auto density = [](const LineSource& source) {
        const FourierLine line = source.spectrum(0);
        return std::norm(line.coefficients.back()) * line.length;
      };
      EXPECT_NEAR(density(piece) / density(whole), 1, 2e-3) << "H " << hurst << " " << rollOff;
      if (hurst == 1) continue;  // the long waves that it lacks are as steep as the short ones
      EXPECT_NEAR(piece.statistics().rmsSlope / whole.statistics().rmsSlope, 1, 0.01);
    }
  Scene sine = sceneOfSize(1 << 16, 5, 1);
  sine.surface.kind = SurfaceKind::Sine;
  sine.surface.waves = 64;
  EXPECT_EQ(shortened(sine, 8).surface.waves, 8);
  EXPECT_DOUBLE_EQ(shortened(sine, 8).surface.length, sine.surface.length / 8);
  Scene wedge = sine;
  wedge.surface.kind = SurfaceKind::Wedge;
  EXPECT_EQ(shortened(wedge, 8).surface.length, wedge.surface.length);
  EXPECT_EQ(shortened(wedge, 8).load, wedge.load);
  EXPECT_EQ(shortened(sceneOfSize(50, 1, 1), 8), sceneOfSize(50, 1, 1));
}

/// Lines are all but a few numbers of what a long one takes.
TEST(Pilot, MemoryIsThatOfTheLines) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const std::int64_t elements = scheme == Scheme::Nodal ? 400000 : 100000;
    Scene scene = sceneOfSize(elements, 1, 1);
    scene.accuracy.scheme = scheme;
    const Line line = LineSource(scene, pointsPerElementOfCurve(scene)).make(0);
    const double bytes = bytesOf(line, prepareProfile(line, scheme));
    const double ofSource =
        16 * static_cast<double>(line.nodes()) +
        12 * static_cast<double>(elements);  // its transform, amplitudes and phases
    EXPECT_GT(memoryOfCurve(scene, 1) / (bytes + ofSource), 0.85);
    EXPECT_LT(memoryOfCurve(scene, 1) / (bytes + ofSource), 1.25);
    scene.accuracy.oversampling = scheme == Scheme::Nodal ? 1 : 4;
    scene.ensemble.realizations = 8;
    EXPECT_NEAR(memoryOfCurve(scene, 4) / memoryOfCurve(scene, 1), 4, 0.6);
    scene.sweep.points = 100000;
    EXPECT_GT(memoryOfCurve(scene, 1), 9 * 100000 * sizeof(SteadyResult));
  }
}

TEST(Pilot, ThePlanOfALongLineMakesNoLine) {
  const StageCounts before = stageCounts();
  const Explanation explanation = explain(sceneOfSize(1 << 24, 100000, 1));
  EXPECT_TRUE(explanation.predicted.has_value());
  EXPECT_EQ(explanation.predicted->simulations, 100000);
  EXPECT_LE(explanation.predicted->operations,
            std::max(kLeastPilot, 0.1 * explanation.predicted->runOperations));
  EXPECT_LE(explanation.predicted->operations, kMostPilot);
  EXPECT_EQ(stageCounts()[static_cast<std::size_t>(Stage::TimeMarch)],
            before[static_cast<std::size_t>(Stage::TimeMarch)]);
}

}  // namespace
}  // namespace asperity
