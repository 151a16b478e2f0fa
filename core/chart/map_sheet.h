// A parameter map as a sheet: the quantity as colours with contour lines, the borders of the
// regions of the friction curve, and a cross at the scene's own state; and a cut through it as a
// curve. Pure; any thread.
#pragma once

#include <string_view>

#include "core/chart/diagram.h"
#include "core/friction/parameter_map.h"

namespace asperity {

/// Identifies the series of region borders under the pointer.
inline constexpr int kRegionBorder = 1;

/// Returns the map of a quantity (isMapQuantity). A picture needs 2 different values of each
/// parameter.
///
/// Regions I to IV are those of the friction curve at each value of the other parameter
/// (curve_regions.h), so their borders are drawn where one side of the map is the velocity and the
/// curve shows them; elsewhere, where single summits carry the load, F_N/(4 eta v) = 0.1 h, which
/// is the border of region IV by Li et al. (2013).
DiagramSheet mapSheet(const ParameterMap& map, std::string_view quantity);

/// Returns "coefficient of friction \u03BC" of a quantity.
Message mapQuantityTitle(std::string_view quantity);

/// Returns the quantity along one parameter at the scene's own value of the other one, from the
/// row or column of the map that is nearest to it.
Diagram mapCut(const ParameterMap& map, std::string_view quantity, bool alongX);

}  // namespace asperity
