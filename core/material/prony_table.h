// Reads a Prony series from a table of relaxation times and moduli, as people write it. Two of
// relaxation time, modulus and viscosity describe an arm, G_i = eta_i / tau_i; logarithms of them
// are read, too. Pure; any thread. Failure: InputError that names the file and the column.
#pragma once

#include <optional>
#include <string>

#include "core/base/text_table.h"
#include "core/material/prony_file.h"
#include "core/material/raw_series.h"

namespace asperity {

/// Returns nothing where the table is none of a Prony series.
std::optional<RawSeries> tableSeries(TextTable table, const std::string& name,
                                     const PronyChoices& choices);

}  // namespace asperity
