// The sequence of Sobol with the direction numbers of Joe and Kuo: even in every axis and pair.
#include "core/study/sobol_sequence.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>

namespace asperity {
namespace {

TEST(SobolSequence, BeginsAsThatOfJoeAndKuo) {
  // The example of their program, three dimensions.
  const double points[8][3] = {{0, 0, 0},          {.5, .5, .5},       {.75, .25, .25},
                               {.25, .75, .75},    {.375, .375, .625}, {.875, .875, .125},
                               {.625, .125, .875}, {.125, .625, .375}};
  for (std::uint32_t i = 0; i < 8; ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(sobolNumber(i, d) * 0x1p-32, points[i][d]) << i << " " << d;
}

TEST(SobolSequence, PutsOnePointInEachPartOfEveryAxis) {
  constexpr std::uint32_t kCount = 1024;
  for (int d = 0; d < kMaxSobolDimensions; ++d) {
    std::set<std::uint32_t> parts;
    for (std::uint32_t i = 0; i < kCount; ++i) parts.insert(sobolNumber(i, d) >> 22);
    EXPECT_EQ(parts.size(), kCount) << d;
  }
}

TEST(SobolSequence, FirstTwoDimensionsAreAnEvenNet) {
  // Every rectangle of 2^-j by 2^(j - 8) holds one of 256 points: a (0, 8, 2)-net.
  for (int j = 0; j <= 8; ++j) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < 256; ++i)
      cells.emplace(j == 0 ? 0 : sobolNumber(i, 0) >> (32 - j),
                    j == 8 ? 0 : sobolNumber(i, 1) >> (24 + j));
    EXPECT_EQ(cells.size(), 256U) << j;
  }
}

}  // namespace
}  // namespace asperity
