// What a prediction may cost, in counted operations, and that a shorter line speaks for a long one.
#include "core/accuracy/pilot.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/accuracy/explanation.h"
#include "core/base/input_error.h"
#include "core/base/jobs.h"
#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/ensemble.h"
#include "core/scene/plan.h"
#include "core/surface/line_source.h"
#include "tests/core/error_from.h"
#include "tests/core/small_scene.h"
#include "tests/core/temporary_folder.h"

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

PilotScene wholeOf(const Scene& scene) {
  return {scene, lineExtent(scene)};
}

double memoryOf(const Scene& scene, int threads) {
  return curveMemory(wholeOf(scene), threads, curvePointsPerElement(scene));
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
      EXPECT_LE(plan.operations, std::max(kMinPilot, 0.1 * plan.runOperations / parallel) * 1.001)
          << scene.surface.elements << " elements, " << scene.sweep.points << " points, "
          << scene.ensemble.realizations << " lines";
      EXPECT_LE(plan.operations, kMaxPilot);
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
      const Scene part = shortened(wholeOf(scene), 16).scene;
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
  EXPECT_EQ(shortened(wholeOf(sine), 8).scene.surface.waves, 8);
  EXPECT_DOUBLE_EQ(shortened(wholeOf(sine), 8).scene.surface.length, sine.surface.length / 8);
  Scene wedge = sine;
  wedge.surface.kind = SurfaceKind::Wedge;
  EXPECT_EQ(shortened(wholeOf(wedge), 8).scene.surface.length, wedge.surface.length);
  EXPECT_EQ(shortened(wholeOf(wedge), 8).scene.load, wedge.load);
  EXPECT_EQ(shortened(wholeOf(sceneOfSize(50, 1, 1)), 8).scene, sceneOfSize(50, 1, 1));
}

/// Lines are all but a few numbers of what a long one takes.
TEST(Pilot, MemoryIsThatOfTheLines) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const std::int64_t elements = scheme == Scheme::Nodal ? 400000 : 100000;
    Scene scene = sceneOfSize(elements, 1, 1);
    scene.accuracy.scheme = scheme;
    const Line line = LineSource(scene, curvePointsPerElement(scene)).make(0);
    const double bytes = bytesOf(line, prepareProfile(line, scheme));
    const double ofSource =
        16 * static_cast<double>(line.nodes()) +
        12 * static_cast<double>(elements);  // its transform, amplitudes and phases
    EXPECT_GT(memoryOf(scene, 1) / (bytes + ofSource), 0.85);
    EXPECT_LT(memoryOf(scene, 1) / (bytes + ofSource), 1.25);
    scene.accuracy.oversampling = scheme == Scheme::Nodal ? 1 : 4;
    scene.ensemble.realizations = 8;
    EXPECT_NEAR(memoryOf(scene, 4) / memoryOf(scene, 1), 4, 0.6);
    scene.sweep.points = 100000;
    EXPECT_GT(memoryOf(scene, 1), 9 * 100000 * sizeof(SteadyResult));
  }
}

// ---- Profiles -----------------------------------------------------------------------------------

/// A measured line of `rows` rows 1 um apart.
Scene profileScene(const TemporaryFolder& folder, std::int64_t rows) {
  Scene rough = sceneOfSize(rows, 1, 1);
  rough.surface.length = 1e-6 * static_cast<double>(rows);
  const Line line = LineSource(rough, 1).make(0);
  std::string text = "x (m),z (m)\n";
  for (std::int64_t i = 0; i < rows; ++i)
    text += fmt::format("{}e-6,{}\n", i, line.height[static_cast<std::size_t>(i)]);
  folder.write("p.csv", text);
  Scene scene = sceneOfSize(0, 41, 1);
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.length = 0;
  scene.surface.file = "p.csv";
  scene.folder = folder.path();
  scene.load.normalForce = 10 * rough.surface.length;
  return scene;
}

/// Bytes that this process has read from files.
double bytesRead() {
  std::ifstream file("/proc/self/io");
  std::string name;
  double value = 0;
  while (file >> name >> value)
    if (name == "rchar:") return value;
  return 0;
}

/// A file's first rows stand for all of them: explaining it reads a small part of it.
TEST(Pilot, OfALongProfileReadsTheBeginningOfItsFile) {
  const TemporaryFolder folder;
  const Scene scene = profileScene(folder, 300000);
  const auto size = static_cast<double>(std::filesystem::file_size(folder / "p.csv"));
  for (const double target : {0.0, 0.01}) {
    Scene some = scene;
    some.accuracy.targetRelativeError = target;
    const double before = bytesRead();
    const Explanation explanation = explain(some, 2);
    const double read = bytesRead() - before;
    ASSERT_GT(read, 0);
    EXPECT_LT(read, 0.1 * size) << "target " << target;
    EXPECT_GT(explanation.predicted->error.resolution, 0);
  }
}

