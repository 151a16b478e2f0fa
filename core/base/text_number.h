// Fields of text tables: numbers as instruments, spreadsheets and people write them, the words for
// a missing value, and quantities with a unit. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// What stands in one field.
enum class FieldKind {
  Number,
  Missing,  // nothing, NaN, BAD, -, ***, an infinite value
  Flag,     // true, OK, invalid: 1 or 0
  Text,
};

struct Field {
  FieldKind kind = FieldKind::Text;
  double value = 0;        // NaN where it is missing; 0 for a text
  bool isGrouped = false;  // a number whose thousands are separated: "1.234,5", "1 234"
};

/// The field without blanks and quotes around it. `decimal` is '.' or ','; thousands may be
/// separated by the other one, an apostrophe or a blank.
Field readField(std::string_view text, char decimal);

/// "1.5", "+1.5e-06", "1.5D-3", "\u22121,5" all through; thousands are never separated. False where
/// it is anything else, or beyond the range of a double.
bool readTextNumber(std::string_view text, char decimal, double& number);

/// Blanks of every kind, and one pair of quotes, are taken from both ends.
std::string_view trimmedField(std::string_view text);

/// Blanks of every kind are taken from both ends.
std::string_view trimmedBlanks(std::string_view text);

/// Brackets around all of the text are taken away.
std::string_view withoutBrackets(std::string_view text);

/// Whether a field begins as a number does, be it one or a damaged one: "1.2.3", "5.1x".
bool beginsAsNumber(std::string_view field);

/// Whether it begins with what spreadsheets write into a cell without a value: "#N/A", "#DIV/0!".
bool beginsWithSpreadsheetError(std::string_view text);

/// In lower case, of ASCII alone.
std::string lowerCase(std::string_view text);

/// Whether the byte is a digit of ASCII.
constexpr bool isDigit(char letter) {
  return letter >= '0' && letter <= '9';
}

/// Replaces each `from`, which is not empty, by `to`.
void replaceAll(std::string& text, std::string_view from, std::string_view to);

struct TextQuantity {
  double number = 0;
  std::string unit{};  // what stands behind the number; may be empty
};

/// "10 \u00B5m", "1,25e-3 m", "512": a number with a point or a comma, and what follows it.
std::optional<TextQuantity> parseQuantity(std::string_view text);

}  // namespace asperity
