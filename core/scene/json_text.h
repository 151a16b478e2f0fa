// JSON that a user wrote: scenes and batches. Refuses what a parser would take in silence. Pure;
// any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace asperity {

/// Throws InputError with the place where the text is no JSON, where a key stands twice in one
/// object, and where objects and lists stand deeper in each other than `deepest`. wanted: the
/// sentence that says of a file of another kind what is needed instead.
nlohmann::ordered_json parseJson(std::string_view text, int deepest,
                                 std::string_view wanted = "JSON in UTF-8 is needed");

}  // namespace asperity
