// The units of numbers that stand below the head of their column: in the cells, "10 mm/s", or in a
// column of their own. Pure; any thread.
// Failure: InputError that names the file, the row and the column.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/text_table.h"

namespace asperity {

/// Expresses the numbers of each column, without their errors, in one unit, that of the column: a
/// unit that all cells share or, where they have several units of one quantity, the SI unit. Throws
/// InputError, with the name of the file, where some cell has none, or a unit of another quantity.
void unifyUnits(TextBlock& block, const std::string& name);
/// Does so in one column.
void unifyUnits(TextBlock& block, std::size_t column, const std::string& name);

/// Returns whether the texts of a column are the units of the numbers before it by its name.
bool isNameOfUnits(const TextColumn& column);

/// Gives the units in a column of their own to the column before it, where this is the only one of
/// numbers that they can belong to: "v;unit;mu" above "10;mm/s;0.6". Throws InputError where they
/// differ, except in a list of names and numbers.
void takeColumnsOfUnits(TextBlock& block, const std::string& name);

}  // namespace asperity
