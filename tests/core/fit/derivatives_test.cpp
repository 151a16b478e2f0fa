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
  Scene scene = sceneOfSize(300, 5, 12);
  scene.sliding.velocity = 0.02;
  return scene;
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
