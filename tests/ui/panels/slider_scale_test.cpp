// Values of sliders and texts of numbers.
#include "ui/panels/value_slider.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/panels/number_text.h"

namespace asperity {
namespace {

TEST(SliderScale, EveryPositionIsAnotherValueThatTheSceneAccepts) {
  for (const Parameter& parameter : parameters()) {
    if (!isNumber(parameter)) continue;
    const SliderScale scale(parameter);
    ASSERT_GT(scale.count(), 1) << parameter.key;
    Scene scene;
    for (int i = 0; i < scale.count(); ++i) {
      EXPECT_EQ(scale.sliderPosition(scale.valueAt(i)), i) << parameter.key;
      EXPECT_NO_THROW(setValue(parameter, scene, scale.valueAt(i))) << parameter.key;
      if (i > 0) {
        EXPECT_GT(scale.valueAt(i), scale.valueAt(i - 1));
      }
    }
  }
}

TEST(SliderScale, EndsAreTheRowsEnds) {
  const Parameter& force = *findParameter("load.normal_force");
  const auto& field = std::get<RealField>(force.field);
  const SliderScale scale(force);
  EXPECT_EQ(scale.valueAt(0), field.sliderFrom);
  EXPECT_EQ(scale.valueAt(scale.count() - 1), field.sliderTo);
  EXPECT_EQ(scale.sliderPosition(field.sliderFrom / 10), 0);
  EXPECT_EQ(scale.sliderPosition(field.sliderTo * 10), scale.count() - 1);
}

TEST(SliderScale, MiddleOfALogarithmicSliderIsTheGeometricMean) {
  const Parameter& modulus = *findParameter("elastomer.shear_modulus");
  const auto& field = std::get<RealField>(modulus.field);
  const SliderScale scale(modulus);
  EXPECT_NEAR(std::log10(scale.valueAt(scale.count() / 2)),
              (std::log10(field.sliderFrom) + std::log10(field.sliderTo)) / 2, 0.02);
}

/// The dashpot of the usual elastomer, G tau, stands in the middle; none at the left end.
TEST(SliderScale, ALogarithmicSliderMayBeginWithNone) {
  const Parameter& viscosity = *findParameter("elastomer.viscosity");
  const SliderScale scale(viscosity);
  EXPECT_EQ(scale.valueAt(0), 0);
  EXPECT_EQ(scale.valueAt(1), std::get<RealField>(viscosity.field).sliderFrom);
  EXPECT_EQ(scale.sliderPosition(0), 0);
  EXPECT_EQ(scale.sliderPosition(1e-3), 1);
  const Elastomer usual;
  EXPECT_NEAR(scale.sliderPosition(usual.shearModulus * usual.relaxationTime), scale.count() / 2,
              0.01 * scale.count());
}

TEST(SliderScale, StepsAreRoundNumbers) {
  const SliderScale scale(*findParameter("sliding.velocity"));
  for (int i = 0; i < scale.count(); i += 37)
    EXPECT_LE(numberText(scale.valueAt(i)).size(), 8) << scale.valueAt(i);
}

TEST(NumberText, IsShortAndReadsBack) {
  EXPECT_EQ(numberText(1e7), "1e7");
  EXPECT_EQ(numberText(5e-7), "5e-7");
  EXPECT_EQ(numberText(0.0034), "0.0034");
  EXPECT_EQ(numberText(1000), "1000");
  for (const double value : {1.0 / 3, 1e-300, 6.02214076e23, -0.1, 0.0})
    EXPECT_EQ(numberText(value).toDouble(), value);
}

TEST(NumberText, SymbolsLookLikePrint) {
  EXPECT_EQ(symbolHtml("tau"), QStringLiteral("<i>τ</i>"));
  EXPECT_EQ(symbolHtml("kappa"), QStringLiteral("<i>κ</i>"));
  EXPECT_EQ(symbolHtml("lambda_r"), QStringLiteral("<i>λ</i><sub>r</sub>"));
  EXPECT_EQ(symbolHtml("F_N"), QStringLiteral("<i>F</i><sub>N</sub>"));
  EXPECT_EQ(wordText("self_affine"), QStringLiteral("self-affine"));
  // Names of files' conventions, such as C1, say nothing to people.
  EXPECT_EQ(wordText("c1_two_sided", "surface.spectrum_kind"),
            QStringLiteral("of a line, two-sided"));
  EXPECT_EQ(wordText("c2", "surface.spectrum_kind"), QStringLiteral("of a surface"));
}

/// A scene may lie beyond the usual slider: asphalt has an rms height of 180 um.
TEST(SliderScale, ReachesAsFarAsTheScenesValue) {
  const Parameter& height = *findParameter("surface.rms_height");
  const auto& field = std::get<RealField>(height.field);
  const SliderScale scale(height, 1.8e-4);
  EXPECT_EQ(scale.valueAt(0), field.sliderFrom);
  EXPECT_EQ(scale.valueAt(scale.count() - 1), 1e-3);
  const int position = scale.sliderPosition(1.8e-4);
  EXPECT_NEAR(scale.valueAt(position) / 1.8e-4, 1, 0.02);
  EXPECT_GT(scale.valueAt(position - 1) / 1.8e-4, 0.97);
  EXPECT_EQ(SliderScale(height, 1e-6).count(), SliderScale(height).count());
  const SliderScale lower(height, 3e-11);
  EXPECT_EQ(lower.valueAt(0), 1e-11);
  EXPECT_EQ(SliderScale(height, 1).valueAt(scale.count() - 1), 1);
  Scene scene;
  for (const Parameter& parameter : parameters()) {
    if (!isNumber(parameter)) continue;
    const AllowedRange allowed = *allowedRange(parameter);
    for (const double value : {allowed.minimum, allowed.maximum}) {
      const SliderScale whole(parameter, value);
      for (const int end : {0, whole.count() - 1})
        EXPECT_NO_THROW(setValue(parameter, scene, whole.valueAt(end))) << parameter.key;
    }
  }
}

}  // namespace
}  // namespace asperity
