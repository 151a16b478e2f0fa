// Which columns of a text table are the positions, the heights and the validity of a surface, by
// their names, their numbers and the user's choice. Only the readers of text in this folder use it.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

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

/// Returns a column by its index, which is not -1.
inline const TextColumn& columnAt(const TextBlock& block, int column) {
  return block.columns[static_cast<std::size_t>(column)];
}

/// Returns whether a column numbers the profiles that follow each other, by its name and its
/// numbers: "Profile", "Track no.".
bool numbersProfiles(const TextBlock& block, std::size_t column);

/// The columns of several profiles side by side.
struct ProfileColumns {
  std::vector<int> whole{};    // with heights in the first and the last row
  std::vector<int> leftOut{};  // without
};

/// Returns the columns of heights in one unit whose names differ in a number alone, as "Profile 1
/// (um)" and "Profile 2 (um)". Without whole ones where there are not several, where the first one
/// is not whole, or where the user chose a column.
ProfileColumns profilesSideBySide(const TextBlock& block, const ColumnRoles& roles,
                                  const SurfaceSource& source);

/// Returns whether the positions in a column are in pixels: they number the points.
bool isInPixels(const TextColumn& column);

/// Returns whether the column that was taken for positions, 0, 1, 2, ... or 1, 2, 3, ..., may be
/// the numbers of the points instead: it is in pixels, or it has neither a unit nor the name of a
/// position, and the user did not choose it.
bool mayNumberPoints(const TextBlock& block, const ColumnRoles& roles, const SurfaceSource& source);

/// Returns "column 2 'z'" or, without a name, "column 2".
Message columnText(const TextBlock& block, int column);

/// Returns whether a name in lower case is one of heights: "z", "height (um)", "profil".
bool isHeightName(std::string_view name);

/// Returns whether a name in lower case is one of positions along a line: "x", "distance (mm)".
bool isPositionName(std::string_view name);

/// Returns whether a name in lower case is one of positions across the lines of a field: "y".
bool isRowName(std::string_view name);

}  // namespace asperity
