// The guide over the friction of a motion: the exponential with the rate that each sample predicts.
#include "core/run/transient_diagram.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kRate = 900;  // 1/s

/// Friction that relaxes from the jump on exactly as predicted; level before it.
std::vector<TransientSample> relaxing(double jump, double duration) {
  std::vector<TransientSample> samples;
  for (int i = 0; i <= 400; ++i) {
    TransientSample sample;
    sample.time = duration * i / 400;
    sample.mu = sample.time > jump ? 0.5 + 0.3 * std::exp(-kRate * (sample.time - jump)) : 0.2;
    sample.predictedRate = kRate;
    samples.push_back(sample);
  }
  return samples;
}

Sliding motion(SlidingKind kind) {
  Sliding sliding;
  sliding.kind = kind;
  sliding.duration = 0.04;
  return sliding;
}

TEST(RelaxationGuide, LiesOnFrictionThatRelaxesAsPredicted) {
  for (const SlidingKind kind : {SlidingKind::Start, SlidingKind::Step, SlidingKind::Reversal}) {
    const double jump = kind == SlidingKind::Start ? 0 : 0.02;
    const auto samples = relaxing(jump, 0.04);
    const auto guide = relaxationGuide(motion(kind), samples);
    ASSERT_GE(guide.size(), 199U);
    EXPECT_GT(guide.front().x, jump);
    for (const DiagramPoint& point : guide) {
      const double mu = 0.5 + 0.3 * std::exp(-kRate * (point.x - jump));
      EXPECT_NEAR(point.y, mu, 1e-8 * mu + 0.3 * std::exp(-kRate * 0.02)) << point.x;
    }
  }
}

TEST(RelaxationGuide, IsNotThereBeforeAJumpNorWhereTheVelocityAlwaysChanges) {
  auto samples = relaxing(0.02, 0.04);
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Oscillation), samples).empty());
  samples.resize(150);
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Step), samples).empty());
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Start), {}).empty());
}

TEST(RelaxationGuide, IsNotThereAtRest) {
  auto samples = relaxing(0.02, 0.04);
  for (TransientSample& sample : samples)
    if (sample.time > 0.02) sample.mu = kNotApplicable;
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Step), samples).empty());
}

}  // namespace
}  // namespace asperity
