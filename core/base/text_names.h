// Names of the columns of a text table and the units in them. Pure; any thread.
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

/// "x (mm)", "z/um", "Height [\u00B5m]", "freq_Hz", "x in mm", "x, mm", "x mm", "X_(microns)". In
/// round brackets, behind a stroke, a blank or "_" only a known unit counts; what stands in square
/// brackets at the end is a unit whatever it is.
ColumnName columnName(std::string_view text);

/// The fields of a line of names for `columns` columns, which may be separated otherwise than the
/// numbers: the first way of splitting it that gives so many, or else none. A unit behind a blank
/// stays with its name.
std::vector<std::string> splitNames(std::string_view line, const TextDialect& dialect,
                                    std::size_t columns);

}  // namespace asperity
