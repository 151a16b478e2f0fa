// Reads tables of dynamic moduli: frequency sweeps at several temperatures (one table with a column
// of temperatures, a block for each temperature, or a column for each), and ready master curves.
// Whatever the reader finds out by itself stands in the facts and can be overridden by a choice.
// Pure; any thread. Failure: InputError that names the file and the line or column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"

namespace asperity {

/// What a user says about a file; empty: found. A column is its name, or its number from 1 on.
struct DmaChoices {
  std::string frequencyColumn, temperatureColumn, storageColumn, lossColumn, lossTangentColumn,
      magnitudeColumn, phaseColumn, strainColumn;
  std::string frequencyUnit, temperatureUnit, modulusUnit;
  ModulusKind modulus = ModulusKind::Unknown;
  double poissonRatio = 0.5;            // G = E / (2 (1 + nu))
  std::optional<double> temperature{};  // K, of a file that does not state one
};

/// How a column was read.
struct DmaColumnFact {
  std::string name;  // as in the file, or "column 3"
  std::string unit;  // as in the file or chosen
  bool isUnitAssumed = false;
};

struct DmaFacts {
  DmaColumnFact frequency, storage, loss;
  std::string temperature;  // the column's name, or where the temperatures come from
  ModulusKind modulus = ModulusKind::Shear;
  bool isReduced = false;        // frequencies are shifted to one temperature already
  std::size_t leftOut = 0;       // rows without a value
  std::string leftOutColumns{};  // names of deviations and set values, which are not read
  bool isMarkUnclear = false;    // the decimal mark may separate thousands, too
  char decimal = '.';
};

struct DmaFile {
  std::vector<MeasuredModulus> rows;  // shear moduli in Pa, frequencies in Hz
  DmaFacts facts;
};

/// `name` stands for the file in errors.
DmaFile readDmaFile(TextTable table, const std::string& name, const DmaChoices& choices);

/// As DmaChoices::...Column say it; throws InputError (option) where the block has no such column.
std::size_t columnNamed(const TextBlock& block, const std::string& wanted, const char* option);

}  // namespace asperity
