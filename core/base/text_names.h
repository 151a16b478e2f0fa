// The names of the columns of a text table and the units in them. Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_dialect.h"

namespace asperity {

struct ColumnName {
  std::string name{};  // without the unit
  std::string unit{};  // as written, without brackets; empty where there is none
};

/// Separates a name and its unit: "x (mm)", "z/um", "Height [\u00B5m]", "freq_Hz", "x in mm", "x,
/// mm", "x mm", "X_(microns)". In round brackets, behind a stroke, a blank or "_" only a known unit
/// counts; the text in square brackets at the end is always a unit.
ColumnName columnName(std::string_view text);

/// Splits a line of names for `columns` columns. The names may be separated differently from the
/// numbers: the first separator that gives this number of names is used; none where there is no
/// such separator. A unit behind a blank stays with its name.
std::vector<std::string> splitNames(std::string_view line, const TextDialect& dialect,
                                    std::size_t columns);

}  // namespace asperity
