// Explanations as rich text.
#include "ui/language/translated.h"

#include <gtest/gtest.h>

#include "ui/language/language.h"

namespace asperity {
namespace {

TEST(Explained, TheNormalForceHasALoweredN) {
  const QString lowered = QStringLiteral("F<sub>N</sub>");
  EXPECT_EQ(richText(QStringLiteral("F\u2099 < 1 N")), lowered + QStringLiteral(" &lt; 1 N"));
  EXPECT_TRUE(wrappedTip(QStringLiteral("F\u2099 = 1 N")).contains(lowered));
  const auto explanation = findExplanation(std::string_view("load.normal_force"));
  ASSERT_TRUE(explanation);
  const QString tip = explanationHtml(*explanation, QStringLiteral("F\u2099 = 200 mN"));
  EXPECT_TRUE(tip.contains("<b>" + lowered + " = 200 mN</b>")) << tip.toStdString();
  EXPECT_FALSE(tip.contains("F_N")) << tip.toStdString();
}

TEST(Explained, TheEquilibriumModulusHasALoweredSign) {
  EXPECT_EQ(richText(QStringLiteral("G∞ = 1 MPa, ×÷ ∞")),
            QStringLiteral("G<sub>∞</sub> = 1 MPa, ×÷ ∞"));
  EXPECT_EQ(formulaHtml("G(t) = G∞ + Σ G_i"),
            QStringLiteral("G(t) = G<sub>∞</sub> + Σ G<sub>i</sub>"));
}

TEST(Explained, ATipSaysWhatTheSymbolsOfItsFormulaMean) {
  const QString velocity = explanationHtml(*findExplanation(std::string_view("sliding.velocity")));
  for (const char* text : {"η: viscosity (G τ in Kelvin elements)", "z: height of the line",
                           "p: line load", "d: indentation"})
    EXPECT_TRUE(velocity.contains(QString::fromUtf8(text))) << velocity.toStdString();
  EXPECT_FALSE(velocity.contains("displacement")) << velocity.toStdString();
  const QString arms =
      explanationHtml(*findExplanation(std::string_view("elastomer.equilibrium_modulus")));
  EXPECT_FALSE(arms.contains("shear modulus")) << "G∞ and G(t) are no G: " << arms.toStdString();
  const QString shift = explanationHtml(*findExplanation(std::string_view("elastomer.shift.c1")));
  EXPECT_TRUE(shift.contains("a<sub>T</sub>: factor")) << shift.toStdString();
  EXPECT_FALSE(shift.contains("spectral")) << "C₁ is no C: " << shift.toStdString();
  const QString slope = explanationHtml({"", "μ/∇z", "a ratio", ""});
  EXPECT_TRUE(slope.contains("∇z: rms slope")) << slope.toStdString();
  EXPECT_FALSE(slope.contains("height of the line")) << slope.toStdString();
  EXPECT_FALSE(explanationHtml({"", "∇z_cont", "a slope", ""}).contains("∇z: rms slope"));
  EXPECT_TRUE(explanationHtml({"", "4ηv", "a product", ""}).contains("η: viscosity"));
}

/// A symbol of the list that is in no formula has been left behind.
TEST(Explained, EverySymbolIsOfAFormula) {
  QString tips;
  for (const HoverExplanation& explanation : explanations())
    for (const Rheology rheology : {Rheology::Kelvin, Rheology::Prony})
      tips += explanationHtml(withFormulaFor(explanation, rheology));
  for (const FormulaSymbol& one : formulaSymbols())
    EXPECT_TRUE(tips.contains(formulaHtml(one.symbol) + ": " + richText(fromUtf8(one.meaning))))
        << one.symbol;
}

}  // namespace
}  // namespace asperity
