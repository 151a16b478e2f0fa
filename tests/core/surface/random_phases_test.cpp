// Phases made several at a time.
#include "core/surface/random_phases.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace asperity {
namespace {

/// Salmon et al.'s generator, several counters at a time, against the one of its authors.
TEST(RandomPhases, OfManyModesAreThoseOfEach) {
  for (const std::uint64_t seed : {1ULL, 9007199254740991ULL})
    for (const std::uint64_t realization : {0ULL, 3ULL, 0x123456789ABCDEFULL})
      for (const std::uint64_t first : {0ULL, 5ULL, 0xFFFFFFFEULL})
        for (const std::size_t pairs : {1UL, 7UL, 64UL}) {
          std::vector<double> phases(2 * pairs + 1, -1.0);
          randomPhasesInto(seed, realization, first, pairs, phases.data());
          for (std::size_t k = 0; k < pairs; ++k) {
            const PhasePair two = randomPhases(seed, realization, first + k);
            EXPECT_EQ(phases[2 * k], two.even);
            EXPECT_EQ(phases[2 * k + 1], two.odd);
          }
          EXPECT_EQ(phases.back(), -1);  // no more than was asked for
        }
}

}  // namespace
}  // namespace asperity
