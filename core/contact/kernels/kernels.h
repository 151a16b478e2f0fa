// The passes that are compiled for several instruction sets, of which the best one of the machine
// is chosen at run time. core/contact/steady_sweep.cpp chooses among the passes by the scheme of
// the line. Results agree with the readable resolvedPass to rounding, and differ in the last
// digits between instruction sets. Functions of their arguments; any thread. No allocation.
#pragma once

#include <array>
#include <cstddef>

#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

// ---- Resolved lines

/// Maximum number of passes over a cubic line that run at once.
inline constexpr std::size_t kMaxStreams = 16;

/// Runs passes over a line of cubic segments until no stream gets another one. Each lane of the
/// vectors follows the line on its own pass. Whole blocks without contact edges are taken in one
/// step, lane by lane; contact edges, each in a segment of its lane, are computed in all lanes
/// together. A lane that ends a pass begins the next at once, so that none waits for another. A
/// pass may be cut where contact is certain, and its parts run in several lanes.
void runCubicPasses(const PreparedProfile& line, PassQueue& queue);

/// Runs the passes of the queue's stream 0 over a line of straight segments, one after another,
/// until there is no other. Such a line need not be followed from edge to edge. Let w be the depth
/// of the line in the elastomer: w exp(s/c) rises with s where the pressure p is above 0 and falls
/// where it is below; for a free surface it is constant. So the line is in contact exactly where w
/// exp(s/c) is higher than anywhere before. Its summits, where p falls through 0, are found many at
/// a time. One scan finds those that exceed all earlier ones; only these have edges of contact,
/// which are then separate from each other and are computed many at a time as well.
void runLinearPasses(const PreparedProfile& line, PassQueue& queue);

// ---- The paper's separate elements at the nodes, Eqs. (2) to (4)

/// The result of a pass over separate elements at an indentation. The contact set only grows with
/// the indentation, so F_N(d) rises, but it jumps wherever an element enters.
struct NodalState {
  double depth = 0;   // m, the indentation
  double loaded = 0;  // number of elements that carry load
  // m, largest indentation at which one of the loaded elements is not yet loaded
  double threshold = 0;
  PassSums sums;  // stiffness is that of the loaded elements
};

/// Runs one pass in one lane. depth: indentation below the lowest node (m; below 0 nothing
/// touches). relaxationLength: c = v tau (m, >= 0). shape: filled if not null. The same bits on
/// every instruction set.
NodalState nodalPass(const PreparedProfile& line, double depth, double relaxationLength,
                     NodeShape* shape = nullptr);

inline constexpr std::size_t kMaxLanes = 8;
using LaneValues = std::array<double, kMaxLanes>;

/// Returns the number of velocities in one pass of nodalLanePass, at most kMaxLanes.
std::size_t laneCount();

/// Runs the same pass for laneCount() velocities at once, one in each lane of a vector: depth (m,
/// >= 0) and relaxationLength (m, >= 0) for each. Output::Force: `threshold` and most sums are
/// missing.
void nodalLanePass(const PreparedProfile& line, const LaneValues& depth,
                   const LaneValues& relaxationLength, Output output,
                   std::array<NodalState, kMaxLanes>& states);

// ---- The instruction set

enum class InstructionSet { Best, Scalar, Avx2, Avx512 };

/// Restricts the choice for the whole program, for tests and benchmarks; returns false where this
/// machine lacks it.
bool chooseInstructionSet(InstructionSet wanted);

/// Returns the instruction set in use, never Best.
InstructionSet instructionSet();
const char* instructionSetName(InstructionSet set);

}  // namespace asperity
