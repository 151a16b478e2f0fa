// What a study costs beyond the kernel and the making of lines: points, states, means, the store.
// Threading: the main thread, one thread of work.
#pragma once

#include <cstdint>

namespace asperity::bench {

struct StudyCost {
  std::int64_t simulations = 0;
  double runSeconds = 0;     // of the whole run into a store
  double kernelSeconds = 0;  // of the same balances on the same lines alone
  double tableSeconds = 0;   // of writing all rows as CSV

  double perSimulation() const {
    return (runSeconds - kernelSeconds) / static_cast<double>(simulations);
  }
  double rowsPerSecond() const { return static_cast<double>(simulations) / tableSeconds; }
};

/// Light simulations: N = 1000, one line, one velocity, force and velocity varied on a grid.
StudyCost measureStudyCost(bool quick);

}  // namespace asperity::bench
