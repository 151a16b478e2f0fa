// Every load and velocity on every realization of a scene's line: the work behind friction curves
// and the paper's figures. Realizations run on all threads; their results are handed over one
// realization after another in their own order, so whatever is summed from them has the same bits
// for any number of threads. Each line is made once. The first one comes alone, and its depths are
// where the balances of all others begin.
// Failure: std::runtime_error where a force balance is not met, with where it was. Cancelling ends
// the work within one pass over a line.
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

/// One load and the velocities to slide at under it.
struct LoadCase {
  Load load;
  std::vector<double> velocities;  // m/s, ascending
};

struct RealizationTask {
  const Scene& scene;  // its elastomer and scheme; load and sweep are those below
  const LineSource& source;
  std::span<const LoadCase> cases;
  std::int64_t first = 0;  // realization to begin with
};

/// Of one realization: the velocities of the first case, of the second, ...
using TakeRealization = std::function<void(std::span<const SteadyResult> results)>;

/// Called on the calling thread between realizations, where all of `done` have been taken.
using BatchDone = std::function<void(std::int64_t done)>;

/// Slides `count` realizations from the first. threads: 0 for as many as the machine has. Returns
/// false where `stop` was requested; the realizations taken by then are a first part of all.
bool slideRealizations(const RealizationTask& task, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone = {});

}  // namespace asperity
