// A balance that is not met, in words.
#include "core/contact/steady_sliding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/contact/steady_sweep.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

TEST(UnmetBalance, SaysWhereAndByHowMuch) {
  SteadyResult result;
  EXPECT_NO_THROW(requireBalance(result, 0.5));
  result.status = SteadyStatus::NotBalanced;
  result.residual = 0.03;
  EXPECT_STREQ(balanceError(result, 0.5).what(),
               "the force balance is not met at velocity 0.5 m/s: relative residual 0.03");
  try {
    requireBalance(result, 0.5, "on realization 3");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the force balance is not met at velocity 0.5 m/s on realization 3: relative "
                 "residual 0.03");
  }
}

/// The balance is met, but the two ways to the force differ.
TEST(UnmetBalance, TellsWhenDigitsRanOut) {
  SteadyResult result{.status = SteadyStatus::NotBalanced, .residual = 0};
  EXPECT_STREQ(
      balanceError(result, 2).what(),
      "contact is too short, or the moduli differ too much, for double precision, at velocity 2 "
      "m/s");
}

/// 1e-10 is what README promises of every force balance.
TEST(UnmetBalance, AResidualBeyondOnePartInTenBillionIsUnmet) {
  SteadyResult result;
  result.forceFromDepth = result.forceFromPressure = 1;
  for (const double residual : {0.0, 1e-13, 9e-11}) {
    result.residual = residual;
    EXPECT_EQ(balanceStatus(result), SteadyStatus::Balanced) << residual;
    EXPECT_TRUE((Balance{1, 1, residual}.isMet())) << residual;
  }
  for (const double residual : {1.1e-10, 1e-9, 1e-3, 1.0, 1e300}) {
    result.residual = residual;
    EXPECT_EQ(balanceStatus(result), SteadyStatus::NotBalanced) << residual;
    EXPECT_FALSE((Balance{1, 1, residual}.isMet())) << residual;
  }
}

/// The forces from depth and from pressure, each by a sum of its own.
TEST(UnmetBalance, ForcesThatDisagreeAreUnmet) {
  SteadyResult result;
  result.forceFromDepth = 2;
  for (const double apart : {0.0, 0.9e-4, -0.9e-4}) {
    result.forceFromPressure = 2 * (1 + apart);
    EXPECT_EQ(balanceStatus(result), SteadyStatus::Balanced) << apart;
  }
  for (const double apart : {1.1e-4, -1.1e-4, 0.5, -2.0}) {
    result.forceFromPressure = 2 * (1 + apart);
    EXPECT_EQ(balanceStatus(result), SteadyStatus::NotBalanced) << apart;
  }
}

TEST(UnmetBalance, TheElementsOneByOneHaveTheSameLimit) {
  const PreparedProfile line = prepareProfile(roughLine(200), Scheme::Nodal);
  NodalBalance nodal;
  nodal.sums = nodalPass(line, 1e-6, kTau).sums;
  nodal.balance = {1e-6, 3, 1.1e-10};
  EXPECT_EQ(steadyResult(line, SlidingConditions{kModulus, kTau, 1}, nodal).status,
            SteadyStatus::NotBalanced);
  nodal.balance.residual = 9e-11;
  EXPECT_EQ(steadyResult(line, SlidingConditions{kModulus, kTau, 1}, nodal).status,
            SteadyStatus::Balanced);
}

/// Down to loads for which numbers have too few digits: the plain path and the lanes of a sweep say
/// of each result what its residual and its forces call for.
TEST(UnmetBalance, EveryPathLooksAtResidualAndForces) {
  int unmet = 0;
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(200, 2), scheme);
    for (double force = 1e-2; force > 1e-90; force *= 1e-4) {
      const std::vector<double> velocities{1e-3, 1, 1e3};
      std::vector<SteadyResult> results(velocities.size());
      ASSERT_TRUE(
          slideSweep(line, {kModulus, kTau, 0}, {LoadKind::Force, force, 0}, velocities, results));
      for (const double velocity : velocities)
        results.push_back(slideAtForce(line, {kModulus, kTau, velocity}, force));
      for (const SteadyResult& result : results) {
        const double apart = std::abs(result.forceFromPressure / result.forceFromDepth - 1);
        const bool isBalanced = result.residual <= 1e-10 && apart <= 1e-4;
        EXPECT_EQ(result.status == SteadyStatus::Balanced, isBalanced) << force;
        unmet += isBalanced ? 0 : 1;
      }
    }
  }
  EXPECT_GT(unmet, 0);
}

/// At forces as small as these, an elastic contact ends nearly at its deepest point, and what
/// rounding leaves there is no friction.
TEST(ElasticElements, HaveNoFrictionAtAll) {
  const std::vector<double> velocities{1e-3, 1, 1e3};
  std::vector<SteadyResult> results(velocities.size());
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    for (std::int64_t realization = 0; realization < 8; ++realization) {
      const PreparedProfile line = prepareProfile(roughLine(300, 1, 0.7, realization), scheme);
      for (const double force : {1e-6, 1.0, 1e12}) {
        slideSweep(line, {kModulus, 0, 0}, {LoadKind::Force, force, 0}, velocities, results);
        results.push_back(slideAtForce(line, {kModulus, 0, 1}, force));
        for (const SteadyResult& result : results) {
          EXPECT_EQ(result.mu, 0) << force;
          EXPECT_EQ(result.tangentialForce, 0) << force;
          EXPECT_EQ(result.powerDissipated, 0) << force;
        }
        results.pop_back();
      }
    }
  }
}

}  // namespace
}  // namespace asperity
