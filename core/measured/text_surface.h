// The three forms of surfaces in text tables: shared by the files text_*.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// What the columns of a table are, as far as their names or their numbers say. -1: there is none.
struct ColumnRoles {
  int x = -1, y = -1, z = -1;
  int validity = -1;
  bool validIsOne = true;      // 1 in the column of validity is a good point
  bool named = false;          // x or z were found by name
  std::size_t candidates = 0;  // columns that could be the heights as well as z
  std::vector<int> heights{};  // all that are neither positions, nor counts, nor validity
};

/// Roles by names, by the user's choice, and by the numbers. Columns are counted from 0.
ColumnRoles columnRoles(const TextBlock& block, const SurfaceSource& source);

/// Whether the column taken for positions, 0, 1, 2, ... or 1, 2, 3, ..., may number the points: it
/// has neither a unit nor the name of a position, and the user does not choose it.
bool mayNumberPoints(const TextBlock& block, const ColumnRoles& roles, const SurfaceSource& source);

/// "column 2 'z'", "column 2".
Message columnText(const TextBlock& block, int column);

/// A quantity of the header whose key is one of these, in lower case.
struct HeaderLength {
  double value = 0;
  std::optional<StatedUnit> unit{};
};
std::optional<HeaderLength> headerLength(const TextTable& table, const TextBlock& block,
                                         const std::vector<std::string>& keys);

/// The step between `count` points where the header has their number and the length from the first
/// to the last one, as MountainsMap writes it: "Axis X", 60, "59.00 um".
std::optional<HeaderLength> countedStep(const TextTable& table, const TextBlock& block,
                                        std::int64_t count, bool alongX);

/// Which entries of the header state a unit: those for positions or for heights, or "Unit", too.
enum class UnitEntries { Own, AndCommon };

/// The unit that an entry of the header states for positions or for heights.
std::optional<StatedUnit> headerUnit(const TextTable& table, const TextBlock& block, bool ofHeights,
                                     UnitEntries entries = UnitEntries::AndCommon);

/// What stands for a unit in the name of the column (-1: there is none) or in the header, and is
/// none that is known. Empty where there is nothing of the kind.
std::string unknownUnit(const TextTable& table, const TextBlock& block, int column, bool ofHeights);

/// The unit of a column by its name, else by the header. Throws InputError where it is no length
/// and the user says no other one.
std::optional<StatedUnit> columnUnit(const SurfaceSource& source, const TextTable& table,
                                     const TextBlock& block, int column, bool ofHeights);

SurfaceDraft readTextProfile(const TextTable& table, const TextBlock& block,
                             const SurfaceSource& source);
SurfaceDraft readTextMatrix(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);
SurfaceDraft readTextPoints(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source);

/// Whether the first two of three columns are the places of a grid.
bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles);

/// Whether first row and first column of a matrix hold positions.
bool hasPositionFrame(const TextBlock& block);

}  // namespace asperity
