// The strain amplitudes of measured moduli: filled rubber is softer the more it is strained (Payne
// effect), so that a master curve is of one amplitude. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/isotherms.h"

namespace asperity {

/// "1%", "0.01": a part of the length. Nothing where it is none above 0.
std::optional<double> parseStrain(std::string_view text);

/// Keeps the rows of the chosen amplitude, if one is chosen, and returns the median of what is
/// left; NaN where no row states one. Amplitudes within a fifth of each other are one; those of
/// other temperatures or frequencies may differ. Throws InputError (`name`) where sweeps at one
/// temperature (within `tolerance`, K) were measured at several amplitudes and none is chosen, and
/// (--strain) where none is like the chosen one.
double chooseStrain(std::vector<MeasuredModulus>& rows, std::optional<double> chosen,
                    double tolerance, const std::string& name);

}  // namespace asperity
