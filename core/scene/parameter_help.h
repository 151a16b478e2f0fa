// The table of parameters as text for users: for --help and for the guide. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Returns one line for each key: key, allowed values, unit, default, sentence.
std::string parameterTableText();

/// Returns the text with a backslash before every character that is a mark of Markdown.
std::string escapedMarkdown(std::string_view text);

/// Returns the same as a definition list of pandoc's Markdown, in which surface.hurst has the
/// anchor key-surface-hurst.
std::string parameterListMarkdown();

}  // namespace asperity
