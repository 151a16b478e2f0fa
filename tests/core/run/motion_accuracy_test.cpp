// What is predicted of a motion against what it does: a real halving of the steps over the whole
// motion, a real march, a longer settling.
#include "core/run/motion_accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/run/rigid_line.h"
#include "core/run/transient.h"

namespace asperity {
namespace {

Scene stepScene() {
  Scene scene;
  scene.surface.elements = 1000;
  scene.accuracy.oversampling = 1;
  scene.load.normalForce = 0.5;
  scene.sliding = {SlidingKind::Step, 0.1, 0.2};
  scene.sliding.duration = 0.08;
  return scene;
}

std::shared_ptr<const RigidLine> lineOf(const Scene& scene) {
  return std::make_shared<const RigidLine>(scene);
}

/// mu in `windows` equal parts of the duration.
std::vector<double> marched(const Scene& scene, int windows, int division) {
  Transient transient(scene, lineOf(scene), Transient::kMinSteps, division);
  std::vector<double> mu;
  for (int i = 1; i <= windows; ++i)
    mu.push_back(transient.marchTo(scene.sliding.duration * i / windows).mu);
  return mu;
}

TEST(MotionSteps, AreCountedAsTheyAreMarched) {
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    Scene scene = stepScene();
    scene.sliding.kind = kind;
    scene.sliding.amplitude = 0.05;
    for (const int division : {1, 2}) {
      Transient transient(scene, lineOf(scene), Transient::kMinSteps, division);
      const double counted = transient.countSteps();
      while (!transient.isOver()) transient.marchTo(scene.sliding.duration);
      EXPECT_EQ(counted, static_cast<double>(transient.steps()));
    }
  }
}

TEST(MotionSteps, ADivisionCutsEachOne) {
  const Scene scene = stepScene();
  const double whole = Transient(scene, lineOf(scene)).countSteps();
  const double halves = Transient(scene, lineOf(scene), Transient::kMinSteps, 2).countSteps();
  EXPECT_NEAR(halves / whole, 2, 0.01);
}

TEST(MotionAccuracy, TheStepErrorIsThatOfARealHalving) {
  for (const double normalForce : {0.05, 0.5, 5.0}) {
    Scene scene = stepScene();
    scene.load.normalForce = normalForce;
    const double predicted = predictMotion(scene).error.timeStep;
    const int windows = 50;
    const std::vector<double> coarse = marched(scene, windows, 1),
                              fine = marched(scene, windows, 2);
    double differences = 0, all = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      differences += std::pow(coarse[i] - fine[i], 2);
      all += fine[i] * fine[i];
    }
    const double real = std::sqrt(differences / all);
    EXPECT_GT(predicted / real, 0.5) << normalForce << ": " << predicted << " for " << real;
    EXPECT_LT(predicted / real, 2) << normalForce << ": " << predicted << " for " << real;
  }
}

TEST(MotionAccuracy, APieceSpeaksForTheWholeMotion) {
  Scene scene = stepScene();
  scene.sliding.duration *= 10;  // the pilot sees a part of it
  const ErrorBudget piece = predictMotion(scene).error, whole = measureMotionError(scene);
  for (const auto part : {&ErrorBudget::timeStep, &ErrorBudget::resolution}) {
    EXPECT_GT(piece.*part / (whole.*part), 0.5) << piece.*part << " for " << whole.*part;
    EXPECT_LT(piece.*part / (whole.*part), 2) << piece.*part << " for " << whole.*part;
  }
}

TEST(MotionAccuracy, StepsAndElementsAreCounted) {
  const Scene scene = stepScene();
  const Prediction prediction = predictMotion(scene);
  EXPECT_EQ(prediction.elements, 1000);
  EXPECT_EQ(prediction.steps, Transient(scene, lineOf(scene)).countSteps());
  EXPECT_GT(prediction.seconds, 0);
  EXPECT_LT(prediction.error.forceBalance, 1e-9);
  EXPECT_TRUE(std::isnan(prediction.error.standardError));
}

