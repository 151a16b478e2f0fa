// The three forms of surfaces in text tables: profile, matrix and points.
#pragma once

#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"
#include "core/measured/text_columns.h"

namespace asperity {

SurfaceDraft readTextMatrix(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);
SurfaceDraft readTextPoints(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);

/// Sets the distances of the points of a field from the lines above its numbers.
void takeSpacings(const TextTable& table, const TextBlock& block, const SurfaceSource& source,
                  SurfaceDraft& draft);

/// Returns whether the first two of three columns are the positions of a grid.
bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles);

/// Returns whether the first row and the first column of a matrix hold positions.
bool hasPositionFrame(const TextBlock& block);

}  // namespace asperity
