// Friction against the short-wave cut-off as a sheet and as tables. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "core/friction/short_wave_cutoff.h"

namespace asperity {

/// Returns the friction of the lines without the waves below lambda_c, and below it the part of all
/// friction that each decade of wavelengths makes.
DiagramSheet cutoffSheet(const Scene& scene, const std::vector<CutoffPoint>& points);

std::string cutoffCsv(const std::vector<CutoffPoint>& points);
std::string cutoffJson(const Scene& scene, const std::vector<CutoffPoint>& points);

}  // namespace asperity
