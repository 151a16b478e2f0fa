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

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/elastomer.h"
#include "core/material/isotherms.h"
#include "core/material/stated_temperature.h"

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

/// How a column was read.
struct DmaColumnFact {
  std::string name;  // as in the file, or "column 3"
  std::string unit;  // as in the file or chosen
  bool isUnitAssumed = false;

  bool operator==(const DmaColumnFact&) const = default;
};

struct DmaFacts {
  DmaColumnFact frequency, storage, loss;
  DmaColumnFact temperature;                  // without a name where each sweep has one temperature
  std::optional<HeaderTemperature> stated{};  // where a line above the table states it
  std::size_t sweeps = 0;        // tables that were read; the columns are those of the last one
  bool hasOtherColumns = false;  // whether other sweeps have other columns or units
  ModulusKind modulus = ModulusKind::Shear;
  bool isReduced = false;        // frequencies are shifted to one temperature already
  std::size_t leftOut = 0;       // rows without a value
  std::string leftOutColumns{};  // names of deviations and set values, which are not read
  bool isMarkUnclear = false;    // the decimal mark may separate thousands, too
  char decimal = '.';
  std::vector<Message> notes{};  // contradictions, and what was read or left out beside the table
};

/// Returns which columns were read in which units, and the notes, one line each.
std::vector<Message> factsOf(const DmaFacts& facts);

struct DmaFile {
  std::vector<MeasuredModulus> rows;  // shear moduli in Pa, frequencies in Hz
  DmaFacts facts;
  std::optional<TemperatureShift> shift{};  // that the file states beside moduli at one temperature
};

/// Reads the moduli. name: of the file, in errors.
DmaFile readDmaFile(TextTable table, const std::string& name, const DmaChoices& choices);

}  // namespace asperity
