// A balance that is not met, in words.
#include "core/contact/unmet_balance.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(UnmetBalance, SaysWhereAndByHowMuch) {
  SteadyResult result;
  EXPECT_NO_THROW(requireBalance(result, 0.5));
  result.status = SteadyStatus::NotBalanced;
  result.residual = 0.03;
  EXPECT_STREQ(unmetBalance(result, 0.5).what(),
               "the force balance is not met at velocity 0.5 m/s: relative residual 0.03");
  try {
    requireBalance(result, 0.5, " on realization 3");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the force balance is not met at velocity 0.5 m/s on realization 3: relative "
                 "residual 0.03");
  }
}

/// The balance is met, but the two ways to the force differ.
TEST(UnmetBalance, TellsWhenDigitsRanOut) {
  SteadyResult result;
  result.status = SteadyStatus::NotBalanced;
  result.residual = 0;
  EXPECT_STREQ(unmetBalance(result, 2).what(),
               "contact is too short, or moduli are too far apart, for the digits that numbers "
               "have, at velocity 2 m/s");
}

}  // namespace
}  // namespace asperity
