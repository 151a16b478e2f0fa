// The paper's own algorithm: what it must give, and where it is known to differ.
#include "core/paper/literal_march.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

constexpr double kForce = 0.0034;  // N, of Fig. 2

/// Sliding by one spacing per step is steady after one period: the nodal pass in one go.
TEST(LiteralMarch, AgreesWithTheNodalPassAtLowVelocity) {
  for (int realization = 0; realization < 3; ++realization) {
    const Line line = roughLine(1000, 1, 0.7, realization);
    const PreparedProfile profile = prepareProfile(line, Scheme::Nodal);
    for (const double velocity : {1e-4, 1e-3, 1e-2}) {
      const SlidingConditions conditions{kModulus, kTau, velocity};
      const LiteralResult literal = literalMarch(line, conditions, kForce);
      const SteadyResult steady = slideAtForce(profile, conditions, kForce);
      EXPECT_NEAR(literal.mu / steady.mu, 1, 0.03) << velocity;
      EXPECT_NEAR(literal.contactFraction, steady.contactFraction, 2e-3);
      EXPECT_NEAR(literal.indentation / steady.indentation, 1, 1e-2);
    }
  }
}

TEST(LiteralMarch, FullContactIsEquation8) {
  const Line line = roughLine(500);
  for (const double velocity : {1e-3, 1e-2, 1e-1}) {
    const double force = 100;
    const LiteralResult result = literalMarch(line, {kModulus, kTau, velocity}, force);
    const double expected =
        4 * line.length * kModulus * kTau * line.rmsSlope * line.rmsSlope * velocity / force;
    EXPECT_NEAR(result.contactFraction, 1, 1e-12);
    EXPECT_NEAR(result.mu / expected, 1, 1e-9);
  }
}

TEST(LiteralMarch, MeetsTheForceUnlessItFallsIntoAJump) {
  const Line line = roughLine(500);
  for (const double force : {1e-3, 1e-1, 10.0})
    for (const double velocity : {1e-3, 1e-1, 10.0, 1000.0}) {
      const LiteralResult result = literalMarch(line, {kModulus, kTau, velocity}, force);
      EXPECT_LT(result.largestResidual, 1e-12);
      EXPECT_GE(result.normalForce / force, 1 - 1e-12);
      if (result.jumpFraction == 0) {
        EXPECT_NEAR(result.normalForce / force, 1, 1e-12);
      }
    }
}

/// Region IV: once the last contact is one node, friction is that node's slope at any velocity; the
/// resolved line goes on falling as v^(-1/2).
TEST(LiteralMarch, LevelsOffWhereTheResolvedLineFalls) {
  double literal[2] = {}, resolved[2] = {};
  const double velocities[2] = {100, 1000};
  for (int realization = 0; realization < 8; ++realization) {
    const Line line = roughLine(500, 1, 0.7, realization);
    const PreparedProfile profile =
        prepareProfile(roughLine(500, 4, 0.7, realization), Scheme::Cubic);
    for (int i = 0; i < 2; ++i) {
      const SlidingConditions conditions{kModulus, kTau, velocities[i]};
      literal[i] += literalMarch(line, conditions, kForce).mu / line.rmsSlope / 8;
      resolved[i] += slideAtForce(profile, conditions, kForce).mu / line.rmsSlope / 8;
    }
  }
  EXPECT_NEAR(literal[1] / literal[0], 1, 0.02);
  EXPECT_GT(literal[1], 0.4);
  EXPECT_LT(literal[1], 1.2);
  EXPECT_NEAR(resolved[1] / resolved[0], 1 / std::sqrt(10), 0.1);
}

TEST(LiteralMarch, IsDeterministic) {
  const Line line = roughLine(300);
  const SlidingConditions conditions{kModulus, kTau, 0.3};
  const LiteralResult once = literalMarch(line, conditions, kForce);
  const LiteralResult again = literalMarch(line, conditions, kForce);
  EXPECT_EQ(once.mu, again.mu);
  EXPECT_EQ(once.indentation, again.indentation);
  EXPECT_EQ(once.steps, 300);
}

TEST(LiteralMarch, VectorsChangeOnlyTheLastDigits) {
  const Line line = roughLine(500);
  for (const double velocity : {1e-3, 1.0, 100.0}) {
    const SlidingConditions conditions{kModulus, kTau, velocity};
    const LiteralResult plain = literalMarch(line, conditions, kForce);
    for (const LiteralVectors vectors : {LiteralVectors::Avx2, LiteralVectors::Avx512}) {
      const LiteralResult wide = literalMarch(line, conditions, kForce, {.vectors = vectors});
      EXPECT_NEAR(wide.mu / plain.mu, 1, 1e-9) << velocity;
    }
  }
}

/// From the steady shape it goes on as it would have at the end of a period, at one sweep a step.
TEST(LiteralMarch, StartsFromTheSteadyShape) {
  const Line line = roughLine(1000);
  const PreparedProfile profile = prepareProfile(line, Scheme::Nodal);
  const SlidingConditions conditions{kModulus, kTau, 0.01};
  const SteadyResult steady = slideAtForce(profile, conditions, kForce);
  std::vector<double> depth =
      inLineOrder(profile, shapeAt(profile, conditions, steady.indentation).depth);
  std::rotate(depth.begin(), depth.begin() + 1, depth.end());  // one step before
  const LiteralResult result =
      literalMarch(line, conditions, kForce,
                   {.steps = 10, .startDepth = depth, .startIndentation = steady.indentation});
  EXPECT_NEAR(result.mu / steady.mu, 1, 1e-9);
  EXPECT_NEAR(result.sweepsPerStep, 1, 0.3);
}

TEST(LiteralMarch, DoesFewerStepsOnRequest) {
  const Line line = roughLine(300);
  const LiteralResult result = literalMarch(line, {kModulus, kTau, 0.1}, kForce, {.steps = 20});
  EXPECT_EQ(result.steps, 20);
  EXPECT_GE(result.sweepsPerStep, 1);
  EXPECT_TRUE(std::isfinite(result.mu));
}

}  // namespace
}  // namespace asperity
