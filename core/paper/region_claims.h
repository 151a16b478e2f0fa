// Claims on what carries the load in regions III and IV of the curve, and on the beginning of
// region IV. Used by velocity_figure.cpp only.
#pragma once

#include <vector>

#include "core/paper/figure_parts.h"

namespace asperity {

inline constexpr double kRegionClaimsCost = 3;

/// Returns the claims. study: Fig. 2's. It runs small studies of its own, with a total cost of
/// kRegionClaimsCost.
std::vector<Claim> regionClaims(const Study& study, FigureWork& work);

}  // namespace asperity
