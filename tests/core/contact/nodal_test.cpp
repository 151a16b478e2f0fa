// The paper's N separate elements: Eq. (2), its jumps, and its known shortcomings.
#include "core/contact/kernels/kernels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

TEST(Nodal, ForceIsMetExactlyEvenInAJump) {
  int jumps = 0;
  for (int realization = 0; realization < 10; ++realization) {
    const PreparedProfile line =
        prepareProfile(roughLine(1000, 1, 0.7, realization), Scheme::Nodal);
    for (const double velocity : {1e-5, 1e-2, 0.1, 1.0, 10.0, 1000.0}) {
      const SteadyResult result = slideAtForce(line, {kModulus, kTau, velocity}, 0.0034);
      EXPECT_EQ(result.status, SteadyStatus::Balanced);
      EXPECT_NEAR(result.normalForce / 0.0034, 1, 1e-10);
      EXPECT_GT(result.marginalShare, 0);
      EXPECT_LE(result.marginalShare, 1);
      jumps += result.marginalShare < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(jumps, 10);
}

TEST(Nodal, ForceNeverFallsWithDepth) {
  const PreparedProfile line = prepareProfile(roughLine(200), Scheme::Nodal);
  for (const double c : {1e-6, 1e-3, 1.0}) {
    double last = 0;
    for (int i = 0; i < 2000; ++i) {
      const double force = nodalPass(line, i * 1e-9, c).sums.pressure;
      EXPECT_GE(force, last * (1 - 1e-14));
      last = force;
    }
  }
}

/// Just below its threshold the topmost loaded element is not loaded any more.
TEST(Nodal, TheThresholdIsWhereAnElementIsLost) {
  const PreparedProfile line = prepareProfile(roughLine(200), Scheme::Nodal);
  for (const double c : {1e-6, 1e-4, 1e-2})
    for (const double depth : {1e-8, 1e-7, 1e-6}) {
      const NodalState state = nodalPass(line, depth, c);
      const double edge = state.threshold;
      ASSERT_LE(edge, depth);
      const double above = nodalPass(line, edge * (1 + 1e-12), c).sums.stiffness;
      const double lower = edge > 0 ? edge * (1 - 1e-12) : -1e-300;
      const double below = nodalPass(line, lower, c).sums.stiffness;
      EXPECT_NEAR(above, state.sums.stiffness, 0.5 * line.spacing);
      EXPECT_LT(below, above);
    }
}

/// The table of the design: mu / grad of the nodal rule at F_N = 0.0034 N, N = 5000, H = 0.7. The
/// rule is close to the resolved line while many elements touch.
TEST(Nodal, AgreesWithTheResolvedLineAtLowVelocity) {
  double nodal = 0, cubic = 0;
  for (int realization = 0; realization < 10; ++realization) {
    const SlidingConditions slow{kModulus, kTau, 1e-2};
    nodal += slideAtForce(prepareProfile(roughLine(5000, 1, 0.7, realization), Scheme::Nodal), slow,
                          0.0034)
                 .mu;
    cubic += slideAtForce(prepareProfile(roughLine(5000, 4, 0.7, realization), Scheme::Cubic), slow,
                          0.0034)
                 .mu;
  }
  EXPECT_NEAR(nodal / cubic, 1, 0.02);
}

/// It does not conserve power, and says so: in region IV more goes in than is dissipated, or less.
TEST(Nodal, ReportsItsPowerImbalance) {
  const PreparedProfile line = prepareProfile(roughLine(500), Scheme::Nodal);
  const SteadyResult result = slideAtForce(line, {kModulus, kTau, 0.01}, 0.01);
  EXPECT_GT(std::abs(result.powerIn / result.powerDissipated - 1), 1e-3);
}

}  // namespace
}  // namespace asperity
