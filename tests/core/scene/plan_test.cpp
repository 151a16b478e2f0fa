#include "core/scene/plan.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::string reasonOf(const Scene& scene, Purpose purpose, Stage stage) {
  return planStages(scene, purpose)[static_cast<std::size_t>(stage)].reason.english();
}

TEST(Plan, NamesEveryStageOnceAndGivesAReason) {
  for (const Purpose purpose :
       {Purpose::Curve, Purpose::Picture, Purpose::Surface, Purpose::Window}) {
    const auto plan = planStages(Scene{}, purpose);
    ASSERT_EQ(plan.size(), kStages);
    for (std::size_t i = 0; i < kStages; ++i) {
      EXPECT_EQ(static_cast<std::size_t>(plan[i].stage), i);
      EXPECT_EQ(plan[i].name, stageName(plan[i].stage));
      EXPECT_FALSE(plan[i].reason.empty());
      EXPECT_FALSE(plan[i].reason.english().ends_with('.'));
      EXPECT_EQ(plan[i].runs, needsStage(Scene{}, purpose, plan[i].stage));
    }
  }
}

TEST(Plan, SteadySlidingIsNeverMarched) {
  EXPECT_FALSE(needsStage(Scene{}, Purpose::Curve, Stage::TimeMarch));
  EXPECT_FALSE(needsStage(Scene{}, Purpose::Picture, Stage::TimeMarch));
  EXPECT_TRUE(needsStage(Scene{}, Purpose::Window, Stage::TimeMarch));
  EXPECT_THAT(reasonOf(Scene{}, Purpose::Curve, Stage::TimeMarch),
              HasSubstr("stationary in the line's frame"));
  Scene scene;
  scene.sliding.kind = SlidingKind::Oscillation;
  EXPECT_TRUE(needsStage(scene, Purpose::Picture, Stage::TimeMarch));
  EXPECT_FALSE(needsStage(scene, Purpose::Curve, Stage::TimeMarch));
}

TEST(Plan, TheWindowMovesThePictureAndDrawsTheCurve) {
  for (const SlidingKind kind : {SlidingKind::Steady, SlidingKind::Start, SlidingKind::Step}) {
    Scene scene;
    scene.sliding.kind = kind;
    for (std::size_t i = 0; i < kStages; ++i) {
      const auto stage = static_cast<Stage>(i);
      if (stage == Stage::TimeMarch) continue;
      EXPECT_EQ(
          needsStage(scene, Purpose::Window, stage),
          needsStage(scene, Purpose::Curve, stage) || needsStage(scene, Purpose::Picture, stage))
          << stageName(stage);
    }
    EXPECT_TRUE(needsStage(scene, Purpose::Window, Stage::Sweep));
    EXPECT_TRUE(needsStage(scene, Purpose::Window, Stage::Averaging));
    EXPECT_TRUE(needsStage(scene, Purpose::Window, Stage::Shape));
  }
}

TEST(Plan, EffectsOfNoStrengthAreLeftOut) {
  const Scene scene = readScene(
      R"({"elastomer":{"rheology":"prony","viscosity":0,"arms":[{"modulus":0,"relaxation_time":1}],
          "temperature":300,"shift":{"reference_temperature":300}},
          "surface":{"roll_off_wavelength":0,"summit_correlation":0},
          "interface":{"friction_coefficient":0}})",
      "s.json");
  for (const Stage stage : {Stage::RollOff, Stage::SummitCorrelation, Stage::TemperatureShift,
                            Stage::FreeSurface, Stage::Arms, Stage::Periodicity, Stage::Interface})
    EXPECT_FALSE(needsStage(scene, Purpose::Curve, stage)) << stageName(stage);
}

TEST(Plan, EffectsWithStrengthRun) {
  const Scene scene = readScene(
      R"({"elastomer":{"rheology":"prony","arms":[{"modulus":1e6,"relaxation_time":1}],
          "temperature":310},
          "surface":{"roll_off_wavelength":0.01,"summit_correlation":-0.5},
          "interface":{"shear_stress":10}})",
      "s.json");
  for (const Stage stage : {Stage::RollOff, Stage::SummitCorrelation, Stage::TemperatureShift,
                            Stage::FreeSurface, Stage::Arms, Stage::Periodicity, Stage::Interface})
    EXPECT_TRUE(needsStage(scene, Purpose::Curve, stage)) << stageName(stage);
  EXPECT_THAT(reasonOf(scene, Purpose::Curve, Stage::TemperatureShift), HasSubstr("at 310 K"));
  EXPECT_THAT(reasonOf(scene, Purpose::Curve, Stage::Arms), HasSubstr("1 internal variable an"));
}

TEST(Plan, RefusesWhatExcludesEachOther) {
  Scene scene;
  scene.interface = {0.1, 3};
  EXPECT_THROW(planStages(scene, Purpose::Curve), InputError);
}

}  // namespace
}  // namespace asperity
