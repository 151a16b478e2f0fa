// The arms of a Prony series in the rows of a table. Two of relaxation time, modulus and viscosity
// describe an arm, G_i = eta_i / tau_i; logarithms of them are read, too. Pure; any thread.
// Failure: InputError that names the file and the column or line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/prony_file.h"
#include "core/material/prony_names.h"
#include "core/material/raw_series.h"

namespace asperity {

/// What the rows of a table hold. Weights are in the unit of the series.
struct SeriesRows {
  TextColumn column{};  // of the weights, with their unit
  PartsOf parts = PartsOf::Unknown;
  std::vector<double> weights{}, times{};      // times in s; NaN: a row has none
  double equilibrium = RawSeries::kNotStated;  // of the row without a relaxation time
  double sum = 0, most = 0;                    // of the weights of the other rows
};

/// Reads the arms of a block into the terms of a series, with notes on what was computed, assumed
/// and left out; nothing where the block has none. The names and numbers of the table are changed:
/// logarithms are undone. Throws InputError where the block has a part of a series.
std::optional<SeriesRows> readArms(TextTable& table, TextBlock& block, const std::string& name,
                                   const PronyChoices& choices, RawSeries& series);

/// Returns the size of a unit of modulus in Pa; what stands after it in a header does not count:
/// "3 MPa (at 20 °C)". Throws InputError (`name`, `key`) where it is none.
double modulusSize(const std::string& unit, const std::string& name, const std::string& key);

}  // namespace asperity
