// The pass of nodal_pass.h, of the paper's separate elements (Eqs. 2 to 4), for several velocities
// at once, one in each lane of a vector, all on the same line: whole blocks are taken in one step
// where every lane is free above them. Compiled for several instruction sets; the best one that the
// machine has is chosen at run time, here also for lane_stream.h.
// Pure functions; any thread. No allocation.
#pragma once

#include <array>
#include <cstddef>

#include "core/contact/line/prepared_profile.h"

namespace asperity {

inline constexpr std::size_t kMostLanes = 8;
using LaneValues = std::array<double, kMostLanes>;

/// Sums per 4G, a lane a velocity.
struct NodalLaneSums {
  LaneValues pressure{};  // m^2, over loaded elements: F_N / 4G
  LaneValues loaded{};    // number of loaded elements
  // Only where everything is wanted:
  LaneValues depth{};         // m^2, sum of y over all elements
  LaneValues work{};          // m^2, Eq. (4)
  LaneValues dissipation{};   // m^2
  LaneValues slopeSquared{};  // m
  LaneValues threshold{};     // m, largest indentation below which a loaded element is not loaded
};

enum class Wanted { Force, Everything };

enum class InstructionSet { Best, Scalar, Avx2, Avx512 };

/// Restricts the choice for the whole program, for tests and benchmarks; false: not on this
/// machine.
bool chooseInstructionSet(InstructionSet wanted);

/// The one in use, never Best.
InstructionSet instructionSet();
const char* nameOf(InstructionSet set);

/// Velocities in one pass, at most kMostLanes.
std::size_t laneCount();

/// depth (m, >= 0) and memory (m, >= 0) for laneCount() lanes.
void nodalLanePass(const PreparedProfile& line, const LaneValues& depth, const LaneValues& memory,
                   Wanted wanted, NodalLaneSums& sums);

}  // namespace asperity
