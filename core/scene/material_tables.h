// The tables of a material: CSV with the columns of core/scene/columns.h. Pure functions.
#pragma once

#include <string>

#include "core/material/material_model.h"

namespace asperity {

/// One row for every measured point, in the order of temperature and frequency: what was measured,
/// where it lies on the master curve, and the Prony series there.
std::string isothermsCsv(const Material& material);

/// One row for every isotherm: its shift, from both moduli and from each alone, and by the fitted
/// formulas; how well it and the next warmer one overlap.
std::string shiftsCsv(const Material& material);

/// One row for every arm; the equilibrium modulus is the first row, without a relaxation time.
std::string pronyCsv(const Material& material);

}  // namespace asperity
