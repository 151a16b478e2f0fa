// The tables of a material: CSV with the columns of core/scene/columns.h. Pure functions.
#pragma once

#include <string>

#include "core/material/material_model.h"

namespace asperity {

/// Returns one row for every measured point, in the order of temperature and frequency: the
/// measured values, their position on the master curve, and the Prony series there.
std::string isothermsCsv(const Material& material);

/// Returns one row for every isotherm: its shift, from both moduli and from each alone, and by the
/// fitted formulas; and the overlap with the next warmer isotherm.
std::string shiftsCsv(const Material& material);

/// Returns one row for every arm; the first row is the equilibrium modulus, without a relaxation
/// time.
std::string pronyCsv(const Material& material);

}  // namespace asperity
