// The table of parameters as text for people: for --help and for the README. Pure functions.
#pragma once

#include <string>

namespace asperity {

/// One line a key: key, what is allowed, unit, default, sentence.
std::string parameterTableText();

/// The same as a Markdown table.
std::string parameterTableMarkdown();

}  // namespace asperity
