// The first row of a measured profile: names of its columns, or a row of numbers gone wrong. Pure;
// any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// Whether the fields of a first row name columns: one at least has a letter, and none begins as a
/// number does or says that a value is missing.
bool namesColumns(std::span<const std::string_view> fields);

/// The unit other than metres that the name of a column gives: "mm" of "x (mm)", "height [mm]",
/// "z/mm", "z_mm" and "z mm". Empty where there is none.
std::string foreignUnitIn(std::string_view name);

/// Whether the field is one word with a unit in brackets or behind a stroke, as columns are named
/// in comments: "x (mm)", "z/um".
bool isWordWithUnit(std::string_view field);

}  // namespace asperity
