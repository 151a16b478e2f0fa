// The pass over straight segments by its summits, against the plain pass that goes along the line.
#include "core/contact/kernels/kernels.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/contact/force_balance.h"
#include "core/contact/kernels/pass.h"
#include "core/surface/line.h"
#include "tests/core/contact/fixed_depths.h"
#include "tests/core/contact/instruction_sets.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

class LinearKernel : public EachInstructionSet {};

PassSums sumsOf(const PreparedProfile& line, double depth, double relaxationLength) {
  FixedDepths queue(depth, relaxationLength);
  runLinearPasses(line, queue);
  EXPECT_EQ(queue.found.size(), 1U);
  return queue.found.at(0);
}

void expectPlain(const PreparedProfile& line, double depth, double relaxationLength) {
  SCOPED_TRACE(testing::Message() << line.segments() << " segments, " << depth << " m deep, "
                                  << relaxationLength << " m of relaxation length");
  const PassSums plain = resolvedPass(line, depth, relaxationLength);
  const PassSums sums = sumsOf(line, depth, relaxationLength);
  EXPECT_NEAR(sums.depth, plain.depth, 1e-12 * plain.depth);
  // Where contact ends without relaxation the surface has no depth, to rounding.
  const double rounding = std::numeric_limits<double>::epsilon() * depth;
  EXPECT_NEAR(sums.dissipation, plain.dissipation, 1e-12 * plain.dissipation + rounding * rounding);
  EXPECT_NEAR(sums.stiffness, plain.stiffness, 1e-10 * plain.stiffness);
  EXPECT_NEAR(sums.pressure, plain.pressure, 1e-9 * plain.pressure);
  EXPECT_NEAR(sums.contactLength, plain.contactLength, 1e-5 * line.spacing);
}

constexpr double kRelaxationLengths[] = {0,    1e-200, 1e-12, 1e-9, 1e-7, 1e-6,
                                         1e-5, 1e-4,   1e-3,  0.1,  1e2};

/// Words of segments whole and in part, corners at their ends, from a touch to complete contact.
TEST_P(LinearKernel, AgreesWithThePlainPass) {
  for (const std::int64_t elements : {20, 63, 64, 65, 66, 67, 128, 130, 700, 4999})
    for (const double hurst : {0.0, 0.7, 1.0}) {
      const PreparedProfile line =
          prepareProfile(roughLine(elements, 1, hurst, elements), Scheme::Linear);
      for (const double depth : {1e-10, 1e-8, 1e-7, 4e-7, 1e-6, 2e-6, 1e-5})
        for (const double relaxationLength : kRelaxationLengths)
          expectPlain(line, depth, relaxationLength);
    }
}

TEST_P(LinearKernel, BothWaysAlongTheLine) {
  const Line rough = roughLine(1000, 1, 0.3);
  for (const Line& way : {rough, mirrored(rough)}) {
    const PreparedProfile line = prepareProfile(way, Scheme::Linear);
    for (const double relaxationLength : kRelaxationLengths)
      expectPlain(line, 6e-7, relaxationLength);
  }
}

/// Corners, plateaus, slopes all alike: pressure that vanishes at a node, or stays as it is.
TEST_P(LinearKernel, AgreesWithThePlainPassOnShapes) {
  for (const Line& shape : {wedgeLine(0.02, 101, 1e-3), parabolaLine(0.02, 64, 1.0),
                            sineLine(0.02, 300, 5e-7, 7), sineLine(0.02, 300, 0, 7)}) {
    const PreparedProfile line = prepareProfile(shape, Scheme::Linear);
    for (const double depth : {1e-10, 1e-7, 9e-7, 3e-6})
      for (const double relaxationLength : kRelaxationLengths)
        expectPlain(line, depth, relaxationLength);
  }
}

/// Everything in contact: nothing vanishes, and the sums are known.
TEST_P(LinearKernel, CompleteContact) {
  const PreparedProfile line = prepareProfile(roughLine(3000), Scheme::Linear);
  for (const double relaxationLength : {1e-9, 1e-5, 1e-3}) {
    const double depth = 1.01 * completeAbove(line, relaxationLength);
    const PassSums known = completeContactSums(line, depth, relaxationLength);
    const PassSums sums = sumsOf(line, depth, relaxationLength);
    EXPECT_NEAR(sums.depth / known.depth, 1, 1e-13);
    EXPECT_NEAR(sums.stiffness / line.length, 1, 1e-14);
    EXPECT_NEAR(sums.contactLength / line.length, 1, 1e-14);
    EXPECT_NEAR(sums.dissipation / known.dissipation, 1, 1e-13);
  }
}

/// What a pass carries more at more depth is its stiffness.
TEST_P(LinearKernel, StiffnessIsTheDerivativeOfTheForce) {
  const PreparedProfile line = prepareProfile(roughLine(900), Scheme::Linear);
  for (const double relaxationLength : {1e-7, 1e-5, 1e-3, 0.1})
    for (const double depth : {2e-7, 6e-7, 1.2e-6}) {
      const double step = 1e-6 * depth;
      const double change = sumsOf(line, depth + step, relaxationLength).depth -
                            sumsOf(line, depth - step, relaxationLength).depth;
      EXPECT_NEAR(change / (2 * step * sumsOf(line, depth, relaxationLength).stiffness), 1, 1e-5);
    }
}

TEST_P(LinearKernel, StopsInsideAPass) {
  const PreparedProfile line = prepareProfile(roughLine(20000, 1, 0.0), Scheme::Linear);
  FixedDepths whole(1e-6, 1e-8), queue(1e-6, 1e-8, 1, 1);
  runLinearPasses(line, whole);
  ASSERT_EQ(whole.found.size(), 1U);
  EXPECT_GT(whole.timesAsked(), 3);
  runLinearPasses(line, queue);
  EXPECT_TRUE(queue.found.empty());
  EXPECT_EQ(queue.timesAsked(), 1);
}

ASPERITY_ON_EACH_INSTRUCTION_SET(LinearKernel);

}  // namespace
}  // namespace asperity
