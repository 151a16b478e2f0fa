// The strain amplitudes of measured moduli. Filled rubber is softer the more it is strained (Payne
// effect), so a master curve belongs to one amplitude. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/isotherms.h"

namespace asperity {

/// Reads a strain, "1%" or "0.01"; nothing where the text is no number above 0.
std::optional<double> parseStrain(std::string_view text);

/// Keeps the rows of the chosen amplitude, if one is chosen, and returns the median of the
/// remaining ones; NaN where no row states one. Amplitudes within a fifth of each other count as
/// equal; those at other temperatures or frequencies may differ. Throws InputError (`name`) where
/// sweeps at one temperature (within `tolerance`, K) were measured at several amplitudes and none
/// is chosen, and (--strain) where no amplitude is close to the chosen one.
double chooseStrain(std::vector<MeasuredModulus>& rows, std::optional<double> chosen,
                    double tolerance, const std::string& name);

}  // namespace asperity
