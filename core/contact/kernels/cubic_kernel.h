// Steady passes of resolved_pass.h over one line of cubic segments, many at once: each lane of the
// machine's vectors goes along the line on its own pass. Whole blocks that need no look inside are
// taken in one step, lane by lane; contact edges, a segment of its own in each lane, are found in
// all lanes together. A lane that ends a pass begins the next at once, so that none waits for
// another. A pass may be cut where contact is certain, and its parts go in several lanes.
// Compiled for several instruction sets; the best one that the machine has is chosen at run time.
// Functions of their arguments; any thread. No allocation.
#pragma once

#include <cstddef>

#include "core/contact/kernels/pass_queue.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Passes under way at once, at most.
inline constexpr std::size_t kMostStreams = 16;

/// Passes under way at once, at most kMostStreams.
std::size_t streamCount();

/// Runs passes over a cubic line until no stream is given another.
void passLanes(const PreparedProfile& line, PassQueue& queue);

}  // namespace asperity
