// JSON that a user wrote: scenes and batches. Refuses what a parser would take in silence. Pure;
// any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

namespace asperity {

/// Throws InputError with the place where the text is no JSON, where a key stands twice in one
/// object or an object has more than 256 keys, and where objects and lists stand deeper in each
/// other than `deepest`. wanted: the sentence that says of a file of another kind what is needed
/// instead. The time grows with the text alone.
nlohmann::ordered_json parseJson(std::string_view text, int deepest,
                                 std::string_view wanted = "JSON in UTF-8 is needed");

/// What the outermost object holds under this name, without reading what follows it; null where it
/// holds nothing under it. `others`: gets the names that stand before it. Throws as parseJson.
nlohmann::ordered_json memberOf(std::string_view text, const std::string& name, int deepest,
                                std::set<std::string>* others = nullptr);

}  // namespace asperity
