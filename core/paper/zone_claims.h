// What the paper says about twenty forces: zones 1 and 2, their shift, their scaling, the line in
// contact. Used by forces_figure.cpp only.
#pragma once

#include <vector>

#include "core/paper/figure_parts.h"

namespace asperity {

inline constexpr double kZoneClaimsCost = 13;

/// study: the paper's forces and velocities. Runs small studies of its own, of kZoneClaimsCost.
std::vector<Claim> zoneClaims(const Study& study, FigureWork& work);

}  // namespace asperity
