// Units of length as files write them. Pure; any thread.
#pragma once

#include <optional>
#include <string_view>

namespace asperity {

/// Returns the number of metres in one of this unit: "m", "mm", "\u00B5m", "um", "microns", "nm",
/// "\u00C5", "in", "mil", "1e-6 m", "10^-9 m", with or without brackets; letters large or small.
/// Empty where the text is no unit of length.
std::optional<double> metresPer(std::string_view unit);

}  // namespace asperity
