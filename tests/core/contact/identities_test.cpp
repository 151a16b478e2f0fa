// What holds exactly in steady sliding, whatever the grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/surface/line.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

struct Case {
  double force, velocity;
};

constexpr Case kCases[] = {{1e-4, 1e-3},  {1e-4, 1},    {1e-4, 1e3},   {0.0034, 1e-4},
                           {0.0034, 0.1}, {0.0034, 10}, {0.0034, 1e3}, {1, 1e-2},
                           {1, 3},        {1, 1e3},     {100, 1},      {100, 1e3}};

template <class Check>
void forEachCase(Check check) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const std::int64_t oversampling : {1, 2, 5}) {
      const PreparedProfile line = prepareProfile(roughLine(400, oversampling), scheme);
      for (const Case& each : kCases) {
        SCOPED_TRACE(testing::Message()
                     << "scheme " << static_cast<int>(scheme) << " x" << oversampling << ", "
                     << each.force << " N, " << each.velocity << " m/s");
        const SlidingConditions conditions{kModulus, kTau, each.velocity};
        check(line, conditions, each.force, slideAtForce(line, conditions, each.force));
      }
    }
}

TEST(Identities, ForceBalanceIsMetToThirteenDigits) {
  forEachCase([](const PreparedProfile&, const SlidingConditions&, double force,
                 const SteadyResult& result) {
    EXPECT_EQ(result.status, SteadyStatus::Balanced);
    EXPECT_LE(result.residual, 1e-13);
    EXPECT_NEAR(result.normalForce / force, 1, 2e-13);
    EXPECT_LE(result.passes, 15);
  });
}

/// F_N = integral of p over contact = -4 G integral of u over all elements.
TEST(Identities, BothWaysToTheNormalForceAgree) {
  forEachCase([](const PreparedProfile& line, const SlidingConditions& conditions, double,
                 const SteadyResult& result) {
    const NodeShape shape = shapeAt(line, conditions, result.indentation);
    EXPECT_GE(*std::min_element(shape.pressure.begin(), shape.pressure.end()), 0);
    EXPECT_NEAR(result.forceFromDepth / result.normalForce, 1, 1e-9);
    EXPECT_NEAR(result.forceFromPressure / result.normalForce, 1, 1e-9);
  });
}

/// F_x v = 4 eta v^2 integral of u'^2 over all elements.
TEST(Identities, PowerInIsPowerDissipated) {
  forEachCase(
      [](const PreparedProfile&, const SlidingConditions&, double, const SteadyResult& result) {
        EXPECT_GT(result.powerDissipated, 0);
        EXPECT_NEAR(result.powerIn / result.powerDissipated, 1, 1e-9);
      });
}

TEST(Identities, TheElastomerNeverReachesThroughTheLine) {
  forEachCase([](const PreparedProfile& line, const SlidingConditions& conditions, double,
                 const SteadyResult& result) {
    const NodeShape shape = shapeAt(line, conditions, result.indentation);
    const double highest =
        *std::max_element(line.heightAboveMinimum.begin(), line.heightAboveMinimum.end());
    for (std::size_t i = 0; i < shape.depth.size(); ++i) {
      EXPECT_GE(shape.depth[i], 0);
      // u <= z - d
      EXPECT_GE(shape.depth[i] - (result.indentation - line.heightAboveMinimum[i]),
                -1e-15 * highest);
    }
  });
}

TEST(Identities, TheIndentationIsNeverBelowThatOfAFlatLine) {
  forEachCase([](const PreparedProfile& line, const SlidingConditions&, double force,
                 const SteadyResult& result) {
    EXPECT_GE(result.indentation * (1 + 1e-12), force / (4 * kModulus * line.length));
  });
}

TEST(Identities, ForceGrowsWithDepthAndIsConvex) {
  const PreparedProfile line = prepareProfile(roughLine(300, 2), Scheme::Cubic);
  for (const double v : {1e-3, 0.3, 100.0}) {
    double last = 0, lastSlope = 0;
    const double step = 2e-8;
    for (int i = 1; i < 100; ++i) {
      const double force = slideAtDepth(line, {kModulus, kTau, v}, i * step).normalForce;
      EXPECT_GT(force, last);
      EXPECT_GE((force - last) * (1 + 1e-10), lastSlope);
      lastSlope = force - last;
      last = force;
    }
  }
}

/// mu depends on F_N / G h L, v tau / L and the shape alone: scaling by powers of two changes no
/// bit.
TEST(Identities, ScalingByPowersOfTwoGivesTheSameBits) {
  const Line line = roughLine(300, 2);
  Line scaled = line;
  for (double& height : scaled.height) height *= 8;
  for (double& slope : scaled.slopeAfter) slope *= 8.0 / 4;
  scaled.length *= 4;
  scaled.spacing *= 4;
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
    for (const Case& each : kCases) {
      const SteadyResult one =
          slideAtForce(prepareProfile(line, scheme), {kModulus, kTau, each.velocity}, each.force);
      const SteadyResult two =
          slideAtForce(prepareProfile(scaled, scheme), {kModulus * 2, kTau * 16, each.velocity / 4},
                       each.force * 2 * 8 * 4);
      EXPECT_EQ(one.mu * 2, two.mu);
      EXPECT_EQ(one.contactFraction, two.contactFraction);
    }
}

TEST(Identities, AFlatLineIsPressedEvenlyWithoutFriction) {
  Line flat = roughLine(50);
  for (double& height : flat.height) height = 0;
  for (double& slope : flat.slopeAfter) slope = 0;
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const SteadyResult result =
        slideAtForce(prepareProfile(flat, scheme), {kModulus, kTau, 1}, 0.0034);
    EXPECT_EQ(result.status, SteadyStatus::Balanced);
    EXPECT_EQ(result.mu, 0);
    EXPECT_EQ(result.contactFraction, 1);
    EXPECT_NEAR(result.indentation, 0.0034 / (4 * kModulus * flat.length), 1e-20);
  }
}

TEST(Identities, AtRestThereIsNoFrictionAndTheForceIsThatOfSprings) {
  const PreparedProfile line = prepareProfile(roughLine(400, 4), Scheme::Cubic);
  const SteadyResult result = slideAtForce(line, {kModulus, kTau, 0}, 0.01);
  EXPECT_EQ(result.status, SteadyStatus::Balanced);
  EXPECT_LT(std::abs(result.mu), 1e-14);
  const SteadyResult elastic = slideAtForce(line, {kModulus, 0, 5}, 0.01);
  EXPECT_EQ(elastic.indentation, result.indentation);
}

}  // namespace
}  // namespace asperity
