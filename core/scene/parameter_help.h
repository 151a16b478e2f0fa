// The table of parameters as text for users: for --help and for the README. Pure functions.
#pragma once

#include <string>

namespace asperity {

/// Returns one line for each key: key, allowed values, unit, default, sentence.
std::string parameterTableText();

/// Returns the same as a Markdown table.
std::string parameterTableMarkdown();

}  // namespace asperity
