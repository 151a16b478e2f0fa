// Prepares the columns of a text table for the reader of measured friction: names that blanks
// separate from one another and within themselves, units that only friction has, errors that stand
// in the cells of the values, and friction at several temperatures or loads side by side. Pure
// functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "core/base/text_table.h"

namespace asperity {

/// Gives names to columns whose line of names has blanks within the names as well, "velocity (mm/s)
/// mu normal force (mN)", of which the line nearest to the numbers is taken. Separates units such
/// as "(% of mu)" and "(10^-3)" from the names. The errors in the cells of the coefficient of
/// friction, "0.31 \u00B1 0.02", become a column after all others. Columns "mu 5 °C" and "mu 25
/// °C" become one with a row for each, and a column of their temperatures or loads.
void prepareColumns(TextBlock& block);

/// Returns whether some cells of a column have errors.
bool hasErrors(const std::vector<TextCell>& cells);

/// Returns whether some words of the line name a quantity.
bool namesQuantity(const std::string& line);

}  // namespace asperity
