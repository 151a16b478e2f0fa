// How passes over a resolved line are asked for, and what they find. Plain values and an interface;
// a queue belongs to one run of passes and its thread.
#pragma once

#include <cstddef>

namespace asperity {

/// Sums of one pass, per 4G, as in StateSums.
struct PassSums {
  double depth = 0;          // m^2, integral of y: F_N / 4G
  double stiffness = 0;      // m, its derivative with respect to the indentation
  double pressure = 0;       // m^2, over contact: F_N / 4G again
  double dissipation = 0;    // m^2, c integral of y'^2: F_x / 4G
  double contactLength = 0;  // m
  double slopeSquared = 0;   // m, integral of z'^2 over contact
  double segmentsInspected =
      0;  // segments that were looked into, which is what a pass in lanes costs
};

struct PassRequest {
  double depth = 0;   // m, indentation, > 0
  double memory = 0;  // m, c = v tau, >= 0
  int parts = 1;      // to cut a pass in lanes into, where that can be done
};

/// Where passes come from and their sums go.
class PassQueue {
 public:
  virtual ~PassQueue() = default;
  /// The first pass of a stream, counted from 0; false: nothing is left to do.
  virtual bool begin(std::size_t stream, PassRequest& task) = 0;
  /// Takes what the stream's pass found and gives it the next one; false as above.
  virtual bool next(std::size_t stream, const PassSums& sums, PassRequest& task) = 0;
  /// Asked often, inside passes too; true ends them all at once.
  virtual bool isStopped() const = 0;
};

}  // namespace asperity
