// What is left of an elastomer, and its shift with temperature.
#include "core/material/element_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/scene/scene_check.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

Elastomer prony(std::vector<Arm> arms, double equilibrium = 1e6, double viscosity = 0) {
  return asperity::prony(equilibrium, std::move(arms), viscosity);
}

TEST(TemperatureShift, IsTheFormulaOfWilliamsLandelAndFerry) {
  const TemperatureShift shift{4.41, 137.64, 343.15};
  EXPECT_EQ(shiftFactor(shift, 343.15), 1);
  EXPECT_NEAR(std::log10(shiftFactor(shift, 363.15)), -4.41 * 20 / 157.64, 1e-14);
  EXPECT_NEAR(std::log10(shiftFactor(shift, 300.0)), 4.41 * 43.15 / (137.64 - 43.15), 1e-13);
  EXPECT_GT(shiftFactor(shift, 300), 1);  // colder is slower
}

TEST(TemperatureShift, EndsAboveTheVogelTemperature) {
  const TemperatureShift shift{8.86, 101.6, 298.15};
  EXPECT_THROW(shiftFactor(shift, 298.15 - 101.6), InputError);
  EXPECT_THROW(shiftFactor(shift, 100), InputError);
  EXPECT_THROW(shiftFactor(shift, 298.15 - 101.5), InputError);  // 9000 decades
  EXPECT_GT(shiftFactor(shift, 298.15 - 70), 1e10);
}

/// ln a_T = E/R (1/T - 1/T_r).
TEST(TemperatureShift, ArrheniusIsItsClosedForm) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Arrhenius;
  shift.activationEnergy = 8e4;
  for (const double kelvin : {260.0, 280.0, 298.0, 330.0, 400.0})
    EXPECT_NEAR(std::log(shiftFactor(shift, kelvin)),
                8e4 / 8.31446261815324 * (1 / kelvin - 1 / 298.15), 1e-12);
  EXPECT_EQ(shiftFactor(shift, 298.15), 1);
}

TEST(TemperatureShift, ATableIsLinearBetweenItsRows) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.table = {{280, 2}, {290, 1}, {300, 0}, {320, -1}};
  EXPECT_EQ(log10ShiftFactor(shift, 290), 1);
  EXPECT_NEAR(log10ShiftFactor(shift, 285), 1.5, 1e-15);
  EXPECT_NEAR(log10ShiftFactor(shift, 315), -0.75, 1e-15);
  EXPECT_EQ(shiftFactor(shift, 300), 1);
  EXPECT_NO_THROW(shiftFactor(shift, 280));
  EXPECT_NO_THROW(shiftFactor(shift, 320));
  EXPECT_THROW(shiftFactor(shift, 279.999), InputError);
  EXPECT_THROW(shiftFactor(shift, 320.001), InputError);
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
