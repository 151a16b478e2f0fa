#include "core/run/played_motion.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace asperity {
namespace {

PlayedMotion someMotion() {
  Scene scene;
  scene.surface.elements = 200;
  scene.load.normalForce = 0.02;
  scene.sliding.velocity = 1;
  scene.sliding.kind = SlidingKind::Oscillation;
  scene.sliding.duration = 0.01;
  scene.sliding.frequency = 200;
  return PlayedMotion(Transient(scene, std::make_shared<RigidLine>(scene)));
}

std::vector<double> frictions(const PlayedMotion& motion) {
  std::vector<double> all;
  for (const TransientSample& sample : motion.samples()) all.push_back(sample.tangentialForce);
  return all;
}

TEST(PlayedMotion, HasAsManySamplesAtAnyPace) {
  PlayedMotion inOne = someMotion(), inSmall = someMotion();
  const double duration = inOne.motion().duration();
  inOne.marchTo(duration);
  for (int i = 1; i <= 50; ++i) inSmall.marchTo(duration * i / 50);
  ASSERT_TRUE(inOne.transient().isOver());
  EXPECT_EQ(inOne.samples().front().time, 0);
  EXPECT_GE(inOne.samples().size(), static_cast<std::size_t>(Transient::kLeastSteps));
  EXPECT_EQ(frictions(inSmall), frictions(inOne));
}

/// What follows a state that was kept is what followed it before.
TEST(PlayedMotion, GoesBackToAKeptState) {
  PlayedMotion motion = someMotion();
  const double duration = motion.motion().duration();
  for (int i = 1; i <= 50; ++i) {
    motion.marchTo(duration * i / 50);
    motion.keepState();
  }
  const std::vector<double> first = frictions(motion);
  ASSERT_TRUE(motion.goBackTo(duration / 2));
  EXPECT_LE(motion.transient().time(), duration / 2);
  EXPECT_GT(motion.transient().time(), duration / 4) << "none was kept near it";
  EXPECT_LT(motion.samples().size(), first.size());
  EXPECT_EQ(motion.samples().back().time, motion.transient().time());
  motion.marchTo(duration);
  EXPECT_EQ(frictions(motion), first);
  EXPECT_FALSE(motion.goBackTo(0)) << "the beginning is not kept";
}

}  // namespace
}  // namespace asperity
