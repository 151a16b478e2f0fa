// The public profile against its converged friction (an independent solver).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/contact/csv_table.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

double relative(double value, double exact) {
  return std::abs(value / exact - 1);
}

TEST(Reference, HasAllItsRows) {
  EXPECT_EQ(convergedRows().size(), 30U);
}

TEST(Reference, CubicAtTwoPointsPerElement) {
  const TravelLine line = prepareTravel(referenceProfile(2), Scheme::Cubic);
  for (const ConvergedRow& row : convergedRows()) {
    const SteadyResult result = slideAtForce(line, {kModulus, kTau, row.velocity}, row.normalForce);
    ASSERT_EQ(result.status, SteadyStatus::Balanced);
    const bool resolved = row.contactFraction >= 5e-4;
    EXPECT_LT(relative(result.mu, row.mu), resolved ? 5e-3 : 3e-2)
        << row.normalForce << " N, " << row.velocity << " m/s";
    EXPECT_LT(relative(result.contactFraction, row.contactFraction), resolved ? 1e-2 : 3e-2)
        << row.normalForce << " N, " << row.velocity << " m/s";
  }
}

TEST(Reference, CubicAtEightPointsPerElement) {
  const TravelLine line = prepareTravel(referenceProfile(8), Scheme::Cubic);
  for (const ConvergedRow& row : convergedRows()) {
    if (row.velocity > 100) continue;
    const SteadyResult result = slideAtForce(line, {kModulus, kTau, row.velocity}, row.normalForce);
    EXPECT_LT(relative(result.mu, row.mu), 1e-3)
        << row.normalForce << " N, " << row.velocity << " m/s";
    EXPECT_LT(relative(result.rmsSlopeContact, row.rmsSlopeContact), 2e-3);
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
