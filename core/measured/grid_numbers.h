// The numbers and positions around the heights of a grid: columns that number its columns and rows,
// as "row, col, z", and the first row and the first column of a matrix. Only the readers of text in
// this folder use it.
#pragma once

#include <optional>
#include <vector>

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

/// The first row and the first column where both hold positions.
struct MatrixFrame {
  bool hasColumn = false, hasRow = false;  // the row may be the names of the columns instead
  std::vector<double> x, y;
  std::optional<double> corner{};  // a number there, which means nothing
};

/// Finds the positions around a matrix. Where the corner is empty or a text, they have to be
/// uniform; beside a number in the corner, both are evenly spaced, and the rows and columns of
/// heights are not.
MatrixFrame readFrame(const TextBlock& block);

/// Whether the first row and the first column of a matrix number the points.
struct Numbering {
  bool row = false, column = false;
};

/// Finds numbers of the points around a matrix without positions. Throws InputError where it is not
/// clear whether the first row or column holds heights.
Numbering findNumbering(const TextBlock& block, const SurfaceSource& source);

/// Returns whether these are whole numbers, each larger by one than the one before.
bool countByOne(const std::vector<double>& numbers);

}  // namespace asperity
