#include "ui/window/figures/claims_table.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(EstimateText, HasTheDigitsThatTheUncertaintyLeaves) {
  EXPECT_EQ(estimateText({1.2345, 0.056}), QStringLiteral("1.23 ± 0.06"));
  EXPECT_EQ(estimateText({1.2345, 0.0123}), QStringLiteral("1.234 ± 0.012"));
  EXPECT_EQ(estimateText({-0.4127, 0.003}), QStringLiteral("−0.413 ± 0.003"));
  EXPECT_EQ(estimateText({123.4, 31}), QStringLiteral("123 ± 31"));
  EXPECT_EQ(estimateText({0.5, kNotApplicable}), QStringLiteral("0.5"));
  EXPECT_EQ(estimateText({2.5e-9, 1e-10}), QStringLiteral("(2.50 ± 0.10)×10⁻⁹"));
  EXPECT_EQ(estimateText({0.000101, 2.69e-5}), QStringLiteral("(1.0 ± 0.3)×10⁻⁴"));
  EXPECT_EQ(estimateText({}), QStringLiteral("–"));
}

TEST(VerdictText, HasAWordForEveryVerdict) {
  Claim claim;
  EXPECT_EQ(verdictText(claim), QStringLiteral("undecided"));
  claim.holds = Verdict::Yes;
  EXPECT_EQ(verdictText(claim), QStringLiteral("yes"));
  claim.holds = Verdict::No;
  EXPECT_EQ(verdictText(claim), QStringLiteral("no"));
  claim.holds = Verdict::OnlyForScheme;
  claim.scheme = "cubic";
  EXPECT_TRUE(verdictText(claim).startsWith("only for scheme"));
}

}  // namespace
}  // namespace asperity
