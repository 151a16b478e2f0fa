#include "core/base/jobs.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <vector>

namespace asperity {
namespace {

/// Plain numbers, written by jobs and read by the caller and by later jobs: the thread sanitizer
/// watches here.
TEST(EnsembleJobs, EveryJobIsDoneOnceInEveryRoundAndHandsOver) {
  for (const int threads : {1, 2, 5}) {
    Jobs jobs(threads);
    std::vector<int> done(1000);
    for (int round = 1; round <= 50; ++round) {
      jobs.run(static_cast<std::int64_t>(done.size()), [&](std::int64_t i) {
        const auto place = static_cast<std::size_t>(i);
        ++done[done.size() - 1 - place];
      });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 1000 * round);
    }
  }
}

TEST(EnsembleJobs, WhatAJobThrowsComesOutAndTheNextRoundRuns) {
  for (const int threads : {1, 3}) {
    Jobs jobs(threads);
    for (int round = 0; round < 20; ++round) {
      EXPECT_THROW(jobs.run(64,
                            [](std::int64_t i) {
                              if (i == 5) throw std::runtime_error("five");
                            }),
                   std::runtime_error);
      std::atomic<int> count = 0;
      jobs.run(10, [&](std::int64_t) { ++count; });
      EXPECT_EQ(count, 10);
    }
  }
}

TEST(EnsembleJobs, NoneIsFine) {
  Jobs(3).run(0, [](std::int64_t) { FAIL(); });
}

}  // namespace
}  // namespace asperity
