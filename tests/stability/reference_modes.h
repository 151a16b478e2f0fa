// How an element with arms creeps back where nothing touches it, in the widest numbers of the
// machine: the independent exponentials of core/contact/arms/retardation.h, found once more. Pure.
#pragma once

#include <vector>

#include "core/material/element_law.h"
#include "tests/stability/reference_line.h"

namespace asperity {

/// y = sum of a_j exp(-rate_j s), with a_j = settled_j y - sum ofCreep_ji e_i where it begins; then
/// q_i = y - e_i = sum toCreep_ji a_j and e_i = sum toStrain_ji a_j.
struct ReferenceMode {
  Wide rate;     // 1/m of the way slid
  Wide settled;  // also the inverse of the spring that draws it back, per G
  std::vector<Wide> ofCreep, toCreep, toStrain;
};

/// law: with an equilibrium modulus and arms; velocity > 0 (m/s).
std::vector<ReferenceMode> referenceModes(const ElementLaw& law, Wide velocity);

}  // namespace asperity
