#include "core/contact/kernels/nodal_group.h"

#include <algorithm>
#include <limits>

namespace asperity {
namespace {

StateSums stateOf(const NodalLaneSums& sums, std::size_t lane, double spacing) {
  StateSums state;
  state.depth = sums.depth[lane];
  state.stiffness = state.contactLength = sums.loaded[lane] * spacing;
  state.pressure = sums.pressure[lane];
  state.work = sums.work[lane];
  state.dissipation = sums.dissipation[lane];
  state.slopeSquared = sums.slopeSquared[lane];
  state.absoluteSlope = std::numeric_limits<double>::quiet_NaN();  // not gathered in lanes
  return state;
}

}  // namespace

bool NodalGroup::solve(std::span<const double> velocities, std::span<SteadyResult> results,
                       const LaneValues& guesses, const std::stop_token& stop) {
  const std::size_t used = velocities.size();
  if (load_.kind == LoadKind::Indentation) {
    for (std::size_t lane = 0; lane < used; ++lane)
      results[lane] = slideAtDepth(line_, at(velocities[lane]), load_.depth);
    return true;
  }
  const double load = load_.normalForce / (4 * conditions_.shearModulus);
  LaneValues depth{}, memory{};
  for (std::size_t lane = 0; lane < kMostLanes; ++lane)
    memory[lane] = velocities[std::min(lane, used - 1)] * conditions_.relaxationTime;
  for (std::size_t lane = 0; lane < used; ++lane)
    searches_[lane].start(load, line_.spacing, load / line_.length + line_.meanRise, guesses[lane]);
  while (look(depth, memory, used))
    if (stop.stop_requested()) return false;
  for (std::size_t lane = 0; lane < used; ++lane)
    results[lane] = resultOfNodal(line_, at(velocities[lane]), searches_[lane].answer());
  return true;
}

/// One pass for all searches that go on; false where none does.
bool NodalGroup::look(LaneValues& depth, const LaneValues& memory, std::size_t used) {
  Wanted wanted = Wanted::Force;
  bool open = false;
  for (std::size_t lane = 0; lane < used; ++lane) {
    if (searches_[lane].isDone()) continue;
    open = true;
    depth[lane] = searches_[lane].nextDepth();
    if (searches_[lane].wantsEverything()) wanted = Wanted::Everything;
  }
  if (!open) return false;
  for (std::size_t lane = used; lane < kMostLanes; ++lane) depth[lane] = depth[used - 1];
  nodalLanePass(line_, depth, memory, wanted, sums_);
  for (std::size_t lane = 0; lane < used; ++lane)
    if (!searches_[lane].isDone())
      searches_[lane].take({depth[lane], sums_.pressure[lane], sums_.loaded[lane],
                            sums_.threshold[lane], stateOf(sums_, lane, line_.spacing)});
  return true;
}

}  // namespace asperity
