// Finds the two columns of a text table that number the columns and the rows of a grid: "row, col,
// z", "i, j, z", "pixel_x; pixel_y; height". Only the readers of text in this folder use it.
#pragma once

#include <optional>

#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"
#include "core/measured/text_columns.h"

namespace asperity {

/// The columns of the table, counted from 0, that hold the number of the column of a point, the
/// number of its row, and its height.
struct GridNumbers {
  int column = 0, row = 1, height = 2;
};

/// Returns the columns that number the points of a grid: both hold consecutive whole numbers, and
/// each pair occurs once, or their names say so. Numbers without a name count only where
/// `isStepKnown`; numbers named as positions, such as "x" and "y", never do.
std::optional<GridNumbers> findGridNumbers(const TextBlock& block, const ColumnRoles& roles,
                                           const SurfaceSource& source, bool isStepKnown);

}  // namespace asperity
