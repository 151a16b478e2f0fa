// The public profile against its converged friction (an independent solver).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

TEST(Reference, HasAllItsRows) {
  EXPECT_EQ(convergedRows().size(), 45U);
}

/// Errors of mu that the README states, as far as its digits say them: where at least 5e-4 of the
/// line is in contact, and, as a factor, below.
struct Stated {
  Scheme scheme;
  std::int64_t oversampling;
  double above, factorBelow;
};

TEST(Reference, FrictionIsAsAccurateAsTheReadmeSays) {
  for (const Stated& stated : {Stated{Scheme::Cubic, 2, 2.5e-3, 1.0225},
                               {Scheme::Cubic, 4, 2.5e-4, 1.0095},
                               {Scheme::Cubic, 8, 1.5e-5, 1.0025},
                               {Scheme::Linear, 8, 3.5e-3, 5}}) {
    const PreparedProfile line =
        prepareProfile(referenceProfile(stated.oversampling), stated.scheme);
    for (const ConvergedRow& row : convergedRows()) {
      SCOPED_TRACE(testing::Message() << row.normalForce << " N, " << row.velocity << " m/s");
      const SteadyResult result =
          slideAtForce(line, {kModulus, kTau, row.velocity}, row.normalForce);
      ASSERT_EQ(result.status, SteadyStatus::Balanced);
      if (row.contactFraction >= 5e-4) {
        EXPECT_LT(relativeError(result.mu, row.mu), stated.above);
      } else {
        EXPECT_LT(std::max(result.mu / row.mu, row.mu / result.mu), stated.factorBelow);
      }
    }
  }
}

/// From the true lowest point, between the nodes: the nodes alone miss it by 1e-10 m here.
TEST(Reference, IndentationIsMeasuredFromTheLowestPoint) {
  for (const auto& [oversampling, error] : {std::pair{2, 7e-4}, {4, 3e-5}, {8, 2e-6}}) {
    const PreparedProfile line = prepareProfile(referenceProfile(oversampling), Scheme::Cubic);
    for (const ConvergedRow& row : convergedRows())
      EXPECT_LT(relativeError(
                    slideAtForce(line, {kModulus, kTau, row.velocity}, row.normalForce).indentation,
                    row.indentation),
                error)
          << "x" << oversampling << ", " << row.normalForce << " N, " << row.velocity << " m/s";
  }
}

TEST(Reference, ContactOfSmoothSegments) {
  for (const std::int64_t oversampling : {2, 8}) {
    const PreparedProfile line = prepareProfile(referenceProfile(oversampling), Scheme::Cubic);
    for (const ConvergedRow& row : convergedRows()) {
      SCOPED_TRACE(testing::Message() << row.normalForce << " N, " << row.velocity << " m/s");
      const SteadyResult result =
          slideAtForce(line, {kModulus, kTau, row.velocity}, row.normalForce);
      if (oversampling == 2) {
        EXPECT_LT(relativeError(result.contactFraction, row.contactFraction),
                  row.contactFraction >= 5e-4 ? 1e-2 : 3e-2);
      } else if (row.velocity <= 100) {
        EXPECT_LT(relativeError(result.rmsSlopeContact, row.rmsSlopeContact), 2e-3);
      }
    }
  }
}

TEST(Reference, StatisticsOfTheProfile) {
  const Line line = referenceProfile(1);
  EXPECT_NEAR(line.rmsSlope, 0.00111101246332, 1e-14);
  EXPECT_NEAR(line.rmsHeight, 5e-7, 1e-18);
  EXPECT_NEAR(line.length, 0.02, 1e-15);
}

}  // namespace
}  // namespace asperity
