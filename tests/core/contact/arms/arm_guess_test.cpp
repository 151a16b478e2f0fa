// Where searches along velocities begin.
#include "core/contact/arms/arm_guess.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/elastomers.h"

namespace asperity {
namespace {

/// A balance of strains that are this function of v tau, at a depth of v^(-1/10).
template <class Function>
ArmBalance balanceAt(const ElementLaw& law, double velocity, const Function& strain) {
  ArmBalance balance;
  balance.force.depth = 1e-7 * std::pow(velocity, -0.1);
  for (const Arm& arm : law.arms) balance.strain.push_back(strain(velocity * arm.relaxationTime));
  return balance;
}

TEST(ArmGuess, KnowsNothingAtFirstNorAfterAFailure) {
  const ElementLaw law = elementLaw(treadCompound());
  ArmGuess guess(law);
  EXPECT_EQ(guess.at(1), nullptr);
  guess.take(1, balanceAt(law, 1, [](double c) { return c; }));
  EXPECT_NE(guess.at(2), nullptr);
  ArmBalance failed = balanceAt(law, 2, [](double c) { return c; });
  failed.force.residual = 1;
  guess.take(2, failed);
  EXPECT_EQ(guess.at(3), nullptr);
}

/// A shape that does not change gives strains of v tau alone: a cubic in its logarithm is met
/// exactly between the arms, and the depth's power of the velocity everywhere.
TEST(ArmGuess, LooksStrainsUpByTheRelaxationLength) {
  const ElementLaw law = elementLaw(treadCompound());
  const auto cubic = [](double c) {
    const double x = std::log10(c);
    return 1e-8 * (20 + x * (1 + x * (0.1 - 0.01 * x)));
  };
  ArmGuess guess(law);
  guess.take(1, balanceAt(law, 1, cubic));
  guess.take(2, balanceAt(law, 2, cubic));
  const ArmBalance* found = guess.at(4);
  ASSERT_NE(found, nullptr);
  EXPECT_NEAR(found->force.depth, 1e-7 * std::pow(4, -0.1), 1e-20);
  for (std::size_t i = 1; i < law.arms.size(); ++i)
    EXPECT_NEAR(found->strain[i], cubic(4 * law.arms[i].relaxationTime), 1e-18) << i;
}

/// Where strains change with the velocity as well, they go on as they went.
TEST(ArmGuess, GoesOnAsFromTheVelocityBefore) {
  const ElementLaw law = elementLaw(treadCompound());
  const auto strain = [](double velocity) {
    return [velocity](double c) { return 1e-8 * (std::log(c) + 3 * std::log(velocity)); };
  };
  ArmGuess guess(law);
  guess.take(1, balanceAt(law, 1, strain(1)));
  guess.take(2, balanceAt(law, 2, strain(2)));
  const ArmBalance* found = guess.at(3);
  for (std::size_t i = 1; i < law.arms.size(); ++i)
    EXPECT_NEAR(found->strain[i], strain(3)(3 * law.arms[i].relaxationTime), 1e-19) << i;
}

/// One arm has no neighbours to look up.
TEST(ArmGuess, OneArmIsEnough) {
  const ElementLaw law = elementLaw(standardSolid(1e6, {4e6, 1e-3}));
  ArmGuess guess(law);
  guess.take(1, balanceAt(law, 1, [](double) { return 2e-8; }));
  guess.take(2, balanceAt(law, 2, [](double) { return 3e-8; }));
  const ArmBalance* found = guess.at(4);
  ASSERT_NE(found, nullptr);
  EXPECT_TRUE(std::isfinite(found->strain[0]));
}

}  // namespace
}  // namespace asperity
