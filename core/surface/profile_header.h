// Tells the names of columns in the first row of a profile from a damaged row of numbers, and finds
// units in them, which must be metres. Pure functions; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// Returns whether the fields of a first row are names of columns: at least one has a letter, and
/// none begins like a number or stands for a missing value.
bool namesColumns(std::span<const std::string_view> fields);

/// Returns the unit other than metres in the name of a column: "mm" of "x (mm)", "height [mm]",
/// "z/mm", "z_mm" and "z mm". Empty where there is none.
std::string foreignUnitIn(std::string_view name);

/// Returns whether the field is one word with a unit in brackets or after a slash, as in the
/// names of columns in comments: "x (mm)", "z/um".
bool isWordWithUnit(std::string_view field);

}  // namespace asperity
