// Reads fields of text tables: numbers as instruments, spreadsheets and people write them, the
// words for a missing value, quantities with a unit, and powers of ten in front of units. Pure; any
// thread.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// The content of a field.
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

/// Reads a field without the blanks and quotes around it. decimal: '.' or ','; thousands may be
/// separated by the other one, an apostrophe or a blank.
Field readField(std::string_view text, char decimal);

/// The bytes of numbers without separated thousands; the last three are those of the minus sign.
inline constexpr std::string_view kBytesOfNumbers = "0123456789+-.,eEdD\xE2\x88\x92";

/// Reads a whole text as a number without separated thousands: "1.5", "+1.5e-06", "1.5D-3",
/// "\u22121,5". Returns false where it is anything else, or beyond the range of a double.
bool readTextNumber(std::string_view text, char decimal, double& number);

/// Returns the text without blanks of every kind and one pair of quotes at both ends.
std::string_view trimmedField(std::string_view text);

/// Returns the text without blanks of every kind at both ends.
std::string_view trimmedBlanks(std::string_view text);

/// Returns the text without brackets around all of it.
std::string_view withoutBrackets(std::string_view text);

/// Returns whether a field is a date with a year of four digits, a time of day or both:
/// "2024-03-12 10:22:33.5", "12.03.2024", "10:22".
bool isDateOrTime(std::string_view field);

/// Returns whether a field begins like a number, valid or damaged: "1.2.3", "5.1x".
bool beginsAsNumber(std::string_view field);

/// Returns whether the text begins with the mark of spreadsheets for a missing value: "#N/A",
/// "#DIV/0!".
bool beginsWithSpreadsheetError(std::string_view text);

/// Returns the text with the letters of ASCII and of Russian in lower case.
std::string lowerCase(std::string_view text);

/// Returns whether the byte is a digit of ASCII.
constexpr bool isDigit(char letter) {
  return letter >= '0' && letter <= '9';
}

/// Returns whether the text is one or more digits, and nothing else.
constexpr bool areDigits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, isDigit);
}

/// Replaces each `from`, which is not empty, by `to`.
void replaceAll(std::string& text, std::string_view from, std::string_view to);

struct TextQuantity {
  double number = 0;
  std::string unit{};      // the text after the number; may be empty
  bool isGrouped = false;  // a number whose thousands are separated
};

/// Reads a number with a point or a comma and the unit after it: "10 \u00B5m", "1,25e-3 m", "512",
/// "minus 5 C". The sign may be any dash, with a blank after it. decimal: the decimal mark of the
/// file where it is known; the other mark, a blank or an apostrophe may then separate thousands.
std::optional<TextQuantity> parseQuantity(std::string_view text, std::optional<char> decimal = {});

/// A power of ten in front of a unit.
struct PowerOfTen {
  double value = 1;
  int exponent = 0;
  bool isWritten = false;  // as a power, "10^-3"; otherwise as a number, "100"
};

/// Reads a power of ten: "1e-6", "100", "1/100", "10^-6", "\u00D710\u207B\u2076", "x10-6"; empty
/// where the text is none.
std::optional<PowerOfTen> powerOfTenIn(std::string_view text);

/// Returns whether a text is a power of ten that is written as such: "10^-3", "1e-3".
bool isWrittenPower(std::string_view text);

/// A unit and the power of ten in front of it.
struct ScaledUnit {
  PowerOfTen power{};
  std::string_view unit{};
};

/// Reads "1e-6 m", "10^-9*m", "x 10^3 Pa s". Empty where there is no power of ten in front.
std::optional<ScaledUnit> scaledUnit(std::string_view text);

}  // namespace asperity
