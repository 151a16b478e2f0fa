// The lines of a text table as its rows: fields with line breaks, which spreadsheets write in
// quotes, stand in one line each, and every line has fields of which it is known what they are.
// Pure; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_cell.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"

namespace asperity {

/// A text whose quoted fields with line breaks, as spreadsheets write long names of columns, stand
/// in one line each.
struct JoinedText {
  std::string_view text{};            // of the text given, or of `joined`
  std::string joined{};               // where there are such fields
  std::vector<std::size_t> breaks{};  // positions in it at which a line of the file ended

  explicit JoinedText(std::string_view written);
  JoinedText(const JoinedText&) = delete;  // the text may be its own
  JoinedText& operator=(const JoinedText&) = delete;
};

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
