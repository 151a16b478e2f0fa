// What is left of an elastomer, and its shift with temperature.
#include "core/material/element_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/material/temperature_shift.h"
#include "core/scene/scene_check.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

Elastomer prony(std::vector<Arm> arms, double equilibrium = 1e6, double viscosity = 0) {
  return asperity::prony(equilibrium, std::move(arms), viscosity);
}

TEST(TemperatureShift, MultipliesEveryTimeAndTheViscosity) {
  Elastomer cold = prony({{2e6, 1e-2}, {3e6, 1e-5}}, 1e6, 7);
  cold.temperature = 280;
  const double a = shiftFactor(cold.shift, 280);
  const ElementLaw law = elementLaw(cold);
  EXPECT_EQ(law.arms[0].relaxationTime, 1e-2 * a);
  EXPECT_EQ(law.arms[1].relaxationTime, 1e-5 * a);
  EXPECT_EQ(law.viscosity, 7 * a);
  EXPECT_EQ(law.equilibriumModulus, 1e6);
  Elastomer kelvin;
  kelvin.temperature = 280;
  EXPECT_EQ(elementLaw(kelvin).relaxationTime, 1e-3 * a);
}

TEST(ElementLaw, WithoutStrengthThereIsNoArmAndNoDashpot) {
  EXPECT_EQ(elementLaw(prony({{0, 1}, {2, 0}})).kind(), ElementKind::Elastic);
  EXPECT_EQ(elementLaw(prony({{0, 1}}, 1e6, 5)).kind(), ElementKind::Kelvin);
  EXPECT_EQ(elementLaw(prony({{0, 1}, {3, 1}})), elementLaw(prony({{3, 1}})));
  Elastomer kelvin;
  kelvin.relaxationTime = 0;
  EXPECT_EQ(elementLaw(kelvin).kind(), ElementKind::Elastic);
}

TEST(ElementLaw, ArmsFallInTimeAndEqualTimesAreOne) {
  const ElementLaw law = elementLaw(prony({{1, 1e-3}, {2, 10}, {4, 1e-3}}));
  ASSERT_EQ(law.arms.size(), 2U);
  EXPECT_EQ(law.arms[0], (Arm{2, 10}));
  EXPECT_EQ(law.arms[1], (Arm{5, 1e-3}));
  EXPECT_EQ(law.glassyModulus(), 1e6 + 7);
}

/// A Zener solid's loss peaks at omega tau = 1 with half of its arm.
TEST(ElementLaw, ComplexModulusOfAnArm) {
  const ElementLaw law = elementLaw(prony({{4e6, 1e-2}}, 1e6));
  EXPECT_DOUBLE_EQ(complexModulus(law, 100).loss, 2e6);
  EXPECT_DOUBLE_EQ(complexModulus(law, 100).storage, 3e6);
  EXPECT_NEAR(complexModulus(law, 1e9).storage, law.glassyModulus(), 1);
}

TEST(Effects, SteadySlidingIsAskedForInOneSentence) {
  Scene scene;
  EXPECT_NO_THROW(requireSteadySliding(scene, "asperity curve"));
  scene.sliding.kind = SlidingKind::Reversal;
  try {
    requireSteadySliding(scene, "asperity curve");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "sliding.kind: asperity curve needs steady sliding, not reversal");
  }
  scene.sliding.kind = SlidingKind::Steady;
  scene.elastomer = prony({{1, 1}}, 0);
  EXPECT_THROW(requireSteadySliding(scene, "asperity curve"), InputError);
}

}  // namespace
}  // namespace asperity
