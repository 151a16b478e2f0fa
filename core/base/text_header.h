// The lines of a text table that are not rows: `key: value`, and names and units above the columns.
// Pure; any thread.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/text_number.h"
#include "core/base/text_table.h"

namespace asperity {

struct TextLine {
  std::string_view text;
  std::size_t number = 0;  // counted from 1
};

/// Returns the line without the mark of a comment; a semicolon is one where it separates no fields.
std::string_view withoutCommentMark(std::string_view line, const TextDialect& dialect);

/// Returns the position of the ":" or "=" that ends a key; npos where there is none.
std::size_t keyEnd(std::string_view line);

/// Reads the key and the value of a line.
TextEntry parseEntry(const TextLine& line, const TextDialect& dialect);

/// Returns the columns of a block with their names and units from the lines above it. first: the
/// fields of its first row.
std::vector<TextColumn> namedColumns(const std::vector<TextLine>& above, const TextDialect& dialect,
                                     const std::vector<Field>& first);

}  // namespace asperity
