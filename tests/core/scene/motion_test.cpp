#include "core/scene/motion.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

Sliding motionOf(SlidingKind kind) {
  Sliding sliding;
  sliding.kind = kind;
  sliding.velocity = 0.3;
  sliding.velocityAfter = -2;
  sliding.amplitude = 0.7;
  sliding.frequency = 25;
  sliding.duration = 0.1;
  return sliding;
}

/// The way is the integral of the velocity, for every motion.
TEST(Motion, DistanceIsTheIntegralOfTheVelocity) {
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    const Motion motion(motionOf(kind));
    constexpr int kSteps = 24000;  // the jump lies between two
    const double dt = 0.12 / kSteps;
    double way = 0;
    for (int i = 0; i < kSteps; ++i) {
      way += motion.velocityAt((i + 0.5) * dt) * dt;
      if (i % 1000 == 999) {
        EXPECT_NEAR(motion.distanceAt((i + 1) * dt), way, 1e-6);
      }
    }
    EXPECT_EQ(motion.distanceAt(0), 0);
  }
}

TEST(Motion, JumpsAtHalfOfItsDuration) {
  const Motion step(motionOf(SlidingKind::Step)), reversal(motionOf(SlidingKind::Reversal));
  EXPECT_EQ(step.jump(), 0.05);
  EXPECT_EQ(step.velocityAt(0.0499), 0.3);
  EXPECT_EQ(step.velocityAt(0.05), -2);
  EXPECT_EQ(reversal.velocityAt(0.06), -0.3);
  EXPECT_EQ(reversal.distanceAt(0.1), 0);
  EXPECT_EQ(step.fastest(0, 0.05), 0.3);
  EXPECT_EQ(step.fastest(0, 0.06), 2);
  const Motion oscillation(motionOf(SlidingKind::Oscillation));
  EXPECT_EQ(oscillation.fastest(0, 1), 1.0);
  EXPECT_NEAR(oscillation.velocityAt(0.01), 1, 1e-15);
  EXPECT_NEAR(oscillation.distanceAt(0.04), 0.3 * 0.04, 1e-15);
}

TEST(Motion, StepsShowItsDurationAndEachPeriod) {
  Sliding sliding = motionOf(SlidingKind::Step);
  EXPECT_EQ(Motion(sliding).longestStep(), 0.1 / 500);
  EXPECT_EQ(Motion(sliding).longestStep(100), 0.1 / 100);
  sliding = motionOf(SlidingKind::Oscillation);
  EXPECT_EQ(Motion(sliding).longestStep(), 0.1 / 500);
  sliding.frequency = 1000;
  EXPECT_EQ(Motion(sliding).longestStep(), 1.0 / 64000);
}

TEST(Motion, AnOscillationStandsStillWhereItTurns) {
  Sliding sliding;
  sliding.kind = SlidingKind::Oscillation;
  sliding.velocity = 0;
  sliding.amplitude = 0.3;
  sliding.frequency = 100;
  const Motion motion(sliding);
  for (int half = 0; half <= 8; ++half) EXPECT_EQ(motion.velocityAt(0.005 * half), 0) << half;
  EXPECT_NEAR(motion.velocityAt(0.0025), 0.3, 1e-12);
}

}  // namespace
}  // namespace asperity
