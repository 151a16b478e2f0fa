// The lines of a text table that are not rows: names and units above the columns, and `key: value`.
// Pure; any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"

namespace asperity {

struct TextLine {
  std::string_view text;
  std::size_t number = 0;  // counted from 1
};

/// Returns the line without a mark of comments that may also be a word of a table: "-- text", "REM
/// text", "' text".
std::string_view withoutRemarkMark(std::string_view line);

/// Returns the line without the mark of a comment; a semicolon is one where it separates no fields.
std::string_view withoutCommentMark(std::string_view line, const TextDialect& dialect);

/// Returns the position of the ":" or "=" that ends a key; npos where there is none.
std::size_t keyEnd(std::string_view line);

/// Returns whether a text ends with a number and its unit, as "Load 30 N" does.
bool statesQuantity(std::string_view text);

/// Returns whether a word in front of the number of a key is its unit: "Width;mm;10". A letter may
/// be a name, "Sample;N;50", except where the key names its quantity: "Load;N;50".
bool isUnitInFront(std::string_view key, std::string_view unit);

/// Reads the key and the value of a line (text_entry.cpp).
TextEntry parseEntry(const TextLine& line, const TextDialect& dialect);

/// What stands before a unit in several languages: "v in m/s", "hauteur en \u00B5m".
inline constexpr WordList kBeforeUnits("in en em");

/// Separates the name of a column and its unit: "x (mm)", "z/um", "Height [\u00B5m]", "freq_Hz", "x
/// in mm", "x, mm", "x mm", "X_(microns)". In round brackets, after a slash, a blank or "_" only
/// a known unit counts; the text in square brackets at the end is always a unit.
TextColumn parseColumnName(std::string_view text);

/// Returns the quantity of numbers above the columns of a matrix with its unit: that in the corner,
/// "f (Hz) \ T (\u00B0C)", which leaves that of the rows; else the one that ends a line above the
/// matrix, "G' at T (\u00B0C)". One unit in the corner may have been taken for that of the whole.
/// isQuantity: whether a column has a unit of its quantity. Without a name where there is none.
TextColumn quantityOfHeads(TextColumn& corner, const std::vector<TextEntry>& header,
                           const std::function<bool(const TextColumn&)>& isQuantity);

/// Returns whether a line has the names of these columns, and nothing else but their units.
bool isLineOfNames(const TextEntry& entry, const std::vector<TextColumn>& columns);

/// Erases the lines of the names of these columns, where a table gets other columns: a state in a
/// name, "mu 5 N", is not one of all points.
void eraseLinesOfNames(std::vector<TextEntry>& header, const std::vector<TextColumn>& columns);

// ---- Lines of names (text_names.cpp)

/// Returns whether a line is empty, has separators alone or is drawn: ";;;", "-----", "*****",
/// "+---+---+".
bool isRule(std::string_view line);

/// Splits a line of names for `columns` columns. The names may be separated differently from the
/// numbers: the first separator that gives this number of names is used; none where there is no
/// such separator. A unit after a space stays with its name.
std::vector<std::string> splitNames(std::string_view line, const TextDialect& dialect,
                                    std::size_t columns);

/// Returns whether each field is a unit or empty, and at least one can be nothing else, as the
/// symbol of friction can; "1" is the unit of a pure number. Among several units one word may be no
/// unit, such as "bool" of a column of validity.
bool areUnits(const std::vector<std::string>& fields);

/// Returns the columns of a block with their names and units from the lines above it. first: the
/// fields of its first row.
std::vector<TextColumn> namedColumns(const std::vector<TextLine>& above, const TextDialect& dialect,
                                     const std::vector<Field>& first);

}  // namespace asperity
