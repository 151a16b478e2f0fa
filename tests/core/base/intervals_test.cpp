// Groups of values by equal intervals of their logarithm.
#include "core/base/intervals.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {
namespace {

/// Every value is in one band; powers of ten are at edges, or with a shift of one half in the
/// middle of bands.
TEST(Intervals, LogBandsDivideEachDecadeEqually) {
  const std::vector<double> values{0.5, 0.9, 1, 3, 9.9, 10, 500, 1000};
  const auto ends = [&](double perDecade, double shift) {
    std::vector<std::size_t> all;
    std::size_t last = 0;
    for (const IndexRange& band : logBands(values, perDecade, shift)) {
      EXPECT_EQ(band.begin, last);
      EXPECT_GT(band.size(), 0U);
      all.push_back(last = band.end);
    }
    return all;
  };
  EXPECT_EQ(ends(1, 0), (std::vector<std::size_t>{2, 5, 6, 7, 8}));
  EXPECT_EQ(ends(1, 0.5), (std::vector<std::size_t>{4, 6, 8}));
  EXPECT_TRUE(logBands({}, 16).empty());
}

}  // namespace
}  // namespace asperity
