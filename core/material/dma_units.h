// The units of the columns of a table of dynamic moduli: those that a user chooses, else those of
// the file, else one that is assumed and named as such. Pure; any thread. Failure: InputError that
// names the file and the column.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/base/units.h"
#include "core/material/dma_file.h"

namespace asperity {

/// A block of the table of a file, with what the user states about it.
struct DmaBlock : TextPart {
  const std::string& fileName;
  const DmaChoices& choices;
};

/// A column and the size of its unit in the SI unit.
struct SizedColumn {
  DmaColumnFact fact;
  double size = 1;
};

/// Frequencies are in Hz where neither file nor user states a unit, or in rad/s by their name.
SizedColumn frequencyColumn(const DmaBlock& in, std::size_t column);

/// Moduli without a unit are in Pa, viscosities in Pa s, and compliances in 1/Pa; with a chosen
/// unit of moduli, viscosities are in it times s, and compliances in one over it.
SizedColumn modulusColumn(const DmaBlock& in, std::size_t column);

/// A loss factor has no unit, or %; the fact has its name alone.
SizedColumn lossTangentColumn(const DmaBlock& in, std::size_t column);

/// Returns the size of the unit of a loss factor; nothing where the column has another unit.
std::optional<double> lossTangentSize(const DmaBlock& in, std::size_t column);

/// Angles without a unit are degrees where they exceed a right angle in radians.
SizedColumn phaseColumn(const DmaBlock& in, std::size_t column);

struct TemperatureColumn {
  DmaColumnFact fact;
  Unit unit;
  std::optional<Message> note{};  // where degrees look like kelvins
};

/// Temperatures without a unit are kelvins where all are above 200: no rubber is hotter in °C.
TemperatureColumn temperatureColumn(const DmaBlock& in, std::size_t column);

/// Returns the strain in one row of a column as a ratio; NaN where the row states none.
double strainAt(const DmaBlock& in, std::size_t row, std::size_t column);

}  // namespace asperity
