// The options of `asperity material`, which are the arguments of asperity.material() in Python and
// the controls of the page of the window, too: one table of them for all. Pure except for reading
// the file; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/material/material_model.h"

namespace asperity {

/// Options as they were written: {"--terms", "12"}; the value of a flag is "true".
using WrittenOptions = std::vector<std::pair<std::string, std::string>>;

/// Limits of Poisson's ratio and of the temperatures (K) of one isotherm.
inline constexpr double kMaxPoissonRatio = 0.5;
inline constexpr double kMinTemperatureTolerance = 0.001, kMaxTemperatureTolerance = 100;

/// Names of the options, in the order of the help.
std::span<const std::string_view> materialOptionNames();

/// Returns the choices of the options, each of which must be one of these names. The origin of the
/// material has the options in the given order, except its name and source. Throws InputError with
/// the name of the option.
MaterialChoices materialChoices(const WrittenOptions& options);

/// Reads a table of moduli, or a Prony series. Throws InputError.
Material readMaterial(const std::string& file, const MaterialChoices& choices);

}  // namespace asperity
