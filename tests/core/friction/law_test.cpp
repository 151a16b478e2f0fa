// Eqs. (5) to (14) of Li et al. (2013), each against what it says.
#include "core/friction/law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

LawInput paperInput() {
  return {1e7, 1e-3, 0.02, 5e-7, 1.8e-3, 0.7, 0.0034, 1e-3};
}

TEST(Law, Equation5IsLinearInVelocityAndAPowerOfForce) {
  LawInput in = paperInput(), faster = in, heavier = in;
  faster.velocity *= 3;
  heavier.normalForce *= 10;
  const double alpha = 0.4, beta = 1.7;
  EXPECT_NEAR(lowVelocityFriction(faster, alpha, beta) / lowVelocityFriction(in, alpha, beta), 3,
              1e-12);
  EXPECT_NEAR(lowVelocityFriction(heavier, alpha, beta) / lowVelocityFriction(in, alpha, beta),
              std::pow(10, -alpha), 1e-12);
  in.normalForce = in.shearModulus * in.rmsHeight * in.length;  // Fbar = 1
  EXPECT_NEAR(lowVelocityFriction(in, alpha, beta), beta * 1e-3 * 1e-3 * 1.8e-3 * 1.8e-3 / 5e-7,
              1e-18);
}

/// Eq. (6) is exact as v -> 0 with the contact's own length and slope.
TEST(Law, Equation6IsExactAtLowVelocity) {
  const PreparedProfile line = prepareProfile(roughLine(500, 4), Scheme::Cubic);
  const double v = 1e-9;
  const SteadyResult result = slideAtForce(line, {kModulus, kTau, v}, 0.01);
  LawInput in{kModulus, kTau, line.length, line.rmsHeight, line.rmsSlope, 0.7, 0.01, v};
  EXPECT_NEAR(
      contactFriction(in, result.contactFraction * line.length, result.rmsSlopeContact) / result.mu,
      1, 1e-5);
}

TEST(Law, Equation7) {
  EXPECT_EQ(forceExponent(0), 0);
  EXPECT_DOUBLE_EQ(forceExponent(1), 0.5);
}

TEST(Law, Equation8IsEquation6OfTheWholeLine) {
  const LawInput in = paperInput();
  EXPECT_EQ(fullContactFriction(in), contactFriction(in, in.length, in.rmsSlope));
}

TEST(Law, Equation11HasTheThreeRegionsAsLimits) {
  LawInput in = paperInput();
  in.velocity = 1e-12;
  EXPECT_NEAR(
      frictionLaw(in, 1.66) /
          std::hypot(0, 1 / std::hypot(1 / fullContactFriction(in),
                                       1 / lowVelocityFriction(in, forceExponent(0.7), 1.66))),
      1, 1e-12);
  in.velocity = 1e12;
  EXPECT_NEAR(frictionLaw(in, 1.66) / plateauFriction(in.rmsSlope), 1, 1e-12);
  in = paperInput();
  in.normalForce = 1e8;
  EXPECT_NEAR(frictionLaw(in, 1.66) / fullContactFriction(in), 1, 1e-6);
}

/// Eq. (12) is Eq. (11) divided by Eq. (9), with beta = 1.
TEST(Law, Equation12IsEquation11WithBetaOne) {
  for (const double velocity : {1e-5, 1e-3, 1e-1, 10.0})
    for (const double force : {1e-3, 0.1, 10.0}) {
      LawInput in = paperInput();
      in.velocity = velocity;
      in.normalForce = force;
      const double scaledForce = dimensionlessForce(in);
      const double resistance =
          std::pow(scaledForce / 4, 2) + std::pow(scaledForce, 2 * forceExponent(0.7));
      const double equation12 =
          1 / std::sqrt(1 + resistance / std::pow(dimensionlessVelocity(in), 2));
      EXPECT_NEAR(frictionLaw(in, 1) / plateauFriction(in.rmsSlope) / equation12, 1, 1e-12);
    }
}

TEST(Law, Equations13And14) {
  const LawInput in = paperInput();
  EXPECT_DOUBLE_EQ(dimensionlessVelocity(in), 1e-3 * 1e-3 * 1.8e-3 / (std::sqrt(2) * 5e-7));
  EXPECT_DOUBLE_EQ(dimensionlessForce(in), 0.0034 / (1e7 * 5e-7 * 0.02));
}

TEST(Law, BetaIsInterpolatedAndFallsWithH) {
  EXPECT_NEAR(lawPrefactor(0.65), 0.5 * (lawPrefactor(0.6) + lawPrefactor(0.7)), 1e-12);
  EXPECT_DOUBLE_EQ(lawPrefactor(-1), lawPrefactor(0));
  EXPECT_DOUBLE_EQ(lawPrefactor(2), lawPrefactor(1));
  for (double hurst = 0; hurst < 1; hurst += 0.01)
    EXPECT_GE(lawPrefactor(hurst), lawPrefactor(hurst + 0.01));
}

TEST(Law, AtRestThereIsNoFriction) {
  LawInput in = paperInput();
  in.velocity = 0;
  EXPECT_EQ(frictionLaw(in), 0);
}

}  // namespace
}  // namespace asperity
