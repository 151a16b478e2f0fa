// Regions I to IV of a computed friction curve, for whoever draws one: decided from the curve
// itself by the rule of regions.h, and only where the curve shows them. Pure; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/curve_features.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// In order of velocity; those that begin or end beyond the curve end with it. Region I needs a
/// linear beginning, region III a maximum inside the curve or a flat end. None for bodies with more
/// than one relaxation time, which the paper's regions do not describe, and without friction.
std::vector<CurveRegion> regionsOfCurve(const Scene& scene, std::span<const CurvePoint> points);

/// "linear", "transition", "plateau", "decrease" for "I" to "IV"; empty for others.
std::string_view wordOfRegion(std::string_view name);

/// What happens in the region and how its borders were found, one sentence each.
std::string_view sentenceOfRegion(std::string_view name);

}  // namespace asperity
