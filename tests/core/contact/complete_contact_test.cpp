// Complete contact: its limit, and that leaving the search out changes nothing (Eqs. 3 and 8).
#include "core/contact/force_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/contact/kernels/pass.h"
#include "core/contact/steady_solver.h"
#include "core/contact/steady_sweep.h"
#include "core/scene/plan.h"
#include "core/surface/line.h"
#include "tests/core/contact/lines.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

std::uint64_t searches() {
  return stageCounts()[static_cast<std::size_t>(Stage::ContactSearch)];
}

template <class Check>
void forEachLine(const Check& check) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const std::int64_t elements : {3, 16, 47, 500}) {
      SCOPED_TRACE(testing::Message() << elements << ", scheme " << static_cast<int>(scheme));
      check(prepareProfile(roughLine(elements, 2), scheme));
    }
}

/// A sine: d = A + A sqrt(1 + (q c)^2) above its lowest point.
TEST(CompleteContact, BeginsForASineWhereTheClosedFormSays) {
  const double amplitude = 5e-7, q = 2 * std::numbers::pi * 4 / 0.01;
  const PreparedProfile line = prepareProfile(sineLine(0.01, 4000, amplitude, 4), Scheme::Cubic);
  for (const double turn : {0.0, 0.1, 1.0, 10.0}) {
    const double exact = amplitude * (1 + std::sqrt(1 + turn * turn));
    EXPECT_LT(relativeError(completeAbove(line, turn / q), exact), 1e-8);
  }
}

TEST(CompleteContact, IsToldToTheLastDigit) {
  forEachLine([](const PreparedProfile& line) {
    for (const double relaxationLength : {0.0, 1e-7, 1e-5, 1e-3, 1.0}) {
      const double above = completeAbove(line, relaxationLength);
      EXPECT_TRUE(isContactComplete(line, above * (1 + 1e-15), relaxationLength));
      EXPECT_FALSE(isContactComplete(line, above * (1 - 1e-15), relaxationLength));
      // The pass itself, which looks for edges, agrees.
      EXPECT_LT(
          relativeError(resolvedPass(line, above * (1 + 1e-12), relaxationLength).contactLength,
                        line.length),
          1e-13);  // a sum of a thousand lengths
      EXPECT_LT(resolvedPass(line, above * (1 - 1e-6), relaxationLength).contactLength,
                line.length * (1 - 1e-12));
    }
  });
}

TEST(CompleteContact, WithoutASearchTheSameAsWithOne) {
  forEachLine([](const PreparedProfile& line) {
    for (const double relaxationLength : {1e-7, 1e-5, 1e-3}) {
      const double depth = 1.001 * completeAbove(line, relaxationLength),
                   load = (depth - line.meanHeight) * line.length;
      const Balance balance = balanceResolved(line, relaxationLength, load);
      const PassSums sought = resolvedPass(line, balance.depth, relaxationLength);
      const double wanted = sought.dissipation / sought.depth, velocity = relaxationLength / kTau;
      const std::uint64_t before = searches();
      const SteadyResult plain =
          slideAtForce(line, {kModulus, kTau, velocity}, 4 * kModulus * load);
      SteadyResult swept[1], atDepth[1];
      const double velocities[] = {velocity};
      slideSweep(line, {kModulus, kTau, 0}, {LoadKind::Force, 4 * kModulus * load, 0}, velocities,
                 swept);
      slideSweep(line, {kModulus, kTau, 0}, {LoadKind::Indentation, 0, balance.depth}, velocities,
                 atDepth);
      EXPECT_EQ(searches(), before);
      for (const SteadyResult& result : {plain, swept[0], atDepth[0]}) {
        EXPECT_EQ(result.status, SteadyStatus::Balanced);
        EXPECT_LT(relativeError(result.mu, wanted), 1e-12);
        EXPECT_LT(relativeError(result.indentation, balance.depth), 1e-12);
        EXPECT_LT(relativeError(result.normalForce, 4 * kModulus * load), 1e-12);
        EXPECT_LT(relativeError(result.forceFromPressure, result.forceFromDepth), 1e-12);
        EXPECT_LT(
            relativeError(result.rmsSlopeContact, std::sqrt(sought.slopeSquared / line.length)),
            1e-12);
        EXPECT_LT(relativeError(result.contactFraction, 1), 1e-13);
      }
      slideAtForce(line, {kModulus, kTau, velocity}, 3.9 * kModulus * load);
      EXPECT_GT(searches(), before);
    }
  });
}

/// With arms: no search where all is in contact, and across the limit friction is continuous.
TEST(CompleteContact, OfElementsWithArmsNeedsNoSearch) {
  for (const auto& [name, elastomer] : allElastomers()) {
    if (name == "elastic" || name == "kelvin") continue;
    for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
      for (const double velocity : {1e-4, 0.03, 1.0}) {
        SCOPED_TRACE(testing::Message() << name << " at " << velocity);
        const PreparedProfile line = prepareProfile(roughLine(200, 2), scheme);
        Scene scene;
        scene.elastomer = elastomer;
        scene.accuracy.scheme = scheme;
        const SteadySolver sliding(scene);
        const double above = sliding.completeAbove(line, velocity);
        const auto at = [&](double depth) {
          scene.load = {LoadKind::Indentation, 0, depth};
          return SteadySolver(scene).at(line, velocity).result;
        };
        const std::uint64_t before = searches();
        const SteadyResult complete = at(above * (1 + 1e-8));
        EXPECT_EQ(searches(), before);
        EXPECT_LT(relativeError(complete.contactFraction, 1), 1e-13);
        EXPECT_LE(complete.passes, 3);
        EXPECT_LT(relativeError(complete.powerIn, complete.powerDissipated), 1e-10);
        const SteadyResult sought = at(above * (1 - 1e-8));
        EXPECT_EQ(searches(), before + 1);
        EXPECT_LT(relativeError(sought.tangentialForce, complete.tangentialForce), 1e-6);
        EXPECT_LT(relativeError(sought.normalForce, complete.normalForce), 1e-6);
        // At that force the depth is the same.
        scene.load = {LoadKind::Force, complete.normalForce, 0};
        const SteadyResult pressed = SteadySolver(scene).at(line, velocity).result;
        EXPECT_LT(relativeError(pressed.indentation, complete.indentation), 1e-12);
        EXPECT_LT(relativeError(pressed.tangentialForce, complete.tangentialForce), 1e-12);
      }
  }
}

/// Also where a sum over all segments is off in its last digits.
TEST(CompleteContact, IsTheWholeLine) {
  const PreparedProfile line = prepareProfile(roughLine(100000, 3), Scheme::Linear);
  const SteadyResult deep = slideAtDepth(line, {1e7, 1e-3, 1}, 1);
  EXPECT_EQ(deep.contactFraction, 1);
  EXPECT_EQ(slideAtForce(line, {1e7, 1e-3, 1}, deep.normalForce).contactFraction, 1);
}

}  // namespace
}  // namespace asperity
