// The three forms of surfaces in text tables: profile, matrix and points.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/text_table.h"
#include "core/measured/grid_numbers.h"
#include "core/measured/surface_draft.h"
#include "core/measured/text_columns.h"

namespace asperity {

SurfaceDraft readTextMatrix(const SurfaceText& in);
SurfaceDraft readTextPoints(const SurfaceText& in);

/// Returns the columns that number the columns and the rows of a grid; nothing where there are
/// none.
std::optional<GridNumbers> gridNumbers(const SurfaceText& in, const ColumnRoles& roles);

/// Sets the distances of the points of a field from the lines above its numbers. areLines: a length
/// without an axis is that along the rows alone.
void takeSpacings(const SurfaceText& in, SurfaceDraft& draft, bool areLines = false);

/// Returns whether the first two of three columns are the positions of a grid.
bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles);

/// Returns whether a text begins with "ncols" and "nrows", as grids of ESRI do.
bool isEsriGrid(std::string_view bytes);

/// Returns a table of the rows that the header of a grid of ESRI states. Throws InputError where
/// the heights are fewer or more.
TextTable readEsriGrid(const SurfaceSource& source);

}  // namespace asperity
