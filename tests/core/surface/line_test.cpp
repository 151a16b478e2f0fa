#include "core/surface/line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

double rmsAboutMean(const std::vector<double>& values) {
  double mean = 0, sum = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(Shapes, StatedStatisticsAreThoseOfTheLine) {
  for (const Line& line :
       {sineLine(2, 20000, 3, 5), wedgeLine(2, 20000, 0.1), parabolaLine(2, 20000, 7)})
    EXPECT_NEAR(rmsAboutMean(line.height) / line.rmsHeight, 1, 1e-7);
}

TEST(Shapes, SlopesAreDerivatives) {
  const Line line = sineLine(2, 4000, 3, 5);
  for (std::size_t i = 1; i + 1 < line.nodes(); ++i) {
    const double difference = (line.height[i + 1] - line.height[i - 1]) / (2 * line.spacing);
    EXPECT_NEAR(line.slopeAfter[i], difference, 1e-4 * line.rmsSlope);
  }
}

TEST(Shapes, EvenShapesAreSymmetricWithCornersOnBothSides) {
  for (const std::size_t nodes : {10UL, 11UL})
    for (const Line& line : {wedgeLine(1, nodes, 0.2), parabolaLine(1, nodes, 3)}) {
      const std::size_t tip = nodes / 2;
      EXPECT_EQ(line.height[tip], 0);
      for (std::size_t k = 1; k < nodes; ++k) {
        const std::size_t right = (tip + k) % nodes, left = (tip + nodes - k) % nodes;
        EXPECT_EQ(line.height[right], line.height[left]);
        EXPECT_EQ(line.slopeAfter[right], -line.slopeLeftOf(left)) << k;
      }
      EXPECT_EQ(line.slopeAfter[tip], -line.slopeLeftOf(tip));
    }
}

}  // namespace
}  // namespace asperity
