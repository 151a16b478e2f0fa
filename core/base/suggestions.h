// Words that a user wrote against those that are known: how a refusal says one back, lists the
// known ones, and names the nearest. Pure; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// At most this much of what a user wrote is said back.
std::string shortened(std::string_view text);

/// The known word nearest to `word` by edit distance; empty where none is as near as half of the
/// word's length.
std::string_view nearestOf(std::string_view word, std::span<const std::string_view> known);

/// "pink is not one of light, dark, print".
std::string notOneOf(std::string_view given, std::span<const std::string_view> known);

}  // namespace asperity
