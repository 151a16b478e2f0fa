// How a message quotes what a user wrote or a file holds. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// The text with every character that a terminal would obey, or that shows as something else than
/// it is, written out: line ends and tabs as \n, \r and \t, other control characters and bytes that
/// are no UTF-8 as \x1b, marks without a shape (directions of writing, zero width) as \u202e. What
/// is printable stays, so that a text quoted twice is the same.
std::string printable(std::string_view text);

}  // namespace asperity
