// How the rows of a text table are written: what separates the fields, and whether a decimal mark
// is a point or a comma. Found from the numbers themselves. Pure; any thread.
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
    CommaBlank,  // "1,5, 2,5": only a comma with a blank behind it separates
    CommaPair,   // "1,5,2,5": every second comma separates
  };

  Separator separator = Separator::Blanks;
  char decimal = '.';
  bool isUnclear = false;  // numbers such as "13.318" alone: the mark may separate thousands, too

  /// Whether two separators in a row enclose an empty field.
  bool isExact() const { return separator != Separator::Blanks; }
  bool operator==(const TextDialect&) const = default;
};

/// What separates two fields; a blank where any run of blanks does.
char separatorCharacter(TextDialect::Separator separator);

/// The dialect in which most lines of the text are rows of equally many numbers. Looks at some
/// places of a long text alone.
TextDialect detectDialect(std::string_view text);

/// Replaces `fields` by those of one line; separators within double quotes, which begin with the
/// field, do not count. The fields still have their blanks and quotes.
void splitFields(std::string_view line, TextDialect::Separator separator,
                 std::vector<std::string_view>& fields);

/// Replaces `fields` by those of a row of numbers. A comment at its end, a blank with "#" or "//"
/// and what follows, is left out where the fields in front of it are numbers alone.
void splitRow(std::string_view line, const TextDialect& dialect,
              std::vector<std::string_view>& fields);

/// The first line of the text, without its end and the blanks there; takes it and its end away.
std::string_view takeLine(std::string_view& text);

/// Whether a line begins as a comment does: '#', '%', "//", '!'.
bool isComment(std::string_view line);

/// Reads a row of exactly `numbers.size()` numbers without quotes, comments and words for missing
/// values: the fast way. Returns false where the line is anything else, for which splitRow and
/// readField are needed.
bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers);

}  // namespace asperity
