// What a line of text states in one or several clauses, "Master curve, Tref = 20 \u00B0C", and the
// words of a text. Pure; any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_number.h"
#include "core/base/text_table.h"

namespace asperity {

/// Returns an entry as a line, "key = value", or with another text between them; the value alone
/// where it has no key.
std::string joinEntry(const TextEntry& entry, std::string_view between = " = ");

/// Splits a line at semicolons, tabs, bars and commas before a blank.
std::vector<std::string_view> splitClauses(std::string_view line);

/// Splits a clause before each name in front of "=", and before a reference temperature: "C1 = 7.5
/// C2 = 120 K Tref 20 \u00B0C".
std::vector<std::string_view> splitStatements(std::string_view clause);

/// Returns the text without these signs at its end.
std::string_view withoutEnd(std::string_view text, std::string_view signs);

/// Returns the key in front of a value: "T" of "Isothermal test: T = ".
std::string_view keyBefore(std::string_view text);

/// A quantity after a key, as in "Young's modulus E0 (MPa) = 600" or "T_ref: 20 \u00B0C".
struct TextStatement {
  std::string key{};
  TextColumn name{};  // of the key, with its unit
  TextQuantity quantity{};

  /// Returns the unit of the number or, where it has none, that of the key.
  const std::string& unit() const { return quantity.unit.empty() ? name.unit : quantity.unit; }
};

/// Reads the last key of a clause and the quantity after it; nothing where there is none.
std::optional<TextStatement> parseStatement(std::string_view clause);

/// Returns the words of a text in lower case; "T_ref" is one of them.
std::vector<std::string> wordsIn(std::string_view text);

/// A word and the line in which it stands.
struct WordOfLine {
  std::string word{};
  std::size_t line = 0;
};

/// Returns the first unit of no number in the lines above and below a block, as in "v in mm/s" and
/// "Velocity unit: mm/s", or in a column of units, but not in "at 10 mm/s" nor in the names of the
/// columns. isUnit: whether a word is a unit that is meant.
std::optional<WordOfLine> unitOfNoNumber(const TextPart& in,
                                         const std::function<bool(const std::string&)>& isUnit);

/// Says that a column has no unit although such a line names one. name: of the column.
Message unitStandsElsewhere(const std::string& name, const WordOfLine& unit);

/// Returns whether a heading is that of the next of several profiles: "Profile 2" after "Profile
/// 1".
bool isNextProfile(std::string_view heading, std::string_view next);

/// Returns the letters and digits of a text in lower case, as one word.
std::string plainWord(std::string_view text);

}  // namespace asperity
