// Finds which columns of a table belong together: one sweep, or several side by side, each with its
// temperature in the names, in a row above them or in a column of its own, or with its frequency in
// the names or above them. Pure; any thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/dma_units.h"

namespace asperity {

/// The columns of one sweep, or of all sweeps where the rows state the temperature; kNone: there is
/// none.
struct SweepColumns {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::map<DmaQuantity, std::size_t> indices{};
  std::optional<double> temperature{};  // K, where names or a row above the columns state it
  std::optional<double> frequency{};    // Hz, where names or a line above the columns state it

  std::size_t operator[](DmaQuantity quantity) const {
    const auto found = indices.find(quantity);
    return found == indices.end() ? kNone : found->second;
  }
  bool has(DmaQuantity quantity) const { return indices.contains(quantity); }
  bool hasModuli() const;
  bool isComplete() const;  // has a frequency, too
};

/// Returns the sweeps of a block that can be read; none where it is no table of moduli. Throws
/// InputError where columns of moduli would be left over or are not understood, or sweeps side by
/// side have no temperature. Adds the names of deviations and set values, which are not read, to
/// `leftOut`.
std::vector<SweepColumns> findSweeps(const DmaBlock& in, std::string& leftOut);

}  // namespace asperity
