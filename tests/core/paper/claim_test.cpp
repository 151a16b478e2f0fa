// Verdicts: what the borders of a criterion and the uncertainty of a number make of a claim.
#include "core/paper/claim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace asperity {
namespace {

TEST(Claim, IsUndecidedWithinTwoStandardErrorsOfEitherBorder) {
  const Bounds bounds = within(2, 0.5);
  EXPECT_EQ(verdict({2.505, 0.045}, bounds), Verdict::Undecided);
  EXPECT_EQ(verdict({2.41, 0.045}, bounds), Verdict::Undecided) << "0.09 is two standard errors";
  EXPECT_EQ(verdict({2.409, 0.045}, bounds), Verdict::Yes);
  EXPECT_EQ(verdict({2.591, 0.045}, bounds), Verdict::No);
  EXPECT_EQ(verdict({1.52, 0.045}, bounds), Verdict::Undecided);
  EXPECT_EQ(verdict({1.4, 0.045}, bounds), Verdict::No);
  EXPECT_EQ(verdict({0.99, 0.02}, below(1)), Verdict::Undecided);
  EXPECT_EQ(verdict({-7, 0.02}, below(1)), Verdict::Yes);
  EXPECT_EQ(verdict({1.05, 0.02}, above(1)), Verdict::Yes);
}

TEST(Claim, OfAveragesIsUndecidedWithoutAStandardError) {
  EXPECT_EQ(verdict({2, kNotApplicable}, within(2, 0.5)), Verdict::Undecided);
  EXPECT_EQ(verdict({9, kNotApplicable}, within(2, 0.5)), Verdict::Undecided);
  EXPECT_EQ(verdict({kNotApplicable, 0.1}, within(2, 0.5)), Verdict::Undecided);
  EXPECT_EQ(Claim{}.holds, Verdict::Undecided);
}

TEST(Claim, OfAnExactNumberIsDecidedOnTheBorderToo) {
  Claim claim;
  decideExactly(claim, 0, below(0));
  EXPECT_EQ(claim.holds, Verdict::Yes);
  EXPECT_TRUE(std::isnan(claim.measured.standardError));
  decideExactly(claim, 1e-300, below(0));
  EXPECT_EQ(claim.holds, Verdict::No);
  decideExactly(claim, kNotApplicable, below(0));
  EXPECT_EQ(claim.holds, Verdict::Undecided);
}

/// One sure No outweighs a larger but uncertain distance; one Undecided outweighs any Yes.
TEST(Claim, OfSeveralNumbersIsGivenTheOneThatDecides) {
  Claim claim;
  const std::vector<Estimate> withNo{{2.1, 0.01}, {3.1, 0.6}, {2.6, 0.01}, {2, 0.01}};
  EXPECT_EQ(decideByAll(claim, withNo, within(2, 0.5)), 2U);
  EXPECT_EQ(claim.holds, Verdict::No);
  EXPECT_EQ(claim.measured.value, 2.6);
  const std::vector<Estimate> withDoubt{{2.49, 0.001}, {2.3, 0.2}, {2, 0.01}};
  EXPECT_EQ(decideByAll(claim, withDoubt, within(2, 0.5)), 1U);
  EXPECT_EQ(claim.holds, Verdict::Undecided);
  const std::vector<Estimate> sure{{2.1, 0.01}, {2.3, 0.01}, {1.9, 0.01}};
  EXPECT_EQ(decideByAll(claim, sure, within(2, 0.5)), 1U);
  EXPECT_EQ(claim.holds, Verdict::Yes);
  decideByAll(claim, {}, within(2, 0.5));
  EXPECT_EQ(claim.holds, Verdict::Undecided);
}

TEST(Claim, BothHoldOnlyTogether) {
  EXPECT_EQ(both(Verdict::Yes, Verdict::Yes), Verdict::Yes);
  EXPECT_EQ(both(Verdict::Yes, Verdict::Undecided), Verdict::Undecided);
  EXPECT_EQ(both(Verdict::Undecided, Verdict::No), Verdict::No);
}

TEST(Claim, SaysItsBordersAndItsDoubtInJson) {
  Claim claim{"id", "p. 1", "It is so", "a number"};
  decide(claim, {2.505, 0.045}, within(2, 0.5));
  nlohmann::ordered_json json = claimJson(claim);
  EXPECT_EQ(json["holds"], "undecided");
  EXPECT_EQ(json["holds_from"], 1.5);
  EXPECT_EQ(json["holds_to"], 2.5);
  decide(claim, {2, 0.01}, above(1));
  json = claimJson(claim);
  EXPECT_EQ(json["holds"], "yes");
  EXPECT_TRUE(json["holds_to"].is_null());
}

}  // namespace
}  // namespace asperity