TEST(Pilot, OfAProfileTakesATenthOfTheRunOrVeryLittle) {
  const TemporaryFolder folder;
  for (const std::int64_t rows : {100, 2000, 300000}) {
    const Scene scene = profileScene(folder, rows);
    const PilotPlan plan = planPilot(scene, 1);
    EXPECT_LE(plan.operations, std::max(kMinPilot, 0.1 * plan.runOperations)) << rows;
    EXPECT_EQ(plan.run.scene.surface.elements, rows);
    EXPECT_EQ(predictCurve(scene, 1).operations, plan.operations);
  }
}

/// The floor of a pilot is far below the run of a few milliseconds.
TEST(Pilot, OfAShortRunIsShort) {
  const PilotPlan plan = planPilot(sceneOfSize(2000, 36, 20), 1);
  EXPECT_LE(plan.operations, 0.1 * plan.runOperations);
}

TEST(Pilot, APartOfAProfileSpeaksForTheWholeOfIt) {
  const TemporaryFolder folder;
  const Scene scene = profileScene(folder, 100000);
  const PilotPlan plan = planPilot(scene, 1);
  EXPECT_GT(plan.shortening, 4);
  const Prediction prediction = predictCurve(scene, 1);
  const double begin = threadSeconds();
  CurveOptions options;
  options.threads = 1;
  frictionCurve(scene, options);
  const double seconds = threadSeconds() - begin;
  EXPECT_GT(prediction.seconds / seconds, 1.0 / 3);
  EXPECT_LT(prediction.seconds / seconds, 3);
  const double error = measureError(scene, 1, 1).resolution;
  EXPECT_GT(prediction.error.resolution / error, 1.0 / 3);
  EXPECT_LT(prediction.error.resolution / error, 3);
  // Memory that is counted, as of other lines.
  const Line line = LineSource(scene, 4).make(0);
  const double bytes = bytesOf(line, prepareProfile(line, Scheme::Cubic)) +
                       static_cast<double>(line.nodes()) * 2 * 16;
  EXPECT_GT(prediction.memory / bytes, 1 / 1.5);
  EXPECT_LT(prediction.memory / bytes, 1.5);
}

/// A plainly bad file is refused as the run refuses it.
TEST(Pilot, AFileThatIsNoProfileIsRefused) {
  const TemporaryFolder folder;
  Scene scene = profileScene(folder, 20000);
  const std::string good = TemporaryFolder::read(folder / "p.csv");
  for (const std::string& bad :
       {std::string("hello\n") + good, good + "20001e-6,much\n", good + "1,1\n", good.substr(0, 40),
        std::string("\x89PNG\r\n\x1a\n") + good}) {
    folder.write("p.csv", bad);
    const std::string ofRun = errorFrom([&] { frictionCurve(scene); });
    EXPECT_NE(ofRun, "no error");
    EXPECT_EQ(errorFrom([&] { explain(scene); }), ofRun);
  }
}

TEST(Pilot, ThePlanOfALongLineMakesNoLine) {
  const StageCounts before = stageCounts();
  const Explanation explanation = explain(sceneOfSize(1 << 24, 100000, 1));
  EXPECT_TRUE(explanation.predicted.has_value());
  EXPECT_EQ(explanation.predicted->simulations, 100000);
  EXPECT_LE(explanation.predicted->operations,
            std::max(kMinPilot, 0.1 * explanation.predicted->runOperations));
  EXPECT_LE(explanation.predicted->operations, kMaxPilot);
  EXPECT_EQ(stageCounts()[static_cast<std::size_t>(Stage::TimeMarch)],
            before[static_cast<std::size_t>(Stage::TimeMarch)]);
}

/// A target of 1e-6 starts millions of lines, which a user learns before the run.
TEST(Prediction, WarnsOfATargetThatNeedsVeryManyLines) {
  Scene scene;
  Prediction prediction;
  prediction.lines = 4e5;
  prediction.seconds = 9000;
  EXPECT_FALSE(warningOf(scene, prediction)) << "the lines of a scene are its own choice";
  scene.accuracy.targetRelativeError = 1e-6;
  const auto many = warningOf(scene, prediction);
  ASSERT_TRUE(many);
  EXPECT_NE(many->english().find("the run takes about 9000 s"), std::string::npos)
      << many->english();
  prediction.lines = 4e7;
  const auto tooMany = warningOf(scene, prediction);
  ASSERT_TRUE(tooMany);
  EXPECT_NE(tooMany->english().find("may miss the target"), std::string::npos);
  prediction.lines = 500;
  EXPECT_FALSE(warningOf(scene, prediction));
}

}  // namespace
}  // namespace asperity
