// What carries the load in regions III and IV of the curve, and where region IV begins. Used by
// velocity_figure.cpp only.
#pragma once

#include <vector>

#include "core/paper/figure_parts.h"

namespace asperity {

inline constexpr double kRegionClaimsCost = 3;

/// study: Fig. 2's. Runs small studies of its own, of kRegionClaimsCost in all.
std::vector<Claim> regionClaims(const Study& study, FigureWork& work);

}  // namespace asperity
