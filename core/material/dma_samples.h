// Recognizes tables that mix several samples or runs: rows of equal temperature, frequency and
// strain whose moduli differ clearly, of which a mean would be no rubber. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/isotherms.h"

namespace asperity {

/// The place in a file from which a measured row comes.
struct RowOrigin {
  const TextBlock* block;
  std::size_t row;

  std::uint32_t line() const { return block->lines[row]; }
  /// Returns the text or the number in a column.
  std::string field(std::size_t column) const;
};

/// Throws InputError where the rows are of several samples or runs; it names the column that tells
/// them apart, if there is one. Repeated runs of one sample scatter by 10 to 15 %, and the median
/// of many ratios by less. origins: of each row.
void refuseDifferentSamples(const std::vector<MeasuredModulus>& rows,
                            const std::vector<RowOrigin>& origins, const std::string& fileName);

}  // namespace asperity
