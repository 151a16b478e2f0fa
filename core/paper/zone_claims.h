// The paper's statements about twenty forces: zones 1 and 2, their shift, their scaling, the line
// in contact. Used by forces_figure.cpp only.
#pragma once

#include <vector>

#include "core/paper/figure_parts.h"

namespace asperity {

inline constexpr double kZoneClaimsCost = 13;

/// Returns the claims. study: the paper's forces and velocities. It runs small studies of its own,
/// with the cost kZoneClaimsCost.
std::vector<Claim> zoneClaims(const Study& study, FigureWork& work);

}  // namespace asperity
