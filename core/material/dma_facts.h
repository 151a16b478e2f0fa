// What the reader of dynamic moduli found out by itself: columns, units, and columns that
// contradict each other. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/stated_temperature.h"

namespace asperity {

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

/// Returns the note on a table that also has moduli of the kind that is not read, with their ratio.
/// storage: the column that is read, which is of this kind; poisson: Poisson's ratio.
std::optional<Message> otherKindNote(const TextBlock& block, std::size_t storage, ModulusKind kind,
                                     double poisson);

/// The columns of both moduli and of the loss factor, and their units.
struct LossFactorColumns {
  std::size_t storage, loss, tangent;
  double storageSize, lossSize, tangentSize;
};

/// Returns the note on a loss factor that contradicts the moduli, by more than a tenth in the
/// median.
std::optional<Message> lossFactorNote(const TextBlock& block, const LossFactorColumns& columns);

/// Returns the column's name, or "column 3".
std::string columnLabel(const TextBlock& block, std::size_t column);

}  // namespace asperity
