#include "core/run/transient.h"

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
  EXPECT_GE(inOne.samples().size(), static_cast<std::size_t>(Transient::kMinSteps));
  EXPECT_EQ(frictions(inSmall), frictions(inOne));
}

std::vector<double> times(const std::vector<TransientSample>& samples) {
  std::vector<double> all;
  for (const TransientSample& sample : samples) all.push_back(sample.time);
  return all;
}

/// Plays so many of fifty parts of the motion.
void play(PlayedMotion& motion, int parts) {
  for (int i = 1; i <= parts; ++i) {
    motion.marchTo(motion.motion().duration() * i / 50);
    motion.keepState();
  }
}

/// What follows a state that was kept is what followed it before.
TEST(PlayedMotion, GoesBackToAKeptState) {
  PlayedMotion motion = someMotion();
  const Transient beginning = motion.transient();
  const double duration = motion.motion().duration();
  play(motion, 50);
  const std::vector<double> first = frictions(motion);
  ASSERT_TRUE(motion.goTo(duration / 2, beginning));
  EXPECT_LE(motion.transient().time(), duration / 2);
  EXPECT_GT(motion.transient().time(), duration / 4) << "none was kept near it";
  EXPECT_LT(motion.samples().size(), first.size());
  EXPECT_EQ(motion.samples().back().time, motion.transient().time());
  motion.marchTo(duration);
  EXPECT_EQ(frictions(motion), first);
  EXPECT_TRUE(motion.goTo(0, beginning));
  EXPECT_EQ(motion.transient().steps(), 0U);
  motion.marchTo(duration);
  EXPECT_EQ(frictions(motion), first);
}

/// A user looks at an earlier moment and comes back.
TEST(PlayedMotion, GoingBackLosesNoSamples) {
  PlayedMotion motion = someMotion();
  const Transient beginning = motion.transient();
  const double duration = motion.motion().duration();
  play(motion, 40);
  EXPECT_TRUE(motion.later().empty());
  const std::vector<double> all = times(motion.samples());
  const std::uint64_t steps = motion.transient().steps();
  for (const double part : {0.5, 0.1, 0.0, 0.3, 0.79}) {
    motion.goTo(part * duration, beginning);
    std::vector<double> known = times(motion.samples());
    const std::vector<double> later = times(motion.later());
    EXPECT_TRUE(known.empty() || known.back() == motion.transient().time()) << part;
    known.insert(known.end(), later.begin(), later.end());
    EXPECT_EQ(known, all) << part;
  }
  EXPECT_GT(motion.transient().steps(), steps / 2) << "states after the present one are kept, too";
  motion.marchTo(0.8 * duration);
  EXPECT_TRUE(motion.later().empty());
  EXPECT_EQ(times(motion.samples()), all);
  EXPECT_EQ(motion.transient().steps(), steps);
  EXPECT_FALSE(motion.goTo(duration, beginning)) << "nothing is known after it";
}

}  // namespace
}  // namespace asperity
