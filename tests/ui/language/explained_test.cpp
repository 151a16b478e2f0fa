// Explanations as rich text.
#include "ui/language/translated.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace asperity
