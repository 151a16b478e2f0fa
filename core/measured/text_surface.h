// The three forms of surfaces in text tables: profile, matrix and points. The files text_*.cpp
// share this header.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// The meaning of the columns of a table, as far as it follows from their names or numbers; the
/// values are indices of columns, -1 where there is none.
struct ColumnRoles {
  int x = -1, y = -1, z = -1;
  int validity = -1;
  bool validIsOne = true;      // 1 in the column of validity is a good point
  bool named = false;          // x or z were found by name
  std::size_t candidates = 0;  // columns that could be the heights as well as z
  std::vector<int> heights{};  // all that are neither positions, nor counts, nor validity
};

/// Finds the roles by the names of the columns, by the user's choice, and by the numbers. Columns
/// are counted from 0.
ColumnRoles columnRoles(const TextBlock& block, const SurfaceSource& source);

/// Returns whether the column that was taken for positions, 0, 1, 2, ... or 1, 2, 3, ..., may be
/// the numbers of the points instead: it has neither a unit nor the name of a position, and the
/// user did not choose it.
bool mayNumberPoints(const TextBlock& block, const ColumnRoles& roles, const SurfaceSource& source);

/// Returns "column 2 'z'" or, without a name, "column 2".
Message columnText(const TextBlock& block, int column);

/// A length in the header of a file.
struct HeaderLength {
  double value = 0;
  std::optional<StatedUnit> unit{};
};
/// What a length is: the step between two points, or the extent of the whole field.
enum class LengthKind { Step, Extent };

/// Returns the length that the lines above the numbers state along an axis, 'x' or 'y', by its
/// usual names: "X increment: 0.5 um", "Breite: 10 um". A length of both axes counts for x alone,
/// and two lengths in a line, as "Scan size: 10 um x 20 um", for x and y.
std::optional<HeaderLength> headerLength(const TextTable& table, const TextBlock& block,
                                         LengthKind kind, char axis);

/// Returns the step between `count` points where the header states their number and the length from
/// the first to the last one: "Axis X", 60, "59.00 um", as MountainsMap writes it, or "Points: 60"
/// and "Traverse length: 59 um".
std::optional<HeaderLength> countedStep(const TextTable& table, const TextBlock& block,
                                        std::int64_t count, char axis);

/// Which entries of the header are searched for a unit: only those for positions or heights, or
/// also a common one such as "Unit".
enum class UnitEntries { Own, AndCommon };

/// Returns the unit that an entry of the header states for positions or for heights.
std::optional<StatedUnit> headerUnit(const TextTable& table, const TextBlock& block, bool ofHeights,
                                     UnitEntries entries = UnitEntries::AndCommon);

/// Returns the text in place of a unit, in the name of the column (-1: there is none) or in the
/// header, that is no known unit. Empty where there is no such text.
std::string unknownUnit(const TextTable& table, const TextBlock& block, int column, bool ofHeights);

/// Returns the unit of a column by its name, else by the header. Throws InputError where it is no
/// unit of length and the user chooses no other one.
std::optional<StatedUnit> columnUnit(const SurfaceSource& source, const TextTable& table,
                                     const TextBlock& block, int column, bool ofHeights);

/// The units that the corner of a matrix with positions in its first row and column states: "y\x
/// [um]", "Z [um] | X [mm] / Y [mm]", "mm".
struct CornerUnits {
  std::optional<StatedUnit> x{}, y{}, z{};
  std::string unknownPosition{}, unknownHeight{};
};
CornerUnits cornerUnits(const TextBlock& block);

SurfaceDraft readTextMatrix(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);
SurfaceDraft readTextPoints(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);

/// Returns whether the first two of three columns are the positions of a grid.
bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles);

/// Returns whether the first row and the first column of a matrix hold positions.
bool hasPositionFrame(const TextBlock& block);

}  // namespace asperity
