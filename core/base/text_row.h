// A line of a text table as one of its rows: the fields, and what each of them is. Pure; any
// thread.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/text_cell.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"

namespace asperity {

struct TextRow {
  std::vector<std::string_view> fields{};  // of the line, with their blanks and quotes
  std::vector<Field> values{};             // of each field
  std::vector<TextCell> cells{};  // of each field; none where no field is more than a number

  std::size_t size() const { return fields.size(); }
  bool is(std::size_t i, FieldKind kind) const { return values[i].kind == kind; }
  /// Returns the number of fields of a kind.
  std::size_t count(FieldKind kind) const;
  /// Returns whether each field from `begin` up to `end` is a number.
  bool areNumbers(std::size_t begin, std::size_t end) const;
  /// Returns whether a field is a number with an error or a unit.
  bool isCell(std::size_t i) const { return i < cells.size() && !cells[i].text.empty(); }
  /// Removes the last field.
  void removeLast();
};

/// Reads lines as rows of a table with this dialect and these options, which must outlive it.
class RowReader {
 public:
  RowReader(const TextDialect& dialect, const TextTableOptions& options)
      : dialect_(dialect), options_(options) {}

  /// Returns the fields of a line; where labels are kept, "#" belongs to them.
  std::vector<std::string_view> split(std::string_view line) const;
  TextRow read(std::string_view line) const;

 private:
  /// Reads a field; rest: set where it is more than a number.
  Field readField(std::string_view text, TextCell& rest) const;

  const TextDialect& dialect_;
  const TextTableOptions& options_;
};

}  // namespace asperity