/// A motion of far more steps than can be counted, of long lines, of many arms: the pilot stays
/// small.
TEST(MotionAccuracy, IsBoundedHoweverLongTheMotion) {
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal})
    for (const std::int64_t elements : {1000, 1 << 20}) {
      Scene scene = stepScene();
      scene.sliding.kind = kind;
      scene.sliding.velocity = 1;
      scene.sliding.duration = 1e3;
      scene.surface.elements = elements;
      const Prediction prediction = predictMotion(scene);
      EXPECT_LE(prediction.operations,
                1.2 * std::clamp(0.1 * prediction.runOperations, 2.5e6, 1.5e7));
      EXPECT_EQ(prediction.elements, static_cast<double>(elements));
      EXPECT_GT(prediction.error.timeStep, 0);
      EXPECT_GT(prediction.seconds, 0.1 * prediction.steps * 1e-9 * prediction.elements);
    }
}

/// Steps are as long as the spacing over the velocity, however many.
TEST(MotionAccuracy, StepsOfALongMotionAreCountedFromTheirLength) {
  Scene scene = stepScene();
  scene.sliding.velocity = 1;
  scene.sliding.velocityAfter = 3;
  scene.sliding.duration = 1e3;
  const double spacing = scene.surface.length / 1000;
  EXPECT_NEAR(predictMotion(scene).steps / (500 * (1 + 3) / spacing), 1, 1e-2);
  scene.sliding.kind = SlidingKind::Oscillation;  // at least 64 steps a period
  scene.sliding.amplitude = 0.5;
  scene.sliding.frequency = 4.096;  // 4096 periods: moments that are evenly spaced would all meet
  // Its steps are as long as its fastest moment wants.
  EXPECT_NEAR(predictMotion(scene).steps / (1e3 * 1.5 / spacing), 1, 2e-2);
}

TEST(MotionAccuracy, SettlingIsWhatALongerMarchWouldChange) {
  const Scene scene = stepScene();
  const double predicted = predictMotion(scene).error.settling;
  // Steady sliding at the first velocity, eight memories long.
  Scene steady = scene;
  steady.sliding.velocityAfter = steady.sliding.velocity;
  const Transient some(scene, lineOf(scene));
  const double step =
      scene.sliding.velocity > 0 ? some.march().line().spacing / scene.sliding.velocity : 0;
  steady.sliding.duration = std::max(8 * scene.elastomer.relaxationTime, 400 * step);
  Transient march(steady, lineOf(steady));
  const double first = march.marchTo(32 * step).mu;
  while (march.time() < steady.sliding.duration - 40 * step)
    march.marchTo(march.time() + 16 * step);
  const double last = march.marchTo(steady.sliding.duration).mu;
  EXPECT_NEAR(predicted, std::abs(first / last - 1), 0.3 * std::abs(first / last - 1) + 1e-4);
}

TEST(MotionAccuracy, AStartFromRestHasNothingToSettle) {
  Scene scene = stepScene();
  scene.sliding.kind = SlidingKind::Start;
  const ErrorBudget error = predictMotion(scene).error;
  EXPECT_TRUE(std::isnan(error.settling));
  EXPECT_GT(error.timeStep, 0);
}

TEST(MotionAccuracy, SeparateElementsDifferFromALineAndAreNoErrorOfIt) {
  Scene scene = stepScene();
  scene.accuracy = {Scheme::Nodal, 1, 0};
  const ErrorBudget error = predictMotion(scene).error;
  EXPECT_TRUE(std::isnan(error.resolution));
  EXPECT_GT(error.modelDifference, 0);
}

TEST(MotionAccuracy, IsExplainedAndAnalyzed) {
  Explanation explanation = explainRun(stepScene());
  analyzeRun(explanation);
  const auto root = nlohmann::json::parse(explanationJson(explanation));
  for (const char* part : {"time_step", "settling", "resolution"}) {
    EXPECT_TRUE(root["predicted"]["relative_error"][part].is_number()) << part;
    EXPECT_TRUE(root["measured"]["relative_error"][part].is_number()) << part;
  }
  EXPECT_EQ(root["predicted"]["elements"], 1000);
  EXPECT_GT(root["measured"]["seconds"], 0);
  Scene steady;
  steady.surface.elements = 64;
  EXPECT_EQ(explainRun(steady).predicted->steps, 0);
}

TEST(MotionAccuracy, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_ANY_THROW(predictMotion(stepScene(), stop.get_token()));
}

}  // namespace
}  // namespace asperity
