// Reads tables of dynamic moduli: frequency sweeps at several temperatures (one table with a column
// of temperatures, one block for each temperature, or one column for each), and ready master
// curves. The facts list what the reader found out by itself; a choice overrides each of these
// guesses.
// Pure; any thread. Failure: InputError that names the file and the line or column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/dma_facts.h"
#include "core/material/elastomer.h"
#include "core/material/isotherms.h"

namespace asperity {

/// What a user states about a file; what is empty is found by the reader. A column is given by its
/// name, or by its number from 1 on.
struct DmaChoices {
  std::string frequencyColumn, temperatureColumn, storageColumn, lossColumn, lossTangentColumn,
      magnitudeColumn, phaseColumn, strainColumn;
  std::string frequencyUnit, temperatureUnit, modulusUnit;
  ModulusKind modulus = ModulusKind::Unknown;
  double poissonRatio = 0.5;            // G = E / (2 (1 + nu))
  std::optional<double> temperature{};  // K, of a file that does not state one
};

struct DmaFile {
  std::vector<MeasuredModulus> rows;  // shear moduli in Pa, frequencies in Hz
  DmaFacts facts;
  std::optional<TemperatureShift> shift{};  // that the file states beside moduli at one temperature
};

/// Reads the moduli. name: of the file, in errors.
DmaFile readDmaFile(TextTable table, const std::string& name, const DmaChoices& choices);

/// Returns the index of the column that a member of DmaChoices names. Throws InputError (option)
/// where the block has no such column.
std::size_t columnNamed(const TextBlock& block, const std::string& wanted, const char* option);

}  // namespace asperity
