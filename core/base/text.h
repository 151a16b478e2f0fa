// Texts that a user wrote or a file holds: quoting them in printable characters, shortening them,
// naming the nearest known word, making file names of them. Pure; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// The text with every character that a terminal would obey, or that shows as something else than
/// it is, written out: line ends and tabs as \n, \r and \t, other control characters and bytes that
/// are no UTF-8 as \x1b, marks without a shape (directions of writing, zero width) as \u202e. What
/// is printable stays, so that a text quoted twice is the same.
std::string printable(std::string_view text);

/// At most this much of what a user wrote is said back.
std::string shortened(std::string_view text);

/// The known word nearest to `word` by edit distance; empty where none is as near as half of the
/// word's length.
std::string_view nearestOf(std::string_view word, std::span<const std::string_view> known);

/// Letters and digits of ASCII, '-' and '_' stay, every other byte becomes '_'; 60 at most. Empty
/// for an empty name.
std::string fileNameOf(std::string_view name);

}  // namespace asperity
