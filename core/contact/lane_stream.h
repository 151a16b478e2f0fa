// Steady passes of resolved_pass.h over one line, many at once: each lane of the machine's vectors
// goes along the line on its own pass. Whole blocks that need no look inside are taken in one step,
// lane by lane; contact edges, a segment of its own in each lane, are found in all lanes together.
// A lane that ends a pass begins the next at once, so that none waits for another. A pass may be
// cut where contact is certain, and its parts go in several lanes.
// Compiled for several instruction sets; the best one that the machine has is chosen at run time.
// Functions of their arguments; any thread. No allocation.
#pragma once

#include <cstddef>

#include "core/contact/travel_line.h"

namespace asperity {

/// Passes under way at once, at most.
inline constexpr std::size_t kMostStreams = 16;

/// Sums of one pass, per 4G, as in StateSums.
struct PassSums {
  double depth = 0;          // m^2, integral of y: F_N / 4G
  double stiffness = 0;      // m, its derivative with respect to the indentation
  double pressure = 0;       // m^2, over contact: F_N / 4G again
  double dissipation = 0;    // m^2, c integral of y'^2: F_x / 4G
  double contactLength = 0;  // m
  double slopeSquared = 0;   // m, integral of z'^2 over contact
  double looks = 0;          // segments that were looked into, which is what a pass costs
};

struct PassTask {
  double depth = 0;   // m, indentation, > 0
  double memory = 0;  // m, c = v tau, >= 0
  int parts = 1;      // to cut the pass into, where that can be done
};

/// Where passes come from and their sums go, for one run of passLanes and from its thread.
class PassQueue {
 public:
  virtual ~PassQueue() = default;
  /// The first pass of a stream, 0 to streamCount() - 1; false: nothing is left to do.
  virtual bool begin(std::size_t stream, PassTask& task) = 0;
  /// Takes what the stream's pass found and gives it the next one; false as above.
  virtual bool next(std::size_t stream, const PassSums& sums, PassTask& task) = 0;
  /// Asked often, inside passes too; true ends them all at once.
  virtual bool isStopped() const = 0;
};

/// Passes under way at once, at most kMostStreams.
std::size_t streamCount();

/// Runs passes over a resolved line until no stream is given another.
void passLanes(const TravelLine& line, PassQueue& queue);

}  // namespace asperity
