// Cells of text tables that hold more than a number: its error or its unit, "0.31 ± 0.02",
// "0.31(2)", "10 mm/s", or an imaginary part, "1.2e6+3.4e5i". Pure functions; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/statistics.h"
#include "core/base/text.h"

namespace asperity {

/// What a cell holds beside its number.
struct TextCell {
  std::string text{};       // the whole cell; empty where it has no more than a number
  std::string unit{};       // as written; empty where the cell has none
  double error = kNaN;      // in the unit of the number
  double imaginary = kNaN;  // of a complex number
};

/// The signs between a number and its error.
inline constexpr WordList kErrorSigns("\u00B1 +/- +-");

/// The two sides of such a sign.
struct ErrorSides {
  std::string_view number{}, error{};
};

/// Splits "0.31 \u00B1 0.02" at the sign. Nothing where there is none.
std::optional<ErrorSides> splitAtErrorSign(std::string_view text);

/// A number with its error, its unit or both.
struct CellQuantity {
  std::string_view digits{};  // the number as written
  double number = 0;
  TextCell rest{};
};

/// Reads "0.31 ± 0.02", "0.31 +/- 0.02", "(0.31 ± 0.02) N", "10 mm/s ± 5 %" and "0.31(2)", where
/// the digits in brackets count in the last place of the number, or "0.31(0.02)" (JCGM 100:2008,
/// 7.2.2), and complex numbers: "1.2+0.3i", "(1.2 - 0.3j) MPa", "1.2 + i*0.3", "(1.2, 0.3)".
/// Nothing where the text is anything else, a number alone, or in doubt: the error of "31 ± 2 %"
/// may be a share of the number, and one in brackets that exceeds it a mark of something else.
std::optional<CellQuantity> readCell(std::string_view text, char decimal);

/// Joins what blanks separate within cells: "0.31", "\u00B1", "0.02", "10", "mm/s" and "1.2", "+",
/// "0.3i". A unit of one letter may be a label, as in "0.31 C". The fields are parts of one line,
/// separated by blanks.
void joinCells(std::vector<std::string_view>& fields);

}  // namespace asperity
