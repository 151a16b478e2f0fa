// The dialect of a text table: the separator of its fields, and whether a decimal mark is a point
// or a comma. It is found from the numbers themselves. Pure; any thread.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace asperity {

struct TextDialect {
  enum class Separator {
    Blanks,  // any run of spaces and tabs
    Tab,     // each tab: two in a row enclose an empty field
    Semicolon,
    Comma,
    Bar,         // "|"
    CommaBlank,  // "1,5, 2,5": only a comma with a blank after it separates
    CommaPair,   // "1,5,2,5": every second comma separates
  };

  Separator separator = Separator::Blanks;
  char decimal = '.';
  bool isUnclear = false;  // numbers such as "13.318" alone: the mark may separate thousands, too
  /// All numbers of a column are such as "1.000", while commas are decimal marks elsewhere.
  bool hasThousandsAlone = false;

  /// Returns whether two separators in a row enclose an empty field.
  bool isExact() const { return separator != Separator::Blanks; }
  bool operator==(const TextDialect&) const = default;
};

/// Returns the dialect in which most lines of the text are rows of equally many numbers. Of a long
/// text only some parts are examined. readsCells: whether numbers may have errors and units in
/// their cells.
TextDialect detectDialect(std::string_view text, bool readsCells = false);

/// Replaces `fields` by those of one line; separators within double quotes, which begin with the
/// field, do not count. The fields still have their blanks and quotes.
void splitFields(std::string_view line, TextDialect::Separator separator,
                 std::vector<std::string_view>& fields);
/// Returns the fields of one line.
inline std::vector<std::string_view> splitFields(std::string_view line,
                                                 TextDialect::Separator separator) {
  std::vector<std::string_view> fields;
  splitFields(line, separator, fields);
  return fields;
}
/// Returns the words between blanks; a quoted text is one word.
inline std::vector<std::string_view> splitWords(std::string_view line) {
  return splitFields(line, TextDialect::Separator::Blanks);
}

/// Replaces `fields` by those of a row of numbers and texts. Where blanks separate, the words of a
/// missing value are one field: "No Data", "out of range".
void splitTextRow(std::string_view line, const TextDialect& dialect,
                  std::vector<std::string_view>& fields);

/// Does so for a row of numbers. A comment at its end, a blank with "#" or "//" and what follows,
/// is left out where the fields in front of it are numbers alone.
void splitRow(std::string_view line, const TextDialect& dialect,
              std::vector<std::string_view>& fields);

/// Removes the first line with its end from the text, and returns it without the end and the blanks
/// there.
std::string_view takeLine(std::string_view& text);

/// Returns whether a line begins like a comment: '#', '%', "//", '!'.
bool isComment(std::string_view line);

/// Reads a row of exactly `numbers.size()` numbers without quotes, comments and words for missing
/// values: the fast way. Returns false where the line is anything else, for which splitRow and
/// readField are needed.
bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers);

}  // namespace asperity
