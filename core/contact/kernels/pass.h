// One steady pass over a prepared profile at one indentation: its request, its result, and its
// readable form, with which the vector kernels of kernels.h are compared. All sums are divided by
// 4G, so that they are lengths and areas only: multiply them by 4G (Pa) to get forces (N). Plain
// values, pure functions and an interface; a queue belongs to one run of passes and to its thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/statistics.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// What a pass computes. Force: only what a force balance needs.
enum class Output { Force, Everything };

/// Integrals over one period. The two ways to either force are summed independently, so that they
/// can be compared. Output::Force computes only `depth` and `stiffness` (nodal: only `pressure` and
/// `stiffness`).
struct PassSums {
  double depth = 0;          // m^2, integral of y = -u over all elements: F_N / 4G
  double stiffness = 0;      // m, derivative of `depth` with respect to the indentation
  double pressure = 0;       // m^2, integral of p over the contact: F_N / 4G again
  double work = 0;           // m^2, integral of p w' over the contact: F_x / 4G, Eq. (4)
  double dissipation = 0;    // m^2, c integral of y'^2 over all elements: F_x / 4G again
  double contactLength = 0;  // m
  double slopeSquared = 0;   // m, integral of z'^2 over the contact
  double gaps = 0;           // number, between contact spots; 0 where contact is complete
  // segments in which edges were computed: the cost of cubic passes
  double segmentsInspected = 0;
};

/// The value of a sum that a pass does not compute.
inline constexpr double kNotGathered = kNaN;

/// Shape of the elastomer at the nodes of a PreparedProfile, in order of travel.
struct NodeShape {
  std::vector<double> depth;     // m, y = -u
  std::vector<double> pressure;  // m, p / 4G, 0 where there is no contact
};

struct PassRequest {
  double depth = 0;             // m, indentation, > 0
  double relaxationLength = 0;  // m, c = v tau, >= 0
  // number of parts into which the pass may be cut, to run in several lanes
  int parts = 1;
};

/// The source of passes and the receiver of their sums.
class PassQueue {
 public:
  virtual ~PassQueue() = default;
  /// Gives the first pass of a stream, counted from 0; returns false where none is left.
  virtual bool begin(std::size_t stream, PassRequest& request) = 0;
  /// Takes the result of the stream's pass and gives its next one; returns false where none is
  /// left.
  virtual bool next(std::size_t stream, const PassSums& sums, PassRequest& request) = 0;
  /// Returns whether all passes have to end at once; it is called often, also inside passes.
  virtual bool isStopped() const = 0;
};

/// Runs one pass over a resolved line (linear or cubic segments) in steady sliding: the running
/// maximum with exponential decay of the paper's foundation, with every contact edge inside a
/// segment. O(n), no iteration, no time stepping.
///
/// Kelvin elements in the rigid line's frame, y = -u, c = v tau: in contact y = w(s) = d - z and
/// p / 4G = w + c w', z the height above the line's lowest point; free y decays as exp(-s / c).
/// Contact holds while (w e^(s/c))' > 0, so y e^(s/c) is the running maximum of w e^(s/c)
/// (Li et al. 2013, Eqs. 1 and 2, without a grid).
///
/// depth: indentation below the lowest point (m, > 0). relaxationLength: c = v tau
/// (m, >= 0). shape: filled if not null.
PassSums resolvedPass(const PreparedProfile& line, double depth, double relaxationLength,
                      Output output = Output::Everything, NodeShape* shape = nullptr);

}  // namespace asperity
