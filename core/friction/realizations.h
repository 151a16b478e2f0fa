// Every load and velocity on every realization of a scene's line: the work behind friction curves
// and the paper's figures. Realizations run on all threads; their results are handed over one
// realization after another in their own order, so sums of them have the same bits for any number
// of threads. Each line is made once. The first realization comes alone; the balances of all others
// start from its depths.
// Failure: std::runtime_error where a force balance is not met, with its place. Cancelling ends the
// work within one pass over a line.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

/// One load and its sliding velocities.
struct LoadCase {
  Load load;
  std::vector<double> velocities;  // m/s, ascending
};

struct RealizationTask {
  const Scene& scene;  // gives elastomer and scheme; load and sweep are those below
  const LineSource& source;
  std::span<const LoadCase> cases;
  std::int64_t first = 0;  // first realization
};

/// Called with the results of one realization: the velocities of the first case, of the second, ...
using TakeRealization = std::function<void(std::span<const SteadyResult> results)>;

/// Called on the calling thread between realizations, when all of `done` have been taken.
using BatchDone = std::function<void(std::int64_t done)>;

/// Slides `count` realizations from the first. threads: 0 means as many as the machine has. Returns
/// false where `stop` was requested; the realizations taken by then are the first ones of all.
bool slideRealizations(const RealizationTask& task, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone = {});

}  // namespace asperity
