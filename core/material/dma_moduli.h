// How two columns of a sweep become storage and loss modulus of shear: which two, in which units,
// of shear or of tension, and which other columns contradict them. Pure; any thread. Failure:
// InputError that names the file and the column.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/message.h"
#include "core/material/dma_sweeps.h"
#include "core/material/dma_units.h"

namespace asperity {

/// Two quantities from which both moduli follow.
struct MeasuredPair {
  DmaQuantity first, second;
  DynamicModulus (*combine)(double first, double second);
};

/// Returns the pair that is read from these columns: storage and loss modulus themselves where the
/// table has both; null where no pair is complete.
const MeasuredPair* measuredPair(const SweepColumns& columns);

/// Leaves out viscosities and compliances where moduli are complete, and compliances where
/// viscosities are: their columns get no quantity. Where nothing is complete, moduli stay.
void chooseForm(std::vector<DmaColumn>& found);

/// The columns that are read as moduli. The sizes turn their numbers into those of shear in SI
/// units, and into a loss factor or an angle in radians.
struct ModulusColumns {
  std::size_t first = 0, second = 0;
  double firstSize = 1, secondSize = 1;
  bool isFirstViscosity = false, isSecondViscosity = false;  // to be multiplied by omega
  bool areCompliances = false;
  const MeasuredPair* pair = nullptr;
  DmaColumnFact storage{}, loss{};  // how they were read
  ModulusKind kind = ModulusKind::Shear;
  std::vector<Message> notes{};  // what states the kind, and what contradicts the moduli

  /// Returns the moduli of shear at a frequency (Hz) from the numbers of both columns in SI units.
  /// A modulus is 0 where the magnitude is no more than its other part.
  DynamicModulus at(double hertz, double one, double other) const;
};

/// Returns the columns from which the moduli of a sweep are read, which has such a pair. Throws
/// InputError where their units or their kind are unclear.
ModulusColumns findModulusColumns(const DmaBlock& in, const SweepColumns& columns);

}  // namespace asperity
