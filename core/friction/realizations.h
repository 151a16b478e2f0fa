// Every load and velocity on every realization of a scene's line: the work behind friction curves
// and the paper's figures. Realizations run on all threads; their results are handed over one
// realization after another in their own order, so sums of them have the same bits for any number
// of threads. Each line is made once. The first realization comes alone; the balances of all others
// start from its depths.
// Failure: std::runtime_error where a force balance is not met, which names the velocity and the
// realization. Cancelling ends the work within one pass over a line.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <utility>
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

/// Returns the case of a constant normal force (N).
inline LoadCase atForce(double normalForce, std::vector<double> velocities) {
  return {{LoadKind::Force, normalForce, 0}, std::move(velocities)};
}

/// What slides on each line: the elastomer and the interface of a scene, at some loads and
/// velocities.
struct RealizationPart {
  const Scene& scene;  // its load and its sweep do not count
  std::span<const LoadCase> cases;
  /// Whether depths found at one force are where the search at the next one begins. It changes the
  /// cost and the last digits within the residual; all cases must have the same velocities.
  bool sharesForces = false;
  bool beginsChunk = true;  // false: slid by the same thread as the part before it
};

/// One or more parts of one scheme on the same lines. Each line is made once for as many parts as a
/// thread slides together.
struct RealizationWork {
  const LineSource& source;
  std::span<const RealizationPart> parts;
  std::int64_t first = 0;  // first realization

  Scheme scheme() const { return parts.front().scene.accuracy.scheme; }
};

/// Called with the results of one realization: the velocities of the first case, of the second, ...
/// of the first part, of the second, ...
using TakeRealization = std::function<void(std::span<const SteadyResult> results)>;

/// Called on the calling thread between realizations, when all of `done` have been taken.
using BatchDone = std::function<void(std::int64_t done)>;

/// Slides `count` realizations from the first. threads: 0 means as many as the machine has. Returns
/// false where `stop` was requested; the realizations taken by then are the first ones of all.
bool slideRealizations(const RealizationWork& work, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone = {});

}  // namespace asperity
