// Splits the lines above a table into clauses with a key: "Master curve, Tref = 20 °C" has two.
// Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"

namespace asperity {

using WordList = std::vector<std::string>;

/// Returns the words of a text in lower case; "T_ref" is one of them.
WordList wordsIn(std::string_view text);

/// Returns an entry as a line, "key = value", or with another text between them; the value alone
/// where it has no key.
std::string lineOf(const TextEntry& entry, std::string_view between = " = ");

/// Splits a line at semicolons, tabs and commas before a blank.
std::vector<std::string_view> clausesOf(std::string_view line);

/// Returns the text without these signs at its end.
std::string_view withoutEnd(std::string_view text, std::string_view signs);

/// Returns the key in front of a value: "T" of "Isothermal test: T = ".
std::string_view keyBefore(std::string_view text);

}  // namespace asperity
