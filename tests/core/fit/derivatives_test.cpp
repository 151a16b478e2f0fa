// Derivatives of friction on common lines, against what scaling says of them.
#include "core/fit/derivatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/input_error.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene smallScene() {
  return sceneOfSize(300, 5, 12, 0.02);
}

std::map<std::string_view, Sensitivity> byKey(const std::vector<Sensitivity>& all) {
  std::map<std::string_view, Sensitivity> map;
  for (const Sensitivity& one : all) map[one.key] = one;
  return map;
}

/// mu / h is a function of F_N / (G h L) and v tau: the exponents of force, modulus, height,
/// velocity and relaxation time obey these identities, by any step.
TEST(Sensitivities, ObeyTheScalingOfTheModel) {
  const auto of = byKey(sensitivities(smallScene()));
  const double force = of.at("load.normal_force").slope.value;
  const double modulus = of.at("elastomer.shear_modulus").slope.value;
  const double height = of.at("surface.rms_height").slope.value;
  const double velocity = of.at("sliding.velocity").slope.value;
  const double time = of.at("elastomer.relaxation_time").slope.value;
  EXPECT_NEAR(force + modulus, 0, 1e-5);
  EXPECT_NEAR(velocity - time, 0, 1e-9);
  EXPECT_NEAR(height + force, 1, 1e-5);
  EXPECT_GT(velocity, 0);
  EXPECT_LT(force, 0);
}

/// At low velocity mu is proportional to v; in complete contact at low velocity to v / F_N as well,
/// Eq. (8).
TEST(Sensitivities, KnowTheExponentsOfCompleteContact) {
  Scene scene = smallScene();
  scene.sliding.velocity = 1e-8;
  scene.load.normalForce = 100;
  const auto of = byKey(sensitivities(scene));
  EXPECT_NEAR(of.at("sliding.velocity").slope.value, 1, 1e-6);
  EXPECT_NEAR(of.at("load.normal_force").slope.value, -1, 1e-6);
  EXPECT_NEAR(of.at("surface.rms_height").slope.value, 2, 1e-5);
}

TEST(Sensitivities, LeaveOutWhatIsSwitchedOffAndWhatChangesNothing) {
  const auto of = byKey(sensitivities(smallScene()));
  EXPECT_FALSE(of.contains("surface.summit_correlation"));
  EXPECT_FALSE(of.contains("interface.friction_coefficient"));
  EXPECT_FALSE(of.contains("elastomer.shift.c1"));  // at the reference temperature
  EXPECT_TRUE(of.contains("elastomer.temperature"));
  EXPECT_TRUE(of.contains("surface.hurst"));
}

/// mu depends on v a_T alone: the exponent of temperature is that of velocity times d ln a_T / d ln
/// T, however fast a_T changes and the exponent with it.
TEST(Sensitivities, OfTemperatureAreThoseOfTheShiftedVelocity) {
  for (const double velocity : {1e-6, 0.02, 0.5, 2.0}) {
    Scene scene = smallScene();
    scene.sliding.velocity = velocity;
    const TemperatureShift& shift = scene.elastomer.shift;
    scene.elastomer.temperature = shift.referenceTemperature;
    const double exponentOfShift = -shift.c1 * std::log(10.0) / shift.c2;  // d ln a_T / dT
    const auto of = byKey(sensitivities(scene));
    const double expected = of.at("sliding.velocity").slope.value;
    for (const std::string_view key :
         {"elastomer.temperature", "elastomer.shift.reference_temperature"}) {
      const Sensitivity& one = of.at(key);
      const double found =
          one.isLogarithmic ? one.slope.value / scene.elastomer.temperature : one.slope.value;
      EXPECT_NEAR(std::abs(found / exponentOfShift), std::abs(expected), 1e-5)
          << key << " at " << velocity;
    }
  }
}

/// At the last temperature of a table there is a shift on one side alone, and with one temperature
/// on none.
TEST(Sensitivities, DoNotLeaveTheTableOfShifts) {
  Scene scene = smallScene();
  TemperatureShift& shift = scene.elastomer.shift;
  shift.kind = ShiftKind::Table;
  shift.table = {{280, 1.0}, {300, 0.0}};
  for (const double temperature : {280.0, 280.1, 290.0, 299.9999, 300.0}) {
    scene.elastomer.temperature = temperature;
    const auto of = byKey(sensitivities(scene));
    const double expected = -of.at("sliding.velocity").slope.value * std::log(10.0) / 20;
    const Sensitivity& one = of.at("elastomer.temperature");
    const double found = one.isLogarithmic ? one.slope.value / temperature : one.slope.value;
    EXPECT_NEAR(found / expected, 1, 2e-3) << temperature;
  }
  shift.table = {{300, 0.0}};
  scene.elastomer.temperature = 300;
  const auto of = byKey(sensitivities(scene));
  EXPECT_FALSE(of.contains("elastomer.temperature"));
  EXPECT_TRUE(of.contains("sliding.velocity"));
}

/// The error is that of the lines: with four times as many it is half as large.
TEST(Sensitivities, HaveTheErrorOfTheMeanOverTheLines) {
  Scene few = smallScene(), many = few;
  few.ensemble.realizations = 100;
  many.ensemble.realizations = 400;
  const double a = byKey(sensitivities(few)).at("load.normal_force").slope.standardError;
  const double b = byKey(sensitivities(many)).at("load.normal_force").slope.standardError;
  EXPECT_NEAR(a / b, 2, 0.5);
}

TEST(VariedParameter, RefusesWhatCannotBeVaried) {
  const Scene scene = smallScene();
  EXPECT_THROW(VariedParameter("surface.seed", scene), InputError);   // a whole number
  EXPECT_THROW(VariedParameter("surface.slope", scene), InputError);  // of a wedge
  EXPECT_THROW(VariedParameter("surface.hurts", scene), InputError);  // unknown
  EXPECT_THROW(VariedParameter("surface.roll_off_wavelength", scene), InputError);  // none
  EXPECT_THROW(VariedParameter("surface.hurst", scene, 0.8, 0.9), InputError);  // 0.7 is outside
  EXPECT_THROW(VariedParameter("surface.hurst", scene, 0.9, 0.2), InputError);
  EXPECT_THROW(VariedParameter("surface.hurst", scene, 0.2, 2), InputError);
}

}  // namespace
}  // namespace asperity
