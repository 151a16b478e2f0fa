// A few velocities on the paper's elements, one in each lane: their searches share every pass.
// Private to core/contact. One thread; no allocation.
#pragma once

#include <array>
#include <span>
#include <stop_token>

#include "core/contact/kernels/lane_pass.h"
#include "core/contact/kernels/nodal_search.h"
#include "core/contact/steady_sliding.h"

namespace asperity {

class NodalGroup {
 public:
  NodalGroup(const PreparedProfile& line, const SlidingConditions& conditions, const Load& load)
      : line_(line), conditions_(conditions), load_(load) {}

  /// At most laneCount() velocities (m/s); guesses: depths nearby (m), or 0.
  /// False where `stop` was requested in between.
  bool solve(std::span<const double> velocities, std::span<SteadyResult> results,
             const LaneValues& guesses, const std::stop_token& stop);

 private:
  SlidingConditions at(double velocity) const {
    return {conditions_.shearModulus, conditions_.relaxationTime, velocity};
  }
  bool look(LaneValues& depth, const LaneValues& memory, std::size_t used);

  const PreparedProfile& line_;
  SlidingConditions conditions_;
  Load load_;
  NodalLaneSums sums_;
  std::array<NodalSearch, kMostLanes> searches_;
};

}  // namespace asperity
