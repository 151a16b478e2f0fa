// Texts from a user or a file: quoting them in printable characters, shortening and splitting them,
// finding the nearest known word, making file names from them. Pure; any thread.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Returns the text with every character escaped that a terminal would interpret, or that is
/// displayed as something else: line ends and tabs as \n, \r and \t, other control characters and
/// bytes that are not UTF-8 as \x1b, invisible marks (directions of writing, zero width) as \u202e.
/// Printable characters are unchanged, so quoting twice has the same result.
std::string printable(std::string_view text);

/// Returns a user's text, shortened so that it can be quoted in a message.
std::string shortened(std::string_view text);

/// Returns the parts of a text between separators; where there is none, the text itself.
std::vector<std::string_view> splitText(std::string_view text, std::string_view separator);

/// Returns whether the word is one of these.
template <class Words = std::initializer_list<std::string_view>>
bool isOneOf(std::string_view word, const Words& words) {
  return std::ranges::find(words, word) != std::ranges::end(words);
}

/// Returns the known word nearest to `word` by edit distance; empty where the distance to all
/// exceeds half of the word's length.
std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known);

/// Returns a file name: letters and digits of ASCII, '-' and '_' stay, every other byte becomes
/// '_'; 60 bytes at most. Empty for an empty name.
std::string makeFileName(std::string_view name);

}  // namespace asperity
